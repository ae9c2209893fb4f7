// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ActionButton.h"

#include <QAction>
#include <QEvent>

namespace handwheel {

ActionButton::ActionButton(QAction* action, Rank rank, QWidget* parent) : QPushButton(parent) {
  setObjectName(action->objectName() + QStringLiteral("Button"));
  setProperty(rank == Rank::Primary ? "primary" : "flat", rank != Rank::Ordinary);
  setCursor(Qt::ArrowCursor);
  follow(action);
  connect(action, &QAction::changed, this, [this, action] { follow(action); });
  connect(this, &QPushButton::clicked, action, &QAction::trigger);
}

bool ActionButton::event(QEvent* event) {
  if (event->type() == QEvent::Enter || event->type() == QEvent::FocusIn) emit pointed(true);
  if (event->type() == QEvent::Leave || event->type() == QEvent::FocusOut) emit pointed(false);
  return QPushButton::event(event);
}

void ActionButton::follow(const QAction* action) {
  setText(action->iconText());
  setToolTip(action->toolTip());
  setAccessibleName(action->iconText());
  setEnabled(action->isEnabled());
  setCheckable(action->isCheckable());
  setChecked(action->isChecked());
}

}  // namespace handwheel
