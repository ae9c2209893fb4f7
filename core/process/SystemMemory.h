// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace handwheel {

// Returns the memory that the system has available, in bytes, swap included. When it is used up the system must end a
// program; the largest number when the system does not say.
std::size_t systemMemory();

}  // namespace handwheel
