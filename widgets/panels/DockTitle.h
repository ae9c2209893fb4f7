// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QDockWidget;

namespace handwheel {

// The title of a dock: its name in small letters and a button that folds it away. The dock is dragged by it.
class DockTitle : public QFrame {
  Q_OBJECT

 public:
  explicit DockTitle(QDockWidget* dock);
};

}  // namespace handwheel
