// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <vector>

namespace handwheel {

enum class FillMethod {
  Fair,      // refined to the density of the surroundings and bent to continue them (CGAL)
  Refined,   // refined, not bent
  Ear,       // best-first ear cutting (He 2008, section 4.3; spec step 4), no new vertices
  Minimal,   // CGAL's triangulation by dihedral angle and area, no new vertices
  Stitched,  // the borders were brought together; only a repair does this
  Removed,   // cleaning took every face around the hole; only a repair does this
};

// What closes a loop: triangles over the loop's points (in the loop's order) and new ones behind them.
struct Patch {
  std::size_t loopSize = 0;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  FillMethod method = FillMethod::Fair;
};

}  // namespace handwheel
