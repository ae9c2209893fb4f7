// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// Commits the text of the field that has the focus, if any. The effect is that of leaving the field, but it keeps the
// focus. To be called before the subject of the field is saved, closed or no longer shown: keys, tabs and menus do that
// without taking the focus first. Nothing happens for fields of dialogs. Window thread.
void commitFocusedField();

}  // namespace handwheel
