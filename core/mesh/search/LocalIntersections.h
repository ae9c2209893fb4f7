// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <optional>
#include <utility>
#include <vector>

namespace handwheel {

// The effect of a mesh change on the self-intersecting pairs of faces.
struct IntersectionsChange {
  std::vector<Face> touched;                   // by the change; rising
  std::vector<std::pair<Face, Face>> present;  // pairs, afterwards, with at least one of them
  std::size_t fresh = 0;                       // of these, how many the change made
};

// Finds the self-intersections that a change of a mesh made. Searches near the touched faces only. A pair with new
// faces does not count as made by the change where it replaced faces that intersected before, as when an intersecting
// patch is subdivided. Empty when cancelled. O(faces + k log k) for k faces in the box around the touched ones.
std::optional<IntersectionsChange> intersectionsChange(const HalfEdgeMesh& before, const HalfEdgeMesh& after,
                                                       Progress progress = {});

// Computes the intersecting pairs after a change from those before, as findSelfIntersections() gives them.
std::vector<std::pair<Face, Face>> intersectionsAfter(const IntersectionsChange& change,
                                                      const std::vector<std::pair<Face, Face>>& pairs);

}  // namespace handwheel
