// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"

#include <vector>

namespace handwheel {

// Separates vertices that would wrongly weld after rounding to single precision. Vertices with different positions that
// round to the same single-precision numbers are welded when the file is read. Welding is harmless if it only closes a
// crack or flattens a sliver. If it would give an edge more than two faces, or two in the same direction, or join faces
// at a vertex only, the vertices are separated again: all but one move by one step of the number type, towards their
// own faces.
//
// exact and inFile: the same triangles before and after rounding. Moves points of inFile and returns their indices. A
// point without a free position next to it stays welded. The result is invalid after a cancellation.
std::vector<std::uint32_t> separateRoundedVertices(const TriangleSoup& exact, TriangleSoup& inFile,
                                                   Progress progress = {});

}  // namespace handwheel
