// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/TriangleSoup.h"

#include <vector>

namespace handwheel {

// Vertices whose positions differ but round to the same single-precision numbers weld when the file is read. That is
// harmless where it only closes a crack or flattens a sliver; where it would give an edge more than two faces, or two
// the same way, the vertices are parted again: each by one step of the number type, towards its own faces.
//
// exact and inFile are the same triangles, before and after rounding. Moves points of inFile and returns their indices;
// where no free place is next to a point it stays welded.
// Of no use once cancelled.
std::vector<std::uint32_t> partCollisions(const TriangleSoup& exact, TriangleSoup& inFile, Progress progress = {});

}  // namespace handwheel
