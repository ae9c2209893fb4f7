// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QDockWidget;
class QToolButton;

namespace handwheel {

// The title bar of a dock widget. It shows the name of the dock widget and two buttons, which float and hide the dock.
// Dragging the title bar moves the dock, and a double click floats or docks it. A floating dock keeps its title bar.
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
