// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/openmesh/OpenMeshRefusal.h"
#include "mesh/sculpt/VertexGoals.h"
#include "mesh/selection/FaceSelection.h"

namespace handwheel {

// Options of smoothByLaplace().
struct LaplaceSmoothing {
  bool isBending = false;  // minimises the change of curvature, not the area: flattens less
  int passes = 10;         // each goes half of the way
  NumberType numbers = NumberType::Float64;
  Progress progress = {};
};

struct LaplaceSmoothed {
  OpenMeshRefusal refusal = OpenMeshRefusal::None;  // then nothing has moved
  MovedVertices moved;
};

// Smooths a part of a surface by OpenMesh's Jacobi-Laplace smoother, with equal weights for all neighbours. It takes
// sharp edges for noise, unlike smoothNoise(). Only vertices all of whose faces are in the part move, and none of open
// edges; bending, none beside them either. Nothing moves when cancelled. O(faces of the mesh).
LaplaceSmoothed smoothByLaplace(HalfEdgeMesh& mesh, const FaceSelection& part, const LaplaceSmoothing& options = {});

}  // namespace handwheel
