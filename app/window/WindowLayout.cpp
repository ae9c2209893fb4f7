// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/WindowLayout.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QScreen>
#include <QSettings>

namespace handwheel {

namespace {

const auto kGeometryKey = QStringLiteral("window/geometry");
const auto kStateKey = QStringLiteral("window/state");
constexpr int kStateVersion = 1;  // grows when docks or bars are renamed
constexpr QSize kUsualSize(1440, 900);
constexpr int kRoomForLeftPanels = 1600;  // pixels of window width

}  // namespace

void restoreLayout(QMainWindow& window, const QList<QDockWidget*>& foldable) {
  const QSettings settings;
  if (!window.restoreGeometry(settings.value(kGeometryKey).toByteArray())) {
    const QSize room = window.screen()->availableSize();
    window.resize(kUsualSize.boundedTo(room));
    // The frame takes some of the room as well.
    if (kUsualSize.boundedTo(room) != kUsualSize) window.setWindowState(Qt::WindowMaximized);
  }
  if (window.restoreState(settings.value(kStateKey).toByteArray(), kStateVersion)) return;
  for (QDockWidget* dock : foldable) {
    const bool log = dock == foldable.last();
    dock->setVisible(!log && window.width() >= kRoomForLeftPanels);
  }
}

void saveLayout(const QMainWindow& window) {
  QSettings settings;
  settings.setValue(kGeometryKey, window.saveGeometry());
  settings.setValue(kStateKey, window.saveState(kStateVersion));
}

}  // namespace handwheel
