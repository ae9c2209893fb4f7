// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/PanelEscape.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <utility>

namespace handwheel {

PanelEscape::PanelEscape(std::function<bool()> escape, QObject* window) : QObject(window), m_escape(std::move(escape)) {
  qApp->installEventFilter(this);
}

// A key that the widgets of a panel have ignored comes to the panel, and, unless that is a window of its own, to the
// main window.
bool PanelEscape::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
    return QObject::eventFilter(watched, event);
  const bool isPanel = watched->parent() == parent() && qobject_cast<QDockWidget*>(watched);
  return ((isPanel || watched == parent()) && m_escape()) || QObject::eventFilter(watched, event);
}

}  // namespace handwheel
