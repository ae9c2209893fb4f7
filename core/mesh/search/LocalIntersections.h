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
  std::vector<Face> touched;                   // faces touched by the change, ascending
  std::vector<std::pair<Face, Face>> present;  // pairs after the change with at least one touched face
  std::size_t fresh = 0;                       // number of these pairs that the change made
};

// Finds the self-intersections that a change of a mesh made. Only the surroundings of the touched faces are searched. A
// pair with added faces does not count as made by the change if it replaces faces that intersected before, for example
// after an intersecting patch is subdivided. Returns nothing if cancelled. O(faces + k log k) for k faces in the box
// around the touched ones.
std::optional<IntersectionsChange> intersectionsChange(const HalfEdgeMesh& before, const HalfEdgeMesh& after,
                                                       Progress progress = {});

// Computes the intersecting pairs after a change from the pairs before it, which findSelfIntersections() found.
std::vector<std::pair<Face, Face>> intersectionsAfter(const IntersectionsChange& change,
                                                      const std::vector<std::pair<Face, Face>>& pairs);

}  // namespace handwheel
