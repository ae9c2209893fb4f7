// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/BoundaryLoops.h"
#include "mesh/FaceSelection.h"

#include <span>

namespace handwheel {

// The islands of a hole: open pieces of surface that float in it. A piece is one when
//  - it hangs on the faces around the hole by no edge, and has fewer faces than they and what hangs on them;
//  - seen along the hole's mean normal, all of its vertices lie inside the hole's outline;
//  - none is further from the hole's mean plane than the hole's own points are, by more than a quarter of the hole's
//    width: on a curved surface it bulges so far.
// A closed shell is no island, but debris or a part of its own; a rim surrounds its sheet and has none. loops: those of
// the mesh. Of no use once cancelled. O(all loops + faces of what lies in the hole).
FaceSelection findIslands(const HalfEdgeMesh& mesh, const BoundaryLoop& hole, std::span<const BoundaryLoop> loops,
                          Progress progress = {});

}  // namespace handwheel
