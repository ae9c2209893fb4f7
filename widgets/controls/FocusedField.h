// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// Commits the text of the field that has the focus, if any. The effect is the same as leaving the field, but the field
// keeps the focus. To be called before the object that the field edits is saved, closed or hidden, because keys, tabs
// and menus do this without moving the focus. Fields of dialogs are not committed. Must be called on the window thread.
void commitFocusedField();

}  // namespace handwheel
