// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>

class QDockWidget;

namespace handwheel {

// An action that shows or hides a dock panel. It raises the dock above those tabbed with it, and hides it if it is
// already visible. It is checked while the dock is visible. Qt's QDockWidget::toggleViewAction() would hide a dock that
// lies behind another.
class PanelToggle : public QAction {
  Q_OBJECT

 public:
  // The action is a child of the dock and named after it.
  PanelToggle(QDockWidget* dock, const QString& iconName);
};

}  // namespace handwheel
