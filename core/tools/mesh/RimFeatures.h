// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/SnapScene.h"
#include "mesh/BoundaryLoops.h"

namespace handwheel {

// What the hand is offered around the holes of a mesh, and at its outer edges: by the numbers of their vertices,
// half-edges, and loops in the list. On a worker. Empty once cancelled.
SnapScene rimFeatures(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, SnapOffer offer,
                      Progress progress = {});

}  // namespace handwheel
