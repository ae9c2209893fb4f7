// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QAction;
class QString;

namespace handwheel {

// The tooltip of an action with its key, "Open files (Ctrl+O)", also after the user has given it another one.
void setTip(QAction& action, const QString& tip);

}  // namespace handwheel
