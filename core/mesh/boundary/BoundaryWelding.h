// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/Bridging.h"

#include <vector>

namespace handwheel {

// A mesh with two boundary points merged, or the reason why they cannot be merged.
struct BoundaryWeld {
  JoinProblem problem = JoinProblem::None;
  HalfEdgeMesh mesh;          // the welded mesh, if there is no problem
  std::vector<Face> changed;  // faces that move, including a removed one
  TriangleSoup shapes;        // new shapes of the moved faces that stay
};

// Moves the first boundary point onto the second and merges the boundary there. Neighbours along the boundary are
// merged by collapsing their edge; for points two edges apart, the two edges are merged. Other points would only touch,
// so the nearer one of their neighbours moves too and the two edges become one. Faces that do not move stay as they
// are. near must be built from the mesh of the points.
BoundaryWeld weldBoundary(const FaceLocator& near, const BoundaryPair& ends);

}  // namespace handwheel
