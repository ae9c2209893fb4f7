// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Units.h"
#include "mesh/structure/TriangleSoup.h"

#include <string>

namespace handwheel {

// Encodes triangles as a 3MF file with one object in millimetres. The build section has the object once. Coordinates
// must be finite; they are rounded to the number type and written with the fewest digits that read back to the same
// double. The archive is compressed with deflate. The result is empty after a cancellation, or if the library fails.
// O(points + triangles).
std::string writeThreeMf(const TriangleSoup& soup, NumberType numbers, Progress progress = {});
// Encodes triangles as a 3MF file in the given unit. The coordinates are already in this unit and are not scaled.
std::string writeThreeMf(const TriangleSoup& soup, NumberType numbers, LengthUnit unit, Progress progress = {});

}  // namespace handwheel
