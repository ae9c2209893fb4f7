// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ActionButton.h"

#include <QAction>
#include <QEvent>

namespace handwheel {

ActionButton::ActionButton(QAction* action, Rank rank, QWidget* parent) : QPushButton(parent), m_action(action) {
  setObjectName(action->objectName() + QStringLiteral("Button"));
  setProperty(rank == Rank::Primary ? "primary" : "flat", rank != Rank::Ordinary);
  setCursor(Qt::ArrowCursor);
  follow();
  connect(action, &QAction::changed, this, &ActionButton::follow);
  connect(this, &QPushButton::clicked, action, &QAction::trigger);
}

bool ActionButton::event(QEvent* event) {
  if (event->type() == QEvent::Enter || event->type() == QEvent::FocusIn) emit pointed(true);
  if (event->type() == QEvent::Leave || event->type() == QEvent::FocusOut) emit pointed(false);
  return QPushButton::event(event);
}

void ActionButton::follow() {
  setText(m_action->iconText());
  setToolTip(m_action->toolTip());
  setAccessibleName(m_action->iconText());
  setEnabled(m_action->isEnabled());
  setCheckable(m_action->isCheckable());
  setChecked(m_action->isChecked());
}

}  // namespace handwheel
