// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"

#include <string>

namespace handwheel {

// Encoders of triangles as the bytes of a file. Coordinates are rounded to the number type first; they must be finite
// and within its range. Empty if cancelled. O(points + triangles).

// Encodes binary STL; normals are computed in double precision, zero for a triangle without area.
std::string writeStl(const TriangleSoup& soup, Progress progress = {});
// Encodes binary little-endian PLY.
std::string writePly(const TriangleSoup& soup, NumberType numbers, Progress progress = {});
// Encode OBJ and OFF as text. Independent of the locale, with the shortest digits that read back to the same double.
std::string writeObj(const TriangleSoup& soup, NumberType numbers, Progress progress = {});
std::string writeOff(const TriangleSoup& soup, NumberType numbers, Progress progress = {});

}  // namespace handwheel
