// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QList>
#include <map>
#include <string>

class QDockWidget;
class QLabel;
class QMenu;
class QMenuBar;
class QStackedWidget;
class QToolBar;

namespace handwheel {

class KindUi;

// Where the window shows what the kinds of documents add: each has a menu, which is seen as long as such a document is
// the present one; panel and tool bar they share.
class KindPlace {
 public:
  // dock: whose widget is the stack of the panels.
  KindPlace(QDockWidget& dock, QStackedWidget& panels, QToolBar& bar);

  // before: the place of the menu.
  void add(const std::string& id, KindUi& kind, const QList<QAction*>& tools, QMenuBar& menus, QMenu& before);
  // Null: no document is open.
  void show(KindUi* kind);

 private:
  QDockWidget& m_dock;
  QStackedWidget& m_panels;
  QToolBar& m_bar;
  QLabel* m_empty;
  std::map<const KindUi*, QMenu*> m_menus;
  std::map<const KindUi*, QList<QAction*>> m_tools;
};

// Names the buttons of a tool bar after their actions, for screen readers and tests. Actions of high priority show
// their text.
void nameButtons(QToolBar& bar);

}  // namespace handwheel
