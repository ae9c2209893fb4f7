// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/CommandText.h"

#include "base/NumberText.h"
#include "mesh/measure/MeshFidelity.h"
#include "text/RepairText.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <algorithm>

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
  for (const Property& property : now) {
    const auto same = [&](const Property& other) { return other.id == property.id && other.value == property.value; };
    if (!property.editable || std::any_of(before.begin(), before.end(), same)) continue;
    words += QLatin1Char(' ') + quoted(QString::fromStdString(property.id) + QLatin1Char('=') + valueText(property));
  }
  return words;
}

// " --fidelity mesh.near_weld=0.0001", with the values that are not the defaults. The method has an option of its own.
QString fidelityOption(const RepairOptions& options) {
  QStringList values;
  const auto add = [&values](const FidelitySetting& setting, double value) {
    if (value != setting.standard) values << QString::fromStdString(setting.id + '=' + textOf(setting, value));
  };
  add(nearWeldSetting(), options.nearWeld);
  add(fillContinuitySetting(), static_cast<double>(options.fill.continuity));
  add(patchDensitySetting(), options.fill.density);
  add(pieceEdgesSetting(), static_cast<double>(options.fill.pieceEdges));
  return values.isEmpty() ? QString() : QStringLiteral(" --fidelity ") + values.join(QLatin1Char(','));
}

}  // namespace

QString inspectCommand(const QString& path, const ReadOptions& options) {
  return QStringLiteral("handwheel inspect ") + file(path) +
         (options.partial ? QStringLiteral(" --partial") : QString());
}

QString repairCommand(const QString& path, const RepairOptions& options) {
  QString command = QStringLiteral("handwheel repair %1 -o %2 --fill %3")
                        .arg(file(path), file(repairedName(path)), fillMethodWord(options.fill.method)) +
                    (options.rims == RimHandling::Keep ? QStringLiteral(" --rims keep") : QString()) +
                    fidelityOption(options);
  if (options.keepOpen.empty()) return command;
  QStringList ids;
  for (int id : options.keepOpen) ids << QString::number(id);
  return command + QStringLiteral(" --keep-open ") + ids.join(QLatin1Char(','));
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

QString taggedName(const QString& path, const QString& tag) {
  const QFileInfo file(path);
  const QString suffix = file.suffix().isEmpty() ? QStringLiteral("stl") : file.suffix();
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
