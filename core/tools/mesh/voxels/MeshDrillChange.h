// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/mesh/MeshServices.h"
#include "volume/HybridPart.h"
#include "volume/drilling/DrillRecord.h"

namespace handwheel {

// A hole that was drilled in a mesh by voxels near the head.
struct DrilledMeshHole {
  HalfEdgeMesh present;  // the mesh that the hole is put into
  HalfEdgeMesh origin;  // the mesh that the whole record is drilled in: `present`, or the mesh before the previous hole
  std::shared_ptr<const HybridPart> uncut;  // part made of the origin
  std::shared_ptr<const HybridPart> cut;    // the part after drilling the record; null: the record is replayed
  std::shared_ptr<const DrillRecord> record;
};

// Returns the record of a hole that continues the one before: both together, to be drilled in the mesh that had
// neither. The wall of such a hole is made once, because two coincident walls could not be joined soundly. Null if the
// hole has another head, or does not continue from where the hole before can be left without taking more.
std::shared_ptr<const DrillRecord> joinedRecord(const DrillRecord& before, const DrillRecord& record);

// Outcome of a hole, set by the change. Read on the window thread.
struct DrilledMeshHoleOutcome {
  std::atomic<bool> isMade{false};  // the hole is in the triangles
  // The reason if it is not; English, context "Tool". Null: it was cancelled.
  std::atomic<const char*> reason = nullptr;
};

// Creates the change that removes the drilled volume from the triangles (drilledTriangles()). Faces that the hole does
// not meet keep their indices. A mesh that has changed meanwhile is left unchanged. numbers: those of its file.
MeshChange drillChange(DrilledMeshHole hole, NumberType numbers, std::shared_ptr<DrilledMeshHoleOutcome> outcome);

}  // namespace handwheel
