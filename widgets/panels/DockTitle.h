// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QDockWidget;
class QToolButton;

namespace handwheel {

// The title bar of a dock widget. It has its name and two buttons, which float and hide the dock. The dock is dragged
// by it; a double click floats it or docks it again. A floating dock keeps it.
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
