// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/mesh/MeshServices.h"
#include "volume/HybridPart.h"
#include "volume/drilling/DrillRecord.h"

namespace handwheel {

// A hole that was drilled in a mesh by voxels near the head.
struct DrilledMeshHole {
  HalfEdgeMesh present;                     // the mesh that it is put into
  HalfEdgeMesh origin;                      // which the whole record is drilled in: the same, or as it was before
  std::shared_ptr<const HybridPart> uncut;  // made of the origin
  std::shared_ptr<const HybridPart> cut;    // by the record; null: it is gone through once more
  std::shared_ptr<const DrillRecord> record;
};

// The record of a hole that goes on along the one before: of all of it, by which it is drilled in the mesh that had
// neither. The wall of such a hole is made once, while two walls on each other could not be joined soundly. Null: it is
// by another head, or does not go on where the hole before can be left without taking more.
std::shared_ptr<const DrillRecord> joinedRecord(const DrillRecord& before, const DrillRecord& record);

// What became of a hole, set by the change. Read on the window thread.
struct DrilledMeshHoleOutcome {
  std::atomic<bool> isMade{false};            // it is in the triangles
  std::atomic<const char*> reason = nullptr;  // why it is not; English, context "Tool". Null: it was cancelled
};

// Takes the removed volume from the triangles (drilledTriangles()). Faces that the hole does not meet keep their
// indices. A mesh that is another by now is left as it is. numbers: of its file.
MeshChange drillChange(DrilledMeshHole hole, NumberType numbers, std::shared_ptr<DrilledMeshHoleOutcome> outcome);

}  // namespace handwheel
