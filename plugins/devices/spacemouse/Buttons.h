// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace handwheel::spacemouse {

inline constexpr int kNoBit = -1;

// Returns the bit of DeviceState::buttons for a button by its number in report 28. Up to 31, the bit is the number
// itself, as in the bitmap of report 3. The higher buttons, which only the SpaceMouse Enterprise has, take bits that it
// does not use otherwise. Returns kNoBit for an unknown number.
int bitOf(std::uint16_t number);

}  // namespace handwheel::spacemouse
