// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// Pairs of faces that meet, as a file of these numbers shows the mesh. 0 once cancelled.
std::size_t countCrossings(const HalfEdgeMesh& mesh, NumberType numbers, Progress progress = {});

// The faces that meet these, as such a file shows the mesh, those that meet them, and so on. None once cancelled.
std::vector<Face> crossingCluster(const HalfEdgeMesh& mesh, const std::vector<Face>& faces, NumberType numbers,
                                  Progress progress = {});

struct UncrossReport {
  bool changed = false;             // else the mesh is as it was
  std::size_t cutFaces = 0;         // of the mesh before; tried, when not changed
  std::size_t crossingsBefore = 0;  // pairs of faces that meet, in the whole mesh, as numbers round it
  std::size_t crossingsAfter = 0;
};

// Cuts the faces that meet others along where they meet (cutAtCrossings()) and joins the pieces the other way: where
// two sheets crossed, two now touch along the cut, each on its side, and are parted by the last digits
// (partDuplicates()), so that every piece of the surface stays where it was and nothing crosses. Begins with these
// faces and takes in whatever crosses what it has to cut. Given up, with the mesh as it was, when that is too much
// (tolerance::kUncrossPairs), when the result would have more crossings than allowed, or once cancelled.
// Needs O(n) for the mesh beside O(m log m) for m crossings.
UncrossReport uncross(HalfEdgeMesh& mesh, const std::vector<Face>& faces, NumberType numbers, std::size_t allowed,
                      Progress progress = {});
// The same; allowed are the crossings that have nothing to do with these faces.
UncrossReport uncrossAll(HalfEdgeMesh& mesh, const std::vector<Face>& faces, NumberType numbers,
                         Progress progress = {});

}  // namespace handwheel
