// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/holes/Patch.h"
#include "mesh/repair/Submesh.h"

#include <span>

namespace handwheel {

// A patch for a loop of a mesh. Both outlive it.
struct PatchAtLoop {
  const BoundaryLoop* loop;
  const Patch* patch;
};

// Patches put into a part of a mesh, with a verdict on them.
struct PatchTrial {
  bool isOutside = false;  // the part does not hold the loops as they are
  bool isSound = false;
  Box reach;  // of what intersects the patches, and of what was changed
  HalfEdgeMesh changed;
  std::size_t cutFaces = 0;
  std::size_t fewerCrossings = 0;
  std::size_t fewerBadEdges = 0;
};

// Inserts patches into a part of a mesh, although they may intersect it, and cuts where they do
// (removeSelfIntersections()). Sound is what has no more self-intersections than the part, and fewer edges without two
// faces. mesh: of which that is a part. Not sound if cancelled.
PatchTrial tryPatches(const Submesh& part, const HalfEdgeMesh& mesh, std::span<const PatchAtLoop> patches,
                      NumberType numbers, const Progress& progress);

// False where numbers at the end of their range overflowed.
bool areFinite(const HalfEdgeMesh& mesh, std::span<const Face> faces);

}  // namespace handwheel
