// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/CommandModel.h"

#include <QAction>

namespace handwheel {

// Enables an action, or disables it with a reason.
inline void offer(QAction& action, bool isEnabled, const QString& reason) {
  action.setProperty(kDisabledReason, isEnabled ? QString() : reason);
  action.setEnabled(isEnabled);
}

}  // namespace handwheel
