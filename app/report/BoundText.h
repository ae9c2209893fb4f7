// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace handwheel {

// Formats an upper bound as roundedText() does, but never below the value.
std::string roundedUpText(double value, int digits = 6);

}  // namespace handwheel
