// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QAction;
class QString;

namespace handwheel {

// The tooltip of an action with its key, "Open files (Ctrl+O)", also after the user has given it another one.
void setTip(QAction& action, const QString& tip);

// With this tip, the name by which tests and keys know it, and the icon of this name; null: none.
void prepare(QAction& action, const char* name, const char* iconName, const QString& tip);

}  // namespace handwheel
