// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <optional>
#include <vector>

namespace handwheel {

// The methods of hole filling.
enum class FillMethod {
  Fair,            // refined to the density of the surroundings and faired to continue them (CGAL)
  Refined,         // refined, not faired
  Ear,             // best-first ear clipping (He 2008, section 4.1.5), no new vertices
  Minimal,         // CGAL's triangulation by dihedral angle and area, no new vertices
  Area,            // the triangulation of least area, no new vertices
  Dihedral,        // the triangulation whose largest bend is least, then of least area, no new vertices
  Crease,          // like Fair, with the creases that end at the hole continued through it
  Flat,            // triangulated in the least-squares plane of the loop, no new vertices (triangulateFlat())
  Cone,            // triangles to one point in front of or behind the loop; used only by repairs
  ThickenedSheet,  // the sheet of the loop was thickened (thickenSheets()); used only by repairs
  Stitched,        // the borders were stitched together; used only by repairs
  Removed,         // cleaning removed every face around the hole; used only by repairs
};

// The continuity between a faired surface and its fixed neighbours.
enum class Continuity {
  Position,   // equal positions: a membrane, whose area is as small as its initial shape allows
  Tangent,    // also equal tangents: a thin plate of least bending
  Curvature,  // also equal curvature: least variation of bending
};

// A bridge across a hole: an edge between two points of its loop, given by their indices.
struct HoleBridge {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  bool operator==(const HoleBridge&) const = default;
};

// A triangulated patch that closes a boundary loop. Its points are those of the loop, in the loop's order, followed by
// added points.
struct Patch {
  std::size_t loopSize = 0;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  FillMethod method = FillMethod::Fair;
  std::vector<HoleBridge> bridges = {};       // the bridges along which the loop was cut into pieces
  std::optional<Continuity> continuity = {};  // set if the patch was faired
};

}  // namespace handwheel
