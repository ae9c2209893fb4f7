// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/OwnKeys.h"

#include <QKeyEvent>
#include <QWidget>
#include <utility>

namespace handwheel {

OwnKeys::OwnKeys(QWidget& widget, QList<Qt::Key> keys) : QObject(&widget), m_keys(std::move(keys)) {
  widget.installEventFilter(this);
}

bool OwnKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return QObject::eventFilter(watched, event);
  const auto& key = static_cast<QKeyEvent&>(*event);
  const bool isPlain = (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
  if (!isPlain || !m_keys.contains(static_cast<Qt::Key>(key.key()))) return QObject::eventFilter(watched, event);
  event->accept();
  return true;
}

}  // namespace handwheel
