// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/Bridging.h"

#include <vector>

namespace handwheel {

// The result of weldBorder().
struct Weld {
  JoinProblem problem = JoinProblem::None;
  HalfEdgeMesh mesh;          // with the weld, when there is no problem
  std::vector<Face> changed;  // faces that move, including a removed one
  TriangleSoup shapes;        // new shapes of those that stay
};

// Moves the first border point onto the second and merges the border there. Neighbours along the border are merged by
// collapsing their edge; for points two edges apart, the two edges are merged. Other points would only touch, so the
// nearer one of their neighbours moves along and the two edges become one. Faces that do not move stay as they are.
// near: of this very mesh.
Weld weldBorder(const FaceLocator& near, const BorderPair& ends);

}  // namespace handwheel
