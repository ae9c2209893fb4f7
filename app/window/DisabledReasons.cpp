// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/DisabledReasons.h"

#include "controls/CommandModel.h"
#include "panels/ActionButton.h"

#include <QApplication>
#include <QHelpEvent>
#include <QMenu>
#include <QTextDocument>
#include <QToolButton>
#include <QToolTip>

namespace handwheel {

DisabledReasons::DisabledReasons(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
}

bool DisabledReasons::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ToolTip) return false;
  const auto& help = static_cast<const QHelpEvent&>(*event);
  auto* const menu = qobject_cast<QMenu*>(watched);
  const auto* const toolButton = qobject_cast<QToolButton*>(watched);
  const auto* const button = qobject_cast<ActionButton*>(watched);
  QAction* const action = menu         ? menu->actionAt(help.pos())
                          : toolButton ? toolButton->defaultAction()
                          : button     ? button->action()
                                       : nullptr;
  const QString reason = action && !action->isEnabled() ? action->property(kDisabledReason).toString() : QString();
  if (reason.isEmpty()) return false;
  const QString text = menu ? reason : QStringLiteral("%1\n\n%2").arg(action->toolTip(), reason);
  auto* const widget = static_cast<QWidget*>(watched);
  const QRect rect = menu ? menu->actionGeometry(action) : widget->rect();
  QToolTip::showText(help.globalPos(), Qt::convertFromPlainText(text, Qt::WhiteSpaceNormal), widget, rect);
  return true;
}

}  // namespace handwheel
