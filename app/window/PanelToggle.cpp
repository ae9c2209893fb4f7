// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/PanelToggle.h"

#include "theme/Icons.h"

#include <QDockWidget>

namespace handwheel {

PanelToggle::PanelToggle(QDockWidget* dock, const QString& iconName)
    : QAction(handwheel::icon(iconName), dock->windowTitle(), dock) {
  setObjectName(dock->objectName() + QStringLiteral("Toggle"));
  setCheckable(true);
  setIconVisibleInMenu(false);
  connect(dock, &QDockWidget::windowTitleChanged, this, &QAction::setText);
  connect(dock, &QDockWidget::visibilityChanged, this, &QAction::setChecked);
  connect(this, &QAction::triggered, dock, [dock](bool show) {
    dock->setVisible(show);
    if (show) dock->raise();
  });
}

}  // namespace handwheel
