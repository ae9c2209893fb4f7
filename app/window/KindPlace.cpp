// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/KindPlace.h"

#include "theme/Icons.h"
#include "window/KindUi.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QStackedWidget>
#include <QToolBar>
#include <QToolButton>

namespace handwheel {

namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(KindPlace)
};

// Menu and tool bar without a line where there is nothing to part.
template <class Place>
void fill(Place& place, const QList<QAction*>& tools, const QList<QAction*>& others) {
  place.clear();
  place.addActions(tools);
  if (!tools.isEmpty() && !others.isEmpty()) place.addSeparator();
  place.addActions(others);
}

}  // namespace

KindPlace::KindPlace(QDockWidget& dock, QStackedWidget& panels, QMenu& menu, QToolBar& bar)
    : m_dock(dock), m_panels(panels), m_menu(menu), m_bar(bar), m_empty(new QLabel(&panels)) {
  m_empty->setText(Text::tr("No document is open."));
  m_empty->setProperty("muted", true);
  m_empty->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  m_empty->setContentsMargins(12, 12, 12, 12);
  m_panels.addWidget(m_empty);
}

void KindPlace::show(KindUi* kind, const QList<QAction*>& tools) {
  const QString title = kind ? kind->panelTitle() : Text::tr("Document");
  m_dock.setWindowTitle(title);
  m_dock.setAccessibleName(title);
  m_dock.toggleViewAction()->setIcon(icon(kind ? kind->panelIcon() : QStringLiteral("file")));
  m_panels.setCurrentWidget(kind ? kind->panel() : m_empty);
  m_menu.menuAction()->setVisible(kind != nullptr);
  if (kind) m_menu.setTitle(kind->menuTitle());
  fill(m_menu, tools, kind ? kind->menu() : QList<QAction*>());
  fill(m_bar, tools, kind ? kind->toolBar() : QList<QAction*>());
  nameButtons(m_bar);
}

void nameButtons(QToolBar& bar) {
  for (QAction* action : bar.actions()) {
    auto* button = qobject_cast<QToolButton*>(bar.widgetForAction(action));
    if (!button || action->objectName().isEmpty()) continue;
    button->setObjectName(bar.objectName() + QLatin1Char('/') + action->objectName());
    button->setAccessibleName(action->iconText());
    if (action->priority() == QAction::HighPriority) button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
}

}  // namespace handwheel
