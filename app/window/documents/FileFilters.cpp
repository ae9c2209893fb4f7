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

// An ending may have several dots: ".exercise.json".
std::optional<FileFormat> formatOf(const DocumentKind& kind, const QString& path) {
  const std::string name = QFileInfo(path).fileName().toLower().toStdString();
  for (const FileFormat& format : kind.formats()) {
    const auto isOfName = [&](const std::string& ending) { return name.ends_with(ending); };
    if (std::any_of(format.endings.begin(), format.endings.end(), isOfName)) return format;
  }
  return {};
}

QString endingOf(const DocumentKind& kind, const QString& path) {
  const QString name = QFileInfo(path).fileName();
  const auto format = formatOf(kind, path);
  for (const std::string& each : format ? format->endings : std::vector<std::string>()) {
    const QString ending = QString::fromStdString(each);
    if (name.endsWith(ending, Qt::CaseInsensitive)) return name.right(ending.size());
  }
  const QString suffix = QFileInfo(path).suffix();
  return suffix.isEmpty() ? QString() : QLatin1Char('.') + suffix;
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

QStringList openFilters(const DocumentKinds& kinds, const QStringList& beside) {
  QStringList all{containerPattern()}, lines;
  for (const auto& kind : kinds.all()) {
    QStringList own;
    for (const FileFormat& format : kind->formats()) {
      if (format.reads) own << patterns(format);
    }
    all << own;
    if (!own.isEmpty()) lines << titled(QCoreApplication::translate("DocumentKind", kind->title().c_str()), own);
  }
  for (const QString& filter : beside) {
    all << filter.section(QLatin1Char('('), 1).chopped(1);
    lines << filter;
  }
  lines.prepend(titled(FileFiltersWords::tr("All supported files"), all));
  return lines << titled(FileFiltersWords::tr("All files"), {QStringLiteral("*")});
}

QString renamedFor(const DocumentKind& kind, const QString& name, const QString& filter) {
  const qsizetype from = filter.lastIndexOf(QLatin1Char('(')) + 1;
  QStringList endings = filter.mid(from, filter.lastIndexOf(QLatin1Char(')')) - from).split(QLatin1Char(' '));
  for (QString& each : endings) each.remove(QLatin1Char('*'));
  const auto hasEnding = [&](const QString& ending) { return name.endsWith(ending, Qt::CaseInsensitive); };
  if (name.isEmpty() || endings.first().isEmpty() || std::any_of(endings.begin(), endings.end(), hasEnding))
    return name;
  const bool isKnown = isContainerName(QFile::encodeName(name).toStdString()) || formatOf(kind, name);
  return (isKnown ? name.chopped(endingOf(kind, name).size()) : name) + endings.first();
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
