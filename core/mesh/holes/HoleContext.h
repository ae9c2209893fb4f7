// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <set>
#include <vector>

namespace handwheel {

// A hole and the faces around it, with indices of their own. Points 0…loopSize-1 are those of the loop, in its order.
struct HoleContext {
  std::size_t loopSize = 0;
  std::vector<Vec3> points;
  std::vector<Triangle> ring;      // three rings of faces around the hole
  std::vector<Vec3> apexes;        // third corners of the faces at the loop edges (i, i+1)
  std::vector<double> edgeLength;  // mean lengths of the edges at the loop points
  Box ringBox;                     // bounding box of loop and ring

  std::vector<Vec3> loop() const { return {points.begin(), points.begin() + static_cast<std::ptrdiff_t>(loopSize)}; }
  double size() const;  // diagonal of the bounding box of the loop
  // Returns the outward direction of the loop: a unit vector for a flat convex loop, shorter if the loop bends or
  // folds.
  Vec3 outward() const;
};

// Extracts a hole and the faces around it from a mesh.
HoleContext holeContext(const HalfEdgeMesh& mesh, const BoundaryLoop& loop);

}  // namespace handwheel
