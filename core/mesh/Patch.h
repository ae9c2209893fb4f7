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
  Area,      // the triangulation of least area, no new vertices
  Dihedral,  // the triangulation whose largest bend is least, then of least area, no new vertices
  Ridge,     // as Fair, with the creases that end at the hole carried through it
  Cone,      // triangles to one point before or behind the loop; only a repair does this
  Backed,    // its sheet was given a back (backSheet()); only a repair does this
  Stitched,  // the borders were brought together; only a repair does this
  Removed,   // cleaning took every face around the hole; only a repair does this
};

// A bridge across a hole: an edge between two points of its loop, given by their numbers in it.
struct Stitch {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  bool operator==(const Stitch&) const = default;
};

// What closes a loop: triangles over the loop's points (in the loop's order) and new ones behind them.
struct Patch {
  std::size_t loopSize = 0;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  FillMethod method = FillMethod::Fair;
  std::vector<Stitch> stitches = {};  // along which the loop was cut into pieces
};

}  // namespace handwheel
