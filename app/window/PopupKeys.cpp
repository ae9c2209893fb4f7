// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/PopupKeys.h"

#include "controls/ContextAction.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>

namespace handwheel {

PopupKeys::PopupKeys(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
}

bool PopupKeys::eventFilter(QObject* watched, QEvent* event) {
  if (m_isDelivering || event->type() != QEvent::ShortcutOverride) return QObject::eventFilter(watched, event);
  if (QApplication::activePopupWidget()) return keepForPopup(*watched, *event);
  const auto* const line = qobject_cast<const QLineEdit*>(watched);
  if (!line || !line->isModified() || !isEndingKey(QKeySequence(static_cast<QKeyEvent*>(event)->key())))
    return QObject::eventFilter(watched, event);
  event->accept();
  return true;
}

// The list of a combo box takes Return here, but does not accept it.
bool PopupKeys::keepForPopup(QObject& watched, QEvent& event) {
  m_isDelivering = true;
  QCoreApplication::sendEvent(&watched, &event);
  m_isDelivering = false;
  event.accept();
  return true;
}

}  // namespace handwheel
