// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Units.h"
#include "mesh/structure/TriangleSoup.h"

#include <string>

namespace handwheel {

// Encodes triangles as a 3MF file with one object in millimetres. The object is built once; deflated. Coordinates are
// rounded to the number type first and written with the shortest digits that read back to the same double; they must be
// finite. The archive is empty if cancelled, or if the library fails. O(points + triangles).
std::string writeThreeMf(const TriangleSoup& soup, NumberType numbers, Progress progress = {});
// Encodes them with another unit for these numbers, which are not scaled.
std::string writeThreeMf(const TriangleSoup& soup, NumberType numbers, LengthUnit unit, Progress progress = {});

}  // namespace handwheel
