// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// Gives a sheet a back, which closes all of its open edges at once and makes it a thin body: a turned copy of its
// faces, set back from them by the thickness (mm), less at vertices with short edges, and joined to them at the open
// edges, which stay where they are. Edges and faces that have only open vertices get a vertex in their middle for that.
// sheet: live, proper faces that share no paired edge with any other face. Returns the new faces; they may cross others
// where the sheet bends sharply, or where others cross or touch it. Leaves the mesh to be linked anew (relink()).
// O(faces of the sheet).
std::vector<Face> backSheet(HalfEdgeMesh& mesh, const std::vector<Face>& sheet, double thickness, NumberType numbers);

// All faces that hang together with this one through paired edges, this one first.
std::vector<Face> sheetOf(const HalfEdgeMesh& mesh, Face f);

}  // namespace handwheel
