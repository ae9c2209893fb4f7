// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

#include <string>

namespace handwheel {

// Returns a hash (SHA-256, hexadecimal) of the exact points and triangles of a shape. O(points + triangles).
std::string shapeDigest(const TriangleSoup& shape);

}  // namespace handwheel
