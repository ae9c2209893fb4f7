// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "document/FileBytes.h"
#include "document/recovery/OrphanedAutosaves.h"
#include "document/recovery/Recovery.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

namespace handwheel::test {

inline std::filesystem::path rootIn(const QTemporaryDir& folder) {
  return std::filesystem::path(folder.path().toStdString()) / "recovery";
}

inline std::string containerOf(const std::string& text) {
  Container container;
  container.blobs["note"] = text;
  return *writeContainer(container, Compression::None);
}

inline const AutosaveInfo kInfo{"id-1", "/parts/caf\xe9/a.handwheel", "a.handwheel", "mesh"};

inline std::string contentOf(const OrphanedAutosave& leftover) {
  const auto bytes = readFileBytes(leftover.file);
  if (!bytes) return "unreadable";
  const auto read = readContainer(*bytes);
  return read && read->damage.empty() ? read->container.blobs.at("note") : "damaged";
}

// Returns the contents of the autosaves that the next start of the program would find.
inline std::vector<std::string> contentsIn(const std::filesystem::path& root) {
  std::vector<std::string> contents;
  const OrphanedAutosaves leftovers(root);
  for (const OrphanedAutosave& leftover : leftovers.found()) contents.push_back(contentOf(leftover));
  std::sort(contents.begin(), contents.end());
  return contents;
}

using Strings = std::vector<std::string>;

inline void put(const std::filesystem::path& path, const QByteArray& bytes) {
  QFile file(QFile::decodeName(path.c_str()));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(bytes);
}

}  // namespace handwheel::test
