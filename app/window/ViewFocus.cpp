// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/ViewFocus.h"

#include <QAbstractButton>
#include <QApplication>
#include <QFocusEvent>
#include <QMainWindow>

namespace handwheel {

ViewFocus::ViewFocus(QMainWindow& window, QWidget& view, QObject* parent)
    : QObject(parent), m_window(window), m_view(view) {
  connect(qApp, &QApplication::focusChanged, this, &ViewFocus::follow);
  qApp->installEventFilter(this);
}

void ViewFocus::follow(QWidget* old, QWidget* now) {
  if (!m_window.isActiveWindow() || (now && now->window() != &m_window)) return;
  const bool isTakenAway = old && old->window() == &m_window && !(old->isEnabled() && old->isVisible());
  if (isTakenAway || (!now && !m_window.focusWidget())) takeBack();
}

// A button that is clicked gets the focus first, so that a field that is being edited hears that it has lost it.
bool ViewFocus::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusIn && static_cast<QFocusEvent*>(event)->reason() == Qt::MouseFocusReason) {
    const auto* button = qobject_cast<QAbstractButton*>(watched);
    if (button && button->window() == &m_window) takeBack();
  }
  return QObject::eventFilter(watched, event);
}

// Later: Qt is not done with moving the focus.
void ViewFocus::takeBack() {
  QMetaObject::invokeMethod(
      &m_view,
      [this] {
        if (m_view.isVisible()) m_view.setFocus(Qt::OtherFocusReason);
      },
      Qt::QueuedConnection);
}

}  // namespace handwheel
