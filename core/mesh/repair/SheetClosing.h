// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/repair/CoincidentVertexSeparation.h"
#include "mesh/repair/ObstructedHoles.h"

namespace handwheel {

// One boundary loop of a sheet that is to be thickened.
struct LoopOfSheet {
  HalfEdge at = kNone;    // of the loop
  bool isWanted = false;  // else the sheet gets no more than a share of its shortest edge: a flake is no needle then
};

// The result of thickenAt().
struct SheetTrial {
  std::vector<Face> faces;        // the new ones
  SheetThickness thickness;       // that was reached
  std::vector<bool> isThickened;  // for each loop
};

// Thickens the sheets that have these loops, each once, and links the mesh anew. thickness: mm.
SheetTrial thickenAt(HalfEdgeMesh& mesh, std::span<const LoopOfSheet> loops, double thickness, NumberType numbers,
                     Progress progress);

// The places at which faces touch without a common edge.
std::set<PointKey> touchingPlaces(const HalfEdgeMesh& mesh, Progress progress);

// Separates the vertices at which faces touch without a common edge, except at known places. Returns where the vertices
// were that it moved; none where such a vertex remains. The mesh is linked anew if it is changed. O(n log n).
std::optional<std::vector<Vec3>> separateNewTouchings(HalfEdgeMesh& mesh, const std::set<PointKey>& known,
                                                      NumberType numbers, const SeparationLimits& limits,
                                                      Progress progress);

// Whether a face of the sheet has a corner at one of these places.
bool hasCornerAmong(const HalfEdgeMesh& mesh, const std::vector<Face>& sheet, const std::set<PointKey>& places);

// Counts what became of the sheets that were to be thickened, and notes why not for each of their holes. before: the
// mesh in which the holes were found. A sheet with several outer edges has the outcome of the first.
void countSheets(const HalfEdgeMesh& before, std::span<const ObstructedHole> holes,
                 const std::set<PointKey>& keptCorners, ObstructedClosings& closings);

}  // namespace handwheel
