// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/documents/FileFilters.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <algorithm>

namespace handwheel {

namespace {

struct FileFiltersWords {
  Q_DECLARE_TR_FUNCTIONS(FileFilters)
};

QString patterns(const FileFormat& format) {
  QStringList all;
  for (const std::string& ending : format.endings) all << QLatin1Char('*') + QString::fromStdString(ending);
  return all.join(QLatin1Char(' '));
}

QString containerPattern() {
  return QLatin1Char('*') + containerEnding();
}

QString titled(const QString& title, const QStringList& patterns) {
  return QStringLiteral("%1 (%2)").arg(title, patterns.join(QLatin1Char(' ')));
}

}  // namespace

QString containerEnding() {
  return QString::fromUtf8(kContainerEnding.data(), static_cast<qsizetype>(kContainerEnding.size()));
}

std::optional<FileFormat> formatOf(const DocumentKind& kind, const QString& path) {
  const std::string ending = ('.' + QFileInfo(path).suffix().toLower()).toStdString();
  for (const FileFormat& format : kind.formats()) {
    if (std::find(format.endings.begin(), format.endings.end(), ending) != format.endings.end()) return format;
  }
  return {};
}

bool canWrite(const DocumentKind& kind, const QString& path) {
  if (isContainerName(QFile::encodeName(path).toStdString())) return true;
  const auto format = formatOf(kind, path);
  return format && format->writes;
}

QString iconNameFor(const DocumentKinds& kinds, const QString& path) {
  if (isContainerName(QFile::encodeName(path).toStdString())) return QStringLiteral("handwheel");
  for (bool FileFormat::*does : {&FileFormat::reads, &FileFormat::writes}) {
    for (const auto& kind : kinds.all()) {
      const auto format = formatOf(*kind, path);
      if (format && (*format).*does) return QStringLiteral("kind-") + QString::fromStdString(kind->id());
    }
  }
  return QStringLiteral("file");
}

QStringList openFilters(const DocumentKinds& kinds) {
  QStringList all{containerPattern()}, lines;
  for (const auto& kind : kinds.all()) {
    QStringList own;
    for (const FileFormat& format : kind->formats()) {
      if (format.reads) own << patterns(format);
    }
    all << own;
    if (!own.isEmpty()) lines << titled(QCoreApplication::translate("DocumentKind", kind->title().c_str()), own);
  }
  lines.prepend(titled(FileFiltersWords::tr("All supported files"), all));
  return lines << titled(FileFiltersWords::tr("All files"), {QStringLiteral("*")});
}

QStringList saveFilters(const DocumentKind& kind) {
  QStringList all{containerPattern()}, lines{titled(FileFiltersWords::tr("Handwheel documents"), all)};
  for (const FileFormat& format : kind.formats()) {
    if (!format.writes) continue;
    all << patterns(format);
    lines << titled(QString::fromStdString(format.name), {patterns(format)});
  }
  lines.prepend(titled(FileFiltersWords::tr("All formats"), all));
  return lines << titled(FileFiltersWords::tr("All files"), {QStringLiteral("*")});
}

}  // namespace handwheel
