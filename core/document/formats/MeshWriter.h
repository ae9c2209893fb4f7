// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/TriangleSoup.h"

#include <string>

namespace handwheel {

// The bytes of a file. Coordinates are rounded to the number type first; they must be finite and within its range.
// Empty once cancelled. O(points + triangles).

// Binary; normals computed in double precision, zero for a triangle without area.
std::string writeStl(const TriangleSoup& soup, Progress progress = {});
// Binary little-endian.
std::string writePly(const TriangleSoup& soup, NumberType numbers, Progress progress = {});
// Text, whatever the locale, with the shortest digits that read back to the same double.
std::string writeObj(const TriangleSoup& soup, NumberType numbers, Progress progress = {});
std::string writeOff(const TriangleSoup& soup, NumberType numbers, Progress progress = {});

}  // namespace handwheel
