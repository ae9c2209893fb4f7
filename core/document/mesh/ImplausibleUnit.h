// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "document/DocumentFile.h"

namespace handwheel {

// Largest dimensions (mm) of a part beyond which its numbers are rather of another unit. The smallest of a scan or a
// print is larger, also in the finest processes, and what is larger fits no machine.
inline constexpr double kSmallestLikelySize = 1.0;
inline constexpr double kLargestLikelySize = 10'000.0;

// Whether the unit of a part is implausible: its file says none, and its size in millimetres is unlikely.
bool isUnitImplausible(const DocumentFile& file, const Box& box);
// A note that the unit is implausible, with the size. box: not empty.
Note implausibleUnit(const Box& box);

}  // namespace handwheel
