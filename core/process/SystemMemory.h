// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace handwheel {

// Returns the memory that the system has available, in bytes, including swap. If it is used up, the system must end a
// program. Returns the largest number if the system does not report its memory.
std::size_t systemMemory();

}  // namespace handwheel
