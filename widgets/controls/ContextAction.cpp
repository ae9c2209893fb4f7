// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/ContextAction.h"

#include <utility>

namespace handwheel {

ContextAction::ContextAction(const QString& text, QString scope, QString path, QObject* parent)
    : QAction(text, parent), m_scope(std::move(scope)), m_path(std::move(path)) {}

bool isEndingKey(const QKeySequence& keys) {
  for (int i = 0; i < keys.count(); ++i) {
    const QKeyCombination press = keys[static_cast<uint>(i)];
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Escape}) {
      if (press == QKeyCombination(key)) return true;
    }
  }
  return false;
}

}  // namespace handwheel
