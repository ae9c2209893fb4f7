// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/holes/Patch.h"
#include "mesh/repair/Submesh.h"

#include <span>

namespace handwheel {

// A patch for a loop of a mesh. The loop and the patch must outlive the object.
struct PatchAtLoop {
  const BoundaryLoop* loop;
  const Patch* patch;
};

// The result of inserting patches into a part of a mesh.
struct PatchTrial {
  bool isOutside = false;  // true if the part does not contain the loops completely
  bool isSound = false;
  Box reach;  // bounding box of all faces that intersect the patches or changed
  HalfEdgeMesh changed;
  std::size_t cutFaces = 0;
  std::size_t fewerCrossings = 0;
  std::size_t fewerBadEdges = 0;
};

// Inserts patches into a part of a mesh and cuts where they intersect it (removeSelfIntersections()). The trial is
// sound if it has no more self-intersections than the part, and fewer edges without two faces. mesh: the whole mesh.
// The trial is not sound if cancelled.
PatchTrial tryPatches(const Submesh& part, const HalfEdgeMesh& mesh, std::span<const PatchAtLoop> patches,
                      NumberType numbers, const Progress& progress);

// Returns true if the faces have finite coordinates, so that no number overflowed.
bool areFinite(const HalfEdgeMesh& mesh, std::span<const Face> faces);

}  // namespace handwheel
