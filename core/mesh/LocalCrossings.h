// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/HalfEdgeMesh.h"

#include <optional>
#include <utility>
#include <vector>

namespace handwheel {

// What a change of a mesh did to the pairs of faces that meet in more than they share.
struct CrossingsChange {
  std::vector<Face> touched;                   // by the change; rising
  std::vector<std::pair<Face, Face>> present;  // pairs, afterwards, with at least one of them
  std::size_t fresh = 0;                       // of these, how many the change made
};

// Looks near the touched faces only. A pair with faces that are new is none that the change made where it replaced
// faces that crossed before, as when a crossing patch is subdivided. Empty when cancelled. O(faces + k log k) for k
// faces in the box around the touched ones.
std::optional<CrossingsChange> crossingsChange(const HalfEdgeMesh& before, const HalfEdgeMesh& after,
                                               Progress progress = {});

// The pairs of the mesh after the change, as findSelfIntersections() gives them, from those before.
std::vector<std::pair<Face, Face>> crossingsAfter(const CrossingsChange& change,
                                                  const std::vector<std::pair<Face, Face>>& pairs);

}  // namespace handwheel
