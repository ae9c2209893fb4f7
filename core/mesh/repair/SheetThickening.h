// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"

#include <map>
#include <span>
#include <vector>

namespace handwheel {

// The thickness of thickened sheets, mm. It differs from vertex to vertex; 0 where an outline or fold stays sharp.
struct SheetThickness {
  double least = 0.0;
  double largest = 0.0;          // 0: nothing was thickened
  std::size_t vertices = 0;      // of the sheets
  std::size_t thinVertices = 0;  // at which the body is thinner than asked for

  void extend(const SheetThickness& other);
};

// What became of the sheets that were to be thickened.
struct SheetOutcomes {
  std::size_t thickened = 0;
  std::map<FillFailure, std::size_t> left;  // open, by the reason
  std::map<Vertex, FillFailure> leftLoops;  // the loops of these by keyOf(), each with the reason
  SheetThickness thickness;                 // of the thickened ones

  std::size_t leftCount() const;
  // Adds the outcomes of a later attempt at those that are left.
  void extend(const SheetOutcomes& later);
};

// A sheet to thicken.
struct OpenSheet {
  std::vector<Face> faces;  // live and proper, without a paired edge to any other face
  double thickness = 0.0;   // mm
};

// The result of thickenSheets().
struct ThickenedSheets {
  std::vector<Face> faces;        // the new ones
  SheetThickness thickness;       // that was reached
  std::vector<bool> isThickened;  // for each sheet; false where the numbers of the file cannot show the thickness
};

// Thickens open sheets into thin bodies by an offset copy of each, behind the side that its normals point to.
// The faces stay as they are. A copy with reversed orientation is offset by the thickness (offsetBehind()), and a strip
// of side faces joins the outlines of both. Where new faces intersect any other, or are turned over, their vertices
// come nearer to the sheet by halves, a few times; a face whose back lies on it then is removed with it. A vertex has
// no offset where that does not help at an outline, where outlines touch, or in a fold behind which no way leads: there
// both sides meet in a sharp edge, and edges and faces without an offset at any vertex get one in their middle. The new
// faces may still intersect others where the sheet is folded, or where others intersect or touch it. Leaves the mesh to
// be linked anew (relink()). O(n log n) for the mesh, as often as an offset is halved.
ThickenedSheets thickenSheets(HalfEdgeMesh& mesh, std::span<const OpenSheet> sheets, NumberType numbers,
                              Progress progress = {});

// The thickness of thickened sheets where nobody names one, mm: a share of the diagonal of the mesh's box.
double defaultSheetThickness(const Box& box);
double defaultSheetThickness(const HalfEdgeMesh& mesh);  // O(n)

// The thickness that a person is offered for sheets with outlines in these boxes, mm: a hundredth of the diagonal of
// the largest, to one digit in a unit of so many mm. No less than some tenfold of what separates near vertices of the
// part; the default without outlines of a finite size.
double proposedSheetThickness(std::span<const Box> outlines, const Box& part, double unit);

// Finds all faces connected with this one through paired edges, this one first.
std::vector<Face> sheetOf(const HalfEdgeMesh& mesh, Face f);

}  // namespace handwheel
