// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "document/DocumentFile.h"

namespace handwheel {

// Limits of the largest dimension (mm) of a part with a plausible unit. If the dimension is outside them, the numbers
// are probably in another unit. Scans and prints are larger than the smaller limit even in the finest processes; a part
// above the larger limit fits no machine.
inline constexpr double kSmallestLikelySize = 1.0;
inline constexpr double kLargestLikelySize = 10'000.0;

// Returns true if the file of a part states no unit and the size of the part in millimetres is unlikely.
bool isUnitImplausible(const DocumentFile& file, const Box& box);
// Returns a note that the unit is implausible, with the size. The box must not be empty.
Note implausibleUnit(const Box& box);

}  // namespace handwheel
