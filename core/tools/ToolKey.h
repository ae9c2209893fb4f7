// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/Tool.h"

#include <span>

namespace handwheel {

// An action that a tool may offer in some state, with its key. Keys can be listed and changed before the tool runs.
struct ToolKey {
  const char* action;  // id of a ToolAction
  const char* input;   // the default key; empty: none
  const char* effect;  // English text, translated in the context "Tool"; may be more specific in some states
  // A command of the window with the same effect, whose key is also that of the action; empty: none.
  const char* command = "";
};

// Creates the action of a key, for the tool's present state. id: the action of one of the keys. effect: null for the
// effect in `keys`.
ToolAction actionOf(std::span<const ToolKey> keys, std::string_view id, bool enabled = true,
                    const char* effect = nullptr);

}  // namespace handwheel
