// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/Bridging.h"

#include <vector>

namespace handwheel {

// The border at ends.a drawn to the border at ends.b.
struct Weld {
  JoinProblem problem = JoinProblem::None;
  HalfEdgeMesh mesh;          // with the weld, when there is no problem
  std::vector<Face> changed;  // faces that move; one that goes is among them
  TriangleSoup shapes;        // of those that stay, as they become
};

// Moves the first point of the border onto the second and joins them. Neighbours along the border become one by
// collapsing their edge, points two edges apart zip the two edges together. Other points would only touch, so the
// nearer one of their neighbours goes along and the two edges become one. Faces that do not move stay as they are.
// near: of this very mesh.
Weld weldBorder(const NearFaces& near, const BorderPair& ends);

}  // namespace handwheel
