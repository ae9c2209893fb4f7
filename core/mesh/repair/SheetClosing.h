// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/repair/CoincidentVertexSeparation.h"
#include "mesh/repair/ObstructedHoles.h"

namespace handwheel {

// A boundary loop of a sheet to thicken.
struct LoopOfSheet {
  HalfEdge at = kNone;  // a half-edge of the loop
  // If false, the thickness is limited to a fraction of the shortest edge, so that flakes do not become needles.
  bool isWanted = false;
};

// The result of thickenAt().
struct SheetTrial {
  std::vector<Face> faces;        // the added faces
  SheetThickness thickness;       // the reached thickness
  std::vector<bool> isThickened;  // one value per loop
};

// Thickens each sheet that has one of these loops, and relinks the mesh. thickness: the thickness of the sheets, mm.
SheetTrial thickenAt(HalfEdgeMesh& mesh, std::span<const LoopOfSheet> loops, double thickness, NumberType numbers,
                     Progress progress);

// Finds the positions at which faces touch without a common edge.
std::set<PointKey> touchingPositions(const HalfEdgeMesh& mesh, Progress progress);

// Separates the vertices at which faces touch without a common edge, except at known positions. Returns the former
// positions of the moved vertices, or nothing if faces still touch at a position that is not known. The mesh is
// relinked if it changes. O(n log n).
std::optional<std::vector<Vec3>> separateNewTouchings(HalfEdgeMesh& mesh, const std::set<PointKey>& known,
                                                      NumberType numbers, const SeparationLimits& limits,
                                                      Progress progress);

// Returns true if a face of the sheet has a corner at one of these positions.
bool hasCornerAmong(const HalfEdgeMesh& mesh, const std::vector<Face>& sheet, const std::set<PointKey>& positions);

// Counts the outcomes of the sheets to thicken, and records the failures of their holes. before is the mesh in which
// the holes were found. A sheet with several outer edges has the outcome of the first.
void countSheets(const HalfEdgeMesh& before, std::span<const ObstructedHole> holes,
                 const std::set<PointKey>& keptCorners, ObstructedClosings& closings);

}  // namespace handwheel
