// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QDockWidget;
class QToolButton;

namespace handwheel {

// The title of a dock: its name and two buttons, which take it out of the window and fold it away. The dock is dragged
// by it; a double click takes it out or puts it back. A dock that floats keeps it.
class DockTitle : public QFrame {
  Q_OBJECT

 public:
  explicit DockTitle(QDockWidget* dock);

 private:
  void showState();

  QDockWidget* m_dock;
  QToolButton* m_float;
  QToolButton* m_fold;
};

}  // namespace handwheel
