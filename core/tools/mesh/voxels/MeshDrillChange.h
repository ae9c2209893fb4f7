// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/mesh/MeshServices.h"
#include "volume/HybridPart.h"
#include "volume/drilling/DrillRecord.h"

namespace handwheel {

// A hole that was drilled in a mesh by voxels near the head.
struct DrilledMeshHole {
  HalfEdgeMesh present;  // the mesh in which the hole is made
  HalfEdgeMesh
      origin;  // the mesh in which the whole record is drilled: `present`, or the mesh before the previous hole
  std::shared_ptr<const HybridPart> uncut;  // part made of the origin
  std::shared_ptr<const HybridPart> cut;    // the part after drilling the record; null: the record is replayed
  std::shared_ptr<const DrillRecord> record;
};

// Joins the record of a hole with that of the previous hole that it continues. The joined record is drilled in the mesh
// without both holes, so that the common wall is made only once; two coincident walls could not be joined reliably.
// Returns null if the heads differ, if the new hole does not begin on the axis and in the direction of the last pose of
// the previous hole, or if the joined record would be too long.
std::shared_ptr<const DrillRecord> joinedRecord(const DrillRecord& before, const DrillRecord& record);

// The outcome of a hole, set by the change. It must be read on the window thread.
struct DrilledMeshHoleOutcome {
  std::atomic<bool> isMade{false};  // the hole is in the triangles
  // The reason why the hole is not in the triangles; English text, translated in the context "Tool". Null: the change
  // was cancelled.
  std::atomic<const char*> reason = nullptr;
};

// Creates the change that removes the drilled volume from the triangles (drilledTriangles()). Faces that the hole does
// not meet keep their indices. The change does nothing if the mesh is no longer `present`. numbers: the number type of
// the mesh file.
MeshChange drillChange(DrilledMeshHole hole, NumberType numbers, std::shared_ptr<DrilledMeshHoleOutcome> outcome);

}  // namespace handwheel
