// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace handwheel {

// Returns true if bytes are well-formed UTF-8.
bool isUtf8(std::string_view bytes);

}  // namespace handwheel
