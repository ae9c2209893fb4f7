// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace handwheel {

// Bytes that the system has left before it must end a program, swap included; the largest number when it does not say.
std::size_t systemMemory();

}  // namespace handwheel
