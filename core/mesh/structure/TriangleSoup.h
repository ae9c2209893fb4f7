// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <vector>

namespace handwheel {

// A triangle soup: points and indexed triangles, as in a file. Nothing is welded, and only the range of indices is
// checked.
struct TriangleSoup {
  std::vector<Vec3> points;         // mm
  std::vector<Triangle> triangles;  // indices into points
};

}  // namespace handwheel
