// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/PopupKeys.h"

#include <QApplication>
#include <QEvent>

namespace handwheel {

PopupKeys::PopupKeys(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
}

bool PopupKeys::eventFilter(QObject* watched, QEvent* event) {
  if (m_isDelivering || event->type() != QEvent::ShortcutOverride || !QApplication::activePopupWidget())
    return QObject::eventFilter(watched, event);
  // The list of a combo box takes Return here, but does not accept it.
  m_isDelivering = true;
  QCoreApplication::sendEvent(watched, event);
  m_isDelivering = false;
  event->accept();
  return true;
}

}  // namespace handwheel
