// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"

namespace handwheel {

// Marks the outer boundary loops of open sheets. The longest loop of a shell is such a boundary if the shell faces one
// direction, is thin with a long outline, is frayed like a single-view scan, or has all its vertices on that loop. A
// patch over such a loop would be a lid as large as the sheet, or would cover the sheet with a second layer. Loops
// along which a one-sided surface was cut to be oriented are such boundaries, too: they are parts of one loop. If
// cancelled, no loop is marked. O(n).
void markSheetBoundaries(const HalfEdgeMesh& mesh, std::vector<BoundaryLoop>& loops, Progress progress = {});

}  // namespace handwheel
