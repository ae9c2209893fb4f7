// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"

#include <vector>

namespace handwheel {

// Separates vertices that would wrongly weld after rounding to single precision. Vertices with different positions that
// round to the same single-precision numbers weld when the file is read. That is harmless if it only closes a crack or
// flattens a sliver; if it would give an edge more than two faces, or two in the same direction, or join faces at a
// vertex only, the vertices are separated again: each by one step of the number type, towards its own faces.
//
// exact and inFile are the same triangles, before and after rounding. Moves points of inFile and returns their indices;
// a point without a free position next to it stays welded. The result is invalid if cancelled.
std::vector<std::uint32_t> separateRoundedVertices(const TriangleSoup& exact, TriangleSoup& inFile,
                                                   Progress progress = {});

}  // namespace handwheel
