// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/ViewFocus.h"

#include <QAbstractButton>
#include <QApplication>
#include <QMainWindow>
#include <QPointer>

namespace handwheel {

ViewFocus::ViewFocus(QMainWindow& window, QWidget& view, QObject* parent)
    : QObject(parent), m_window(window), m_view(view) {
  connect(qApp, &QApplication::focusChanged, this, &ViewFocus::follow);
  qApp->installEventFilter(this);
}

void ViewFocus::follow(QWidget* old, QWidget* now) {
  if (!m_window.isActiveWindow() || (now && now->window() != &m_window)) return;
  const bool isTakenAway = old && old->window() == &m_window && !(old->isEnabled() && old->isVisible());
  if (isTakenAway || (!now && !m_window.focusWidget())) takeBackFrom(now);
}

// A button that is pressed gets the focus, so that a field that is being edited hears that it has lost it; and must
// keep it until it is released, or it takes the press for abandoned. A click that opens a field gives that the focus.
bool ViewFocus::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseButtonRelease) {
    const auto* button = qobject_cast<QAbstractButton*>(watched);
    if (button && button->window() == &m_window && button->hasFocus()) takeBackFrom(button);
  }
  return QObject::eventFilter(watched, event);
}

// Later: Qt is not done with the event. Unless something else has the focus by then, as a field that a command opened.
void ViewFocus::takeBackFrom(const QWidget* holder) {
  const auto take = [this, holder = QPointer<const QWidget>(holder)] {
    const QWidget* const present = m_window.focusWidget();
    const bool isFree = !present || !present->isEnabled() || !present->isVisible();
    if (m_view.isVisible() && (isFree || (holder && holder->hasFocus()))) m_view.setFocus(Qt::OtherFocusReason);
  };
  QMetaObject::invokeMethod(this, take, Qt::QueuedConnection);
}

}  // namespace handwheel
