// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// The thickness of thickened sheets, mm. It differs from vertex to vertex.
struct SheetThickness {
  double least = 0.0;
  double largest = 0.0;  // 0: nothing was thickened

  void extend(const SheetThickness& other);
};

// The result of thickenSheets().
struct ThickenedSheets {
  std::vector<Face> faces;   // the new ones
  SheetThickness thickness;  // that was reached
};

// Thickens open sheets into thin bodies by an offset copy of each. A copy of its faces with reversed orientation is
// offset by the thickness (mm), at most by tolerance::kSheetOffsetEdge of the shortest edge at a vertex, and joined to
// them at the open edges, which stay where they are; this closes all of them at once. So does a vertex in a fold behind
// which no way leads. Edges and faces of which all vertices stay get a vertex in their middle. Where new faces
// intersect any other, their vertices come nearer to the sheet by halves, a few times; a face whose back lies on it
// then is removed with it. sheets: live, proper faces, each list without a paired edge to any other face. The new faces
// may still intersect others where the sheet is folded, or where others intersect or touch it. Leaves the mesh to be
// linked anew (relink()). O(n log n) for the mesh, as often as an offset is halved.
ThickenedSheets thickenSheets(HalfEdgeMesh& mesh, const std::vector<std::vector<Face>>& sheets, double thickness,
                              NumberType numbers, Progress progress = {});

// The thickness of thickened sheets where nobody names one, mm: a share of the diagonal of the mesh's box.
double defaultSheetThickness(const Box& box);
double defaultSheetThickness(const HalfEdgeMesh& mesh);  // O(n)

// Finds all faces connected with this one through paired edges, this one first.
std::vector<Face> sheetOf(const HalfEdgeMesh& mesh, Face f);

}  // namespace handwheel
