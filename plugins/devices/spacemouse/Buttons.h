// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace handwheel::spacemouse {

inline constexpr int kNoBit = -1;

// Returns the bit of DeviceState::buttons for a button by its number in report 28. Up to 31 it is the number itself, as
// in the bitmap of report 3. The higher ones, which only the SpaceMouse Enterprise has, take bits that it does not use
// otherwise; kNoBit for a number that is not known.
int bitOf(std::uint16_t number);

}  // namespace handwheel::spacemouse
