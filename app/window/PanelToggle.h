// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>

class QDockWidget;

namespace handwheel {

// Shows a panel, in front of those that it shares its place with, or folds it away when it is seen already. Checked
// while it is seen. Qt's own action of a dock would fold away a panel that lies behind another.
class PanelToggle : public QAction {
  Q_OBJECT

 public:
  // A child of the dock, named after it.
  PanelToggle(QDockWidget* dock, const QString& iconName);
};

}  // namespace handwheel
