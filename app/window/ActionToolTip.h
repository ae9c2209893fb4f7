// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QAction;
class QString;

namespace handwheel {

// Sets the tooltip of an action and appends its shortcut: "Open files (Ctrl+O)". The tooltip follows later changes of
// the shortcut.
void setActionToolTip(QAction& action, const QString& tip);

// Sets the object name, icon and tooltip of an action. Tests and shortcut settings find the action by its object name.
// iconName: null for no icon.
void prepare(QAction& action, const char* name, const char* iconName, const QString& tip);

}  // namespace handwheel
