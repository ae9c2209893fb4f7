// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/kinds/KindUi.h"

#include "tools/MeasureTool.h"
#include "window/CommandLines.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/FileFilters.h"
#include "window/kinds/SuggestedName.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

std::vector<std::unique_ptr<DocumentKind>> kindsOf(std::vector<KindEntry>& entries) {
  std::vector<std::unique_ptr<DocumentKind>> kinds;
  for (KindEntry& entry : entries) kinds.push_back(std::move(entry.kind));
  return kinds;
}

}  // namespace

ToolDescriptor measureToolDescriptor(std::function<std::unique_ptr<Tool>()> make) {
  return {QStringLiteral("measureTool"),
          KindUi::tr("&Measure"),
          KindUi::tr("Measure distances, angles and walls"),
          QStringLiteral("ruler"),
          QKeySequence(Qt::Key_M),
          std::move(make),
          "measure",
          MeasureTool::keys()};
}

KindSet::KindSet(std::vector<KindEntry> entries) : documents(kindsOf(entries)) {
  for (std::size_t i = 0; i < entries.size(); ++i) windows[documents.all()[i]->id()] = std::move(entries[i].window);
}

// For documents that are edited through their properties alone.
QString KindUi::saveCommand(const DocumentTab& open, const QString& path) const {
  if (!open.inFile) return {};
  const Document& document = open.document;
  const std::vector<Property> now = document.properties();
  // Added or removed properties do not count as changed values.
  const auto hasSameId = [](const Property& a, const Property& b) { return a.id == b.id; };
  if (!std::equal(now.begin(), now.end(), open.inFile->begin(), open.inFile->end(), hasSameId)) return {};
  if (document.file().path.empty()) return newCommand(document.kind().id(), *open.inFile, now, path);
  return setCommand(document.path(), *open.inFile, now, path);
}

std::vector<Property> KindUi::listedProperties(const Document& document) const {
  return document.properties();
}

// The container beside the file that it came from.
QString KindUi::suggestedName(const DocumentTab& document) const {
  const QString ending = containerEnding();
  const DocumentFile& of = document.document.file();
  // A title may have signs that are none of a file's.
  if (of.path.empty() && of.copyOf.empty()) return fileNameOf({document.document.sharedName()}, ending.mid(1));
  if (of.path.empty())
    return QFileInfo(QFile::decodeName(of.copyOf.c_str())).dir().filePath(document.document.sharedName() + ending);
  const QFileInfo file(document.document.path());
  if (!of.title.empty() || of.hasPrivateName)
    return file.path() + QLatin1Char('/') + fileNameOf({document.document.sharedName()}, ending.mid(1));
  const QString name = file.fileName().chopped(endingOf(document.document.kind(), document.document.path()).size());
  return file.path() + QLatin1Char('/') + name + ending;
}

}  // namespace handwheel
