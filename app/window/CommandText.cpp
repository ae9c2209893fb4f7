// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/CommandText.h"

#include "text/RepairText.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

namespace handwheel {

namespace {

QString quoted(const QString& word) {
  static const QRegularExpression plain(QStringLiteral("^[A-Za-z0-9_@%+=:,./-]+$"));
  if (plain.match(word).hasMatch()) return word;
  QString inner = word;
  return QLatin1Char('\'') + inner.replace(QLatin1Char('\''), QLatin1String("'\\''")) + QLatin1Char('\'');
}

QString fileName(const QString& path) {
  return quoted(QFileInfo(path).fileName());
}

}  // namespace

QString inspectCommand(const QString& path) {
  return QStringLiteral("handwheel inspect ") + fileName(path);
}

QString repairCommand(const QString& path, const RepairOptions& options) {
  QString command = QStringLiteral("handwheel repair %1 -o %2 --fill %3")
                        .arg(fileName(path), fileName(repairedName(path)), fillMethodWord(options.fill.method));
  if (options.keepOpen.empty()) return command;
  QStringList ids;
  for (int id : options.keepOpen) ids << QString::number(id);
  return command + QStringLiteral(" --keep-open ") + ids.join(QLatin1Char(','));
}

QString convertCommand(const QString& from, const QString& to) {
  return QStringLiteral("handwheel convert %1 %2").arg(fileName(from), fileName(to));
}

QString repairedName(const QString& path) {
  const QFileInfo file(path);
  const QString suffix = file.suffix().isEmpty() ? QStringLiteral("stl") : file.suffix();
  const QString base = file.completeBaseName();
  const QString tag = QStringLiteral("-repaired");
  return file.dir().filePath((base.endsWith(tag) ? base : base + tag) + QLatin1Char('.') + suffix);
}

}  // namespace handwheel
