// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/ToolKey.h"

#include <algorithm>
#include <cassert>

namespace handwheel {

ToolAction actionOf(std::span<const ToolKey> keys, std::string_view id, bool enabled, const char* effect) {
  const auto key = std::find_if(keys.begin(), keys.end(), [id](const ToolKey& each) { return each.action == id; });
  assert(key != keys.end());
  return {std::string(id), key->input, effect ? effect : key->effect, enabled, key->command};
}

}  // namespace handwheel
