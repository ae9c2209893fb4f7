// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/snap/LoopSnapField.h"
#include "mesh/boundary/BoundaryLoops.h"

namespace handwheel {

// Creates the snap features around the holes of a mesh and at its outer edges. Their ids are the indices of the
// vertices, the half-edges, and the loops in the list. May be called on a worker thread. The result is empty if
// cancelled.
LoopSnapField boundarySnapFeatures(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, SnapOffer offer,
                                   Progress progress = {});

}  // namespace handwheel
