// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <vector>

namespace handwheel {

// Points and triangles as a file holds them: nothing welded, nothing checked but that every index is in range.
struct TriangleSoup {
  std::vector<Vec3> points;         // mm
  std::vector<Triangle> triangles;  // indices into points
};

}  // namespace handwheel
