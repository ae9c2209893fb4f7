// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/CommandLines.h"

#include "base/NumberText.h"
#include "document/formats/MeshExport.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <map>
#include <string_view>

namespace handwheel {

namespace {

QString quoted(const QString& word) {
  static const QRegularExpression plain(QStringLiteral("^[A-Za-z0-9_@%+=:,./-]+$"));
  if (plain.match(word).hasMatch()) return word;
  QString inner = word;
  return QLatin1Char('\'') + inner.replace(QLatin1Char('\''), QLatin1String("'\\''")) + QLatin1Char('\'');
}

QString file(const QString& path) {
  return quoted(QDir::toNativeSeparators(QFileInfo(path).absoluteFilePath()));
}

QString valueText(const Property& property) {
  if (const auto* text = std::get_if<std::string>(&property.value)) return QString::fromStdString(*text);
  if (const auto* on = std::get_if<bool>(&property.value)) return *on ? QStringLiteral("yes") : QStringLiteral("no");
  const double number = std::get<double>(property.value);
  if (!property.choices.empty()) return QString::fromStdString(property.choices.at(static_cast<std::size_t>(number)));
  const bool angle = property.quantity == Quantity::Angle;
  const QString digits = QString::fromStdString(shortestText(angle ? number / kRadiansPerDegree : number));
  if (property.quantity == Quantity::Number) return digits;
  return digits + (angle ? QStringLiteral("deg") : QStringLiteral("mm"));
}

// " diameter=25mm length=50mm"
QString assignments(const std::vector<Property>& before, const std::vector<Property>& now) {
  QString words;
  std::map<std::string_view, const PropertyValue*> values;
  for (const Property& property : before) values[property.id] = &property.value;
  for (const Property& property : now) {
    const auto known = values.find(property.id);
    if (!property.editable || (known != values.end() && *known->second == property.value)) continue;
    words += QLatin1Char(' ') + quoted(QString::fromStdString(property.id) + QLatin1Char('=') + valueText(property));
  }
  return words;
}

}  // namespace

QString inspectCommand(const QString& path, const ReadOptions& options) {
  return QStringLiteral("handwheel inspect ") + file(path) +
         (options.partial ? QStringLiteral(" --partial") : QString());
}

QString compareCommand(const QString& mesh, const QString& scan) {
  return QStringLiteral("handwheel compare %1 %2").arg(file(mesh), file(scan));
}

QString convertCommand(const QString& from, const QString& to) {
  return QStringLiteral("handwheel convert %1 %2").arg(file(from), file(to));
}

QString setCommand(const QString& from, const std::vector<Property>& before, const std::vector<Property>& now,
                   const QString& to) {
  const QString words = assignments(before, now);
  if (words.isEmpty()) return file(from) == file(to) ? QString() : convertCommand(from, to);
  return QStringLiteral("handwheel set ") + file(from) + words + QStringLiteral(" -o ") + file(to);
}

QString newCommand(const std::string& kind, const std::vector<Property>& before, const std::vector<Property>& now,
                   const QString& to) {
  return QStringLiteral("handwheel new ") + QString::fromStdString(kind) + assignments(before, now) +
         QStringLiteral(" -o ") + file(to);
}

QString editCommandLine(const QString& from, const std::vector<std::string>& steps, const QString& to) {
  QString command = QStringLiteral("handwheel edit ") + file(from);
  for (const std::string& step : steps) command += QLatin1Char(' ') + stepWord(step);
  return command + QStringLiteral(" -o ") + file(to);
}

QString editCommandLine(const QString& from, const QString& stepsFile, const QString& to) {
  return QStringLiteral("handwheel edit %1 --steps %2 -o %3").arg(file(from), file(stepsFile), file(to));
}

QString ownCommand(const QString& from, const std::string& step, const QString& to) {
  const QString words = QString::fromStdString(step);
  const QString verb = words.section(QLatin1Char(' '), 0, 0);
  return QStringLiteral("handwheel %1 %2 -o %3%4").arg(verb, file(from), file(to), words.mid(verb.size()));
}

QString stepWord(const std::string& step) {
  return quoted(QString::fromStdString(step));
}

QString splitCommand(const QString& from, const QString& folder) {
  return QStringLiteral("handwheel split %1 -o %2").arg(file(from), file(folder));
}

namespace {

// One that keeps all digits stands in for a format that is only read.
QString writtenSuffix(const QFileInfo& file) {
  if (file.suffix().isEmpty()) return QStringLiteral("stl");
  const std::string name = file.fileName().toStdString();
  return formatForName(name) && !formatForOutput(name) ? QStringLiteral("ply") : file.suffix();
}

QString taggedName(const QString& path, const QString& tag) {
  const QFileInfo file(path);
  const QString suffix = writtenSuffix(file);
  const QString base = file.completeBaseName();
  return file.dir().filePath((base.endsWith(tag) ? base : base + tag) + QLatin1Char('.') + suffix);
}

}  // namespace

QString editedName(const QString& path) {
  return taggedName(path, QStringLiteral("-edited"));
}

QString repairedName(const QString& path) {
  return taggedName(path, QStringLiteral("-repaired"));
}

}  // namespace handwheel
