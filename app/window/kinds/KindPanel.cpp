// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/kinds/KindPanel.h"

#include <QDockWidget>

namespace handwheel {

namespace {

QDockWidget* kindDockOf(const WindowContext& window) {
  return window.window->findChild<QDockWidget*>(QStringLiteral("kindDock"));
}

}  // namespace

void raiseKindPanel(const WindowContext& window) {
  QDockWidget* const dock = kindDockOf(window);
  if (dock && !dock->isHidden()) dock->raise();
}

void showKindPanel(const WindowContext& window) {
  QDockWidget* const dock = kindDockOf(window);
  if (!dock) return;
  dock->show();
  dock->raise();
}

}  // namespace handwheel
