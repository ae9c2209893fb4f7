// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/ErrorText.h"

#include "text/ErrorWords.h"

#include <QCoreApplication>
#include <span>

namespace handwheel {

namespace {

struct ErrorWords {
  Q_DECLARE_TR_FUNCTIONS(ErrorText)
};

// Replaces control characters, which a terminal would obey, and line ends.
QString harmless(const std::string& bytes) {
  QString text = QString::fromStdString(bytes);
  for (QChar& c : text) {
    if (!c.isPrint() && !c.isSurrogate()) c = QChar::ReplacementCharacter;
  }
  return text;
}

// Joins the parts to a list: "scan.stl, line 7".
QString listed(const QStringList& parts) {
  QString list = parts.value(0);
  for (const QString& part : parts.mid(1)) list = ErrorWords::tr("%1, %2").arg(list, part);
  return list;
}

// Formats alternatives as ".stl, .ply or .obj".
QString alternatives(QStringList all) {
  if (all.size() < 2) return listed(all);
  const QString last = all.takeLast();
  return ErrorWords::tr("%1 or %2").arg(listed(all), last);
}

// Returns the arguments for display.
QStringList argumentsOf(const Error& error) {
  QStringList all;
  for (const std::string& each : error.arguments) all << errorArgument(harmless(each).simplified());
  if (const auto first = static_cast<qsizetype>(error.code->alternatives.value_or(all.size())); first < all.size())
    all = all.first(first) << alternatives(all.sliced(first));
  return all;
}

// A text with inserted arguments.
struct FilledText {
  QString text;
  bool isWhole = true;  // all of them are known
};

FilledText filled(const char* english, const QStringList& arguments) {
  const QString text = QCoreApplication::translate("ErrorText", english);
  FilledText result;
  for (qsizetype i = 0; i < text.size(); ++i) {
    if (text[i] != '%' || i + 1 == text.size() || !text[i + 1].isDigit()) {
      result.text += text[i];
      continue;
    }
    const QString argument = arguments.value(text[++i].digitValue() - 1);
    result.text += argument;
    result.isWhole = result.isWhole && !argument.isEmpty();
  }
  return result;
}

// Returns the first of the texts whose arguments are all known, or else the last.
QString firstWhole(std::span<const char* const> texts, const QStringList& arguments) {
  FilledText last;
  for (const char* text : texts) {
    if (!text) break;
    last = filled(text, arguments);
    if (last.isWhole) break;
  }
  return last.text;
}

QString where(const Error& error) {
  const QString number = QString::number(error.position.value);
  switch (error.position.kind) {
    case InputPosition::Kind::None:
      return {};
    case InputPosition::Kind::Byte:
      return ErrorWords::tr("byte %1").arg(number);
    case InputPosition::Kind::Line:
      if (error.position.value == 0) return {};  // no line
      return ErrorWords::tr("line %1").arg(number);
  }
  return {};
}

}  // namespace

QString errorSentence(const Error& error) {
  QStringList origin;
  if (!error.subject.empty()) origin << harmless(error.subject);
  if (const QString position = where(error); !position.isEmpty()) origin << position;
  QString sentence = ErrorWords::tr("%1.").arg(firstWhole(error.code->sentences, argumentsOf(error)));
  if (!origin.isEmpty()) sentence = ErrorWords::tr("%1: %2").arg(listed(origin), sentence);
  // File names are left as they are.
  return error.subject.empty() ? sentence.left(1).toUpper() + sentence.mid(1) : sentence;
}

QString errorAdvice(const Error& error) {
  return firstWhole(error.code->advice, argumentsOf(error));
}

}  // namespace handwheel
