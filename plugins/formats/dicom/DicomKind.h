// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace handwheel {

// Returns the reason for which a file has no slices. It names what the file holds instead.
const char* reasonWithoutSlices(std::string_view file);

}  // namespace handwheel
