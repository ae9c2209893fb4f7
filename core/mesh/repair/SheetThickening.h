// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// Thickens an open sheet into a thin body by an offset copy. A copy of its faces with reversed orientation is offset by
// the thickness (mm), less at vertices with short edges, and joined to them at the open edges, which stay where they
// are; this closes all of them at once. Edges and faces that have only open vertices get a vertex in their middle for
// that. sheet: live, proper faces that share no paired edge with any other face. Returns the new faces; they may
// intersect others where the sheet bends sharply, or where others intersect or touch it. Leaves the mesh to be linked
// anew (relink()). O(faces of the sheet).
std::vector<Face> thickenSheet(HalfEdgeMesh& mesh, const std::vector<Face>& sheet, double thickness,
                               NumberType numbers);

// Finds all faces connected with this one through paired edges, this one first.
std::vector<Face> sheetOf(const HalfEdgeMesh& mesh, Face f);

}  // namespace handwheel
