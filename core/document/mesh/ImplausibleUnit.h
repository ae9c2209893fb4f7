// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "document/DocumentFile.h"

namespace handwheel {

// Limits of the largest dimension (mm) of a part with a plausible unit. Beyond them, its numbers are probably in
// another unit. Scans and prints are larger than the smallest, also in the finest processes; a part above the largest
// fits no machine.
inline constexpr double kSmallestLikelySize = 1.0;
inline constexpr double kLargestLikelySize = 10'000.0;

// Returns true if the file of a part names no unit and its size in millimetres is unlikely.
bool isUnitImplausible(const DocumentFile& file, const Box& box);
// Returns a note that the unit is implausible, with the size. box: not empty.
Note implausibleUnit(const Box& box);

}  // namespace handwheel
