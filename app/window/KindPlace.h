// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QList>

class QDockWidget;
class QLabel;
class QMenu;
class QStackedWidget;
class QToolBar;

namespace handwheel {

class KindUi;

// Where the window shows what the kind of the present document adds: panel, menu and tool bar.
class KindPlace {
 public:
  // dock: whose widget is the stack of the panels.
  KindPlace(QDockWidget& dock, QStackedWidget& panels, QMenu& menu, QToolBar& bar);

  // Null: no document is open.
  void show(KindUi* kind, const QList<QAction*>& tools);

 private:
  QDockWidget& m_dock;
  QStackedWidget& m_panels;
  QMenu& m_menu;
  QToolBar& m_bar;
  QLabel* m_empty;
};

// Names the buttons of a tool bar after their actions, for screen readers and tests. Actions of high priority show
// their text.
void nameButtons(QToolBar& bar);

}  // namespace handwheel
