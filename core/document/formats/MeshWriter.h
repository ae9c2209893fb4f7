// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"

#include <string>

namespace handwheel {

// Writers that encode a triangle soup as the bytes of a file. Coordinates are first rounded to the number type; they
// must be finite and within its range. The result is empty if cancelled. O(points + triangles).

// Returns the soup as binary STL. Normals are computed in double precision; that of a triangle without area is zero.
std::string writeStl(const TriangleSoup& soup, Progress progress = {});
// Returns the soup as binary little-endian PLY.
std::string writePly(const TriangleSoup& soup, NumberType numbers, Progress progress = {});
// Return the soup as OBJ and OFF, which are text. Numbers do not depend on the locale, and have the fewest digits that
// read back as the same double.
std::string writeObj(const TriangleSoup& soup, NumberType numbers, Progress progress = {});
std::string writeOff(const TriangleSoup& soup, NumberType numbers, Progress progress = {});

}  // namespace handwheel
