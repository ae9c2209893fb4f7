// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel {

// Finds the crumbs of a scan, which are no part of a solid. Crumbs are shells with less than tolerance::kDebrisArea of
// the area and tolerance::kDebrisFaces of the faces of the largest shell. Islands of holes (findIslands()) with at
// least tolerance::kCrumbFaces faces are none: they belong to the surface that is missing around them. Returns their
// faces. The result is incomplete if cancelled.
std::vector<Face> findCrumbs(const HalfEdgeMesh& mesh, Progress progress = {});

// Finds the loose sheets of a scan: open sheets (BoundaryLoop::isSheetBoundary) with at most a fifth of the area of the
// largest shell. Closed by a lid, each would be a body of its own beside the part. Returns their faces. The result is
// incomplete if cancelled. O(n log n).
std::vector<Face> findLooseSheets(const HalfEdgeMesh& mesh, Progress progress = {});

// Finds the fringes of ragged holes: triangles with two or three border edges, along loops of which these are at least
// a tenth of the edges. Returns their faces. O(n).
std::vector<Face> findFringes(const HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
