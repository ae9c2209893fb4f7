// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HoleFilling.h"
#include "tools/mesh/MeshServices.h"

#include <utility>
#include <vector>

namespace handwheel {

// One change for each kind of defect, with its step; each touches what it mends and its surroundings only.

MeshChange degenerateFix();
MeshChange duplicateFix();
// Merges the pairs that are still near each other; all there are, when none is given.
MeshChange nearVertexFix(double nearWeld, std::vector<std::pair<Vertex, Vertex>> pairs = {});
// Moves what only touches apart by the last digits: edges with more than two faces and parts that hang at a tip.
MeshChange nonManifoldFix(NumberType numbers);
// Cuts parts with one side only along short ways until they have two, and closes the cuts.
MeshChange oneSidedFix(const FillOptions& options);
// Cuts what crosses, and joins it so that it does not. Pairs: as findSelfIntersections() gives them.
MeshChange crossingFix(NumberType numbers, std::vector<std::pair<Face, Face>> pairs);
// Loose pieces: those that contain one of these faces.
MeshChange debrisFix(std::vector<Face> faces);
// All that findDefects() calls debris.
MeshChange allDebrisFix();
// Loops, known by their smallest vertex (keyOf()): each sheet that they are the outer edge of becomes a thin body.
MeshChange backFix(std::vector<Vertex> loops, const FillOptions& options);
// A loop that every patch would cross the part to close: closed all the same, and cut apart where it crosses.
MeshChange cutAndCloseFix(Vertex loop, const FillOptions& options);

}  // namespace handwheel
