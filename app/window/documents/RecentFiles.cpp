// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/documents/RecentFiles.h"

#include <QFileInfo>
#include <QSettings>

namespace handwheel {

namespace {
const auto kRecentKey = QStringLiteral("recentFiles");
constexpr int kMost = 10;
}  // namespace

RecentFiles::RecentFiles(QObject* parent) : QObject(parent), m_paths(QSettings().value(kRecentKey).toStringList()) {}

void RecentFiles::add(const QString& path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  m_paths.removeAll(absolute);
  m_paths.prepend(absolute);
  m_paths = m_paths.mid(0, kMost);
  store();
}

void RecentFiles::remove(const QString& path) {
  if (m_paths.removeAll(QFileInfo(path).absoluteFilePath()) > 0) store();
}

void RecentFiles::clear() {
  m_paths.clear();
  store();
}

void RecentFiles::store() {
  QSettings().setValue(kRecentKey, m_paths);
  emit changed();
}

}  // namespace handwheel
