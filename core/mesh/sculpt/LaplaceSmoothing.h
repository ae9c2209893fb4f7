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
  bool isBending = false;  // minimises the change of curvature instead of the area, which flattens less
  int passes = 10;         // each pass moves vertices halfway to their smoothed positions
  NumberType numbers = NumberType::Float64;
  Progress progress = {};
};

struct LaplaceSmoothed {
  OpenMeshRefusal refusal = OpenMeshRefusal::None;  // nothing moves if refused
  MovedVertices moved;
};

// Smooths a part of a surface by OpenMesh's Jacobi-Laplace smoother, with equal weights for all neighbours. It treats
// sharp edges as noise, unlike smoothNoise(). Only vertices whose faces are all in the part move, except those of open
// edges and, with isBending, their neighbours. Nothing moves if cancelled. O(faces of the mesh).
LaplaceSmoothed smoothByLaplace(HalfEdgeMesh& mesh, const FaceSelection& part, const LaplaceSmoothing& options = {});

}  // namespace handwheel
