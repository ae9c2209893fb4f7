// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/kinds/KindMenus.h"

#include "controls/ActionText.h"
#include "theme/Icons.h"
#include "window/PanelToggle.h"
#include "window/kinds/KindUi.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QStackedWidget>
#include <QToolBar>
#include <QToolButton>

namespace handwheel {

namespace {

struct KindMenuWords {
  Q_DECLARE_TR_FUNCTIONS(KindMenus)
};

// With a line between the two, where there is something to part.
template <class Bar>
void fill(Bar& bar, const QList<QAction*>& tools, const QList<QAction*>& others) {
  bar.addActions(tools);
  if (!tools.isEmpty() && !others.isEmpty()) bar.addSeparator();
  bar.addActions(others);
}

}  // namespace

KindMenus::KindMenus(QDockWidget& dock, QStackedWidget& panels, QToolBar& bar)
    : m_dock(dock),
      m_panels(panels),
      m_bar(bar),
      m_empty(new QLabel(KindMenuWords::tr("No document is open."), &panels)) {
  m_empty->setProperty("muted", true);
  m_empty->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  m_empty->setContentsMargins(12, 12, 12, 12);
  m_panels.addWidget(m_empty);
}

void KindMenus::add(const std::string& id, KindUi& kind, const QList<QAction*>& tools, QMenuBar& menus, QMenu& before) {
  auto* menu = new QMenu(kind.menuTitle(), &menus);
  menu->setObjectName(QStringLiteral("kindMenu/") + QString::fromStdString(id));
  fill(*menu, tools, kind.menu());
  menus.insertMenu(before.menuAction(), menu);
  m_menus[&kind] = menu;
  m_tools[&kind] = tools;
}

void KindMenus::show(KindUi* kind) {
  const QString title = kind ? kind->panelTitle() : KindMenuWords::tr("Document");
  m_dock.setWindowTitle(title);
  m_dock.setAccessibleName(title);
  m_dock.findChild<PanelToggle*>()->setIcon(icon(kind ? kind->panelIcon() : QStringLiteral("file")));
  m_panels.setCurrentWidget(kind ? kind->panel() : m_empty);
  for (const auto& [each, menu] : m_menus) menu->menuAction()->setVisible(each == kind);
  m_bar.clear();
  if (kind) fill(m_bar, m_tools.at(kind), kind->toolBar());
  nameButtons(m_bar);
}

void nameButtons(QToolBar& bar) {
  for (QAction* action : bar.actions()) {
    auto* button = qobject_cast<QToolButton*>(bar.widgetForAction(action));
    if (!button || action->objectName().isEmpty()) continue;
    action->setIconText(withoutMnemonic(action->text()));  // Qt leaves what Chinese has in brackets
    button->setObjectName(bar.objectName() + QLatin1Char('/') + action->objectName());
    button->setAccessibleName(action->iconText());
    if (action->priority() == QAction::HighPriority) button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
}

}  // namespace handwheel
