// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/kinds/KindPanel.h"

#include <QDockWidget>

namespace handwheel {

void raiseKindPanel(const WindowContext& window) {
  auto* const dock = window.window->findChild<QDockWidget*>(QStringLiteral("kindDock"));
  if (dock && !dock->isHidden()) dock->raise();
}

}  // namespace handwheel
