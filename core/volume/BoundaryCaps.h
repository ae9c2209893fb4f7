// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"

namespace handwheel {

// Closes a welded soup: appends a cone from each boundary to the middle of it. A boundary are edges that are passed in
// one direction more often than in the other, joined where they share a point; each is passed back as often as needed.
// So every edge is then passed equally often both ways, whatever the soup was: holes, gaps and faces that are turned
// round, too, and winding numbers are whole. Returns the number of boundaries. O(n log n). The soup is as it was, with
// 0, when cancelled.
std::size_t closeBoundaries(TriangleSoup& welded, Progress progress = {});

}  // namespace handwheel
