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

// Adds menus, panels and tool bars of the kinds of documents to the window. Each kind has a menu, which is visible
// while a document of that kind is current. All kinds share the panel dock and the tool bar.
class KindMenus {
 public:
  // dock: the dock that contains the stack of the panels.
  KindMenus(QDockWidget& dock, QStackedWidget& panels, QToolBar& bar);

  // before: the menu that follows the new one.
  void add(const std::string& id, KindUi& kind, const QList<QAction*>& tools, QMenuBar& menus, QMenu& before);
  // kind: the kind of the current document; null: no document is open.
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
