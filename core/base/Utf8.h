// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace handwheel {

// Returns true if bytes are well-formed UTF-8.
bool isUtf8(std::string_view bytes);

// Returns true if c is an ASCII control character, such as a tab.
inline bool isControl(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

}  // namespace handwheel
