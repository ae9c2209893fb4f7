// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/program/ProgramFile.h"

#include "base/Utf8.h"
#include "document/AtomicFile.h"
#include "document/FileBytes.h"

#include <QFileInfo>
#include <QStringList>
#include <algorithm>

namespace handwheel {

namespace {

const QStringList& programEndings() {
  static const QStringList endings{QStringLiteral("ngc"), QStringLiteral("nc"), QStringLiteral("tap"),
                                   QStringLiteral("txt")};
  return endings;
}

}  // namespace

Result<ProgramFile> readProgramFile(const std::filesystem::path& path, Progress progress) {
  const auto named = [&path](Error error) {
    error.subject = path.string();
    return error;
  };
  // One byte more than it may have: a larger file is never read whole.
  const Result<std::string> bytes = readFileHead(path, kMostProgramBytes + 1);
  if (!bytes) return named(bytes.error());
  if (bytes->size() > kMostProgramBytes)
    return named({ErrorCode::FileTooLarge, {"bytes", "", std::to_string(kMostProgramBytes)}, {}, {}});
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  ProgramFile file;
  file.isLatin = !isUtf8(*bytes);
  const auto size = static_cast<qsizetype>(bytes->size());
  file.text = file.isLatin ? QString::fromLatin1(bytes->data(), size) : QString::fromUtf8(bytes->data(), size);
  file.hasReturns = file.text.contains(QStringLiteral("\r\n"));
  file.text.replace(QStringLiteral("\r\n"), QStringLiteral("\n"));
  file.text.replace(QChar(u'\0'), QChar(u' '));
  return file;
}

Status writeProgramFile(const std::filesystem::path& path, const ProgramFile& file, Progress progress) {
  QString text = file.text;
  if (file.hasReturns) text.replace(QStringLiteral("\n"), QStringLiteral("\r\n"));
  const bool fitsLatin = std::all_of(text.cbegin(), text.cend(), [](QChar c) { return c.unicode() < 256; });
  const QByteArray bytes = file.isLatin && fitsLatin ? text.toLatin1() : text.toUtf8();
  return writeFileAtomically(path, {bytes.constData(), static_cast<std::size_t>(bytes.size())}, progress);
}

bool isProgramName(const QString& path) {
  return programEndings().contains(QFileInfo(path).suffix().toLower());
}

QString programNameFilter() {
  QStringList patterns;
  for (const QString& ending : programEndings()) patterns << QStringLiteral("*.") + ending;
  return patterns.join(QLatin1Char(' '));
}

}  // namespace handwheel
