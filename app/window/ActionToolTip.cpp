// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/ActionToolTip.h"

#include "theme/Icons.h"

#include <QAction>

namespace handwheel {

void setActionToolTip(QAction& action, const QString& tip) {
  const auto show = [&action, tip] {
    const QString key = action.shortcut().toString(QKeySequence::NativeText);
    action.setToolTip(key.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, key));
  };
  QObject::connect(&action, &QAction::changed, &action, show);
  show();
}

void prepare(QAction& action, const char* name, const char* iconName, const QString& tip) {
  action.setObjectName(QString::fromLatin1(name));
  if (iconName) action.setIcon(icon(QString::fromLatin1(iconName)));
  setActionToolTip(action, tip);
}

}  // namespace handwheel
