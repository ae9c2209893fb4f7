// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"

#include <map>
#include <span>
#include <vector>

namespace handwheel {

// The thickness of thickened sheets, mm. It differs between vertices and is 0 where an outline or fold stays sharp.
struct SheetThickness {
  double least = 0.0;
  double largest = 0.0;          // 0: nothing was thickened
  std::size_t vertices = 0;      // number of vertices of the sheets
  std::size_t thinVertices = 0;  // vertices at which the body is thinner than requested

  void extend(const SheetThickness& other);
};

// The outcomes of the sheets to thicken.
struct SheetOutcomes {
  std::size_t thickened = 0;
  std::map<FillFailure, std::size_t> left;  // number of sheets left open, by the reason
  std::map<Vertex, FillFailure> leftLoops;  // loops of these sheets by keyOf(), with the reason
  SheetThickness thickness;                 // thickness of the thickened sheets

  std::size_t leftCount() const;
  // Adds the outcomes of a later attempt at the remaining sheets.
  void extend(const SheetOutcomes& later);
};

// A sheet to thicken.
struct OpenSheet {
  std::vector<Face> faces;  // live and proper faces, without paired edges to other faces
  double thickness = 0.0;   // mm
};

// The result of thickenSheets().
struct ThickenedSheets {
  std::vector<Face> faces;        // the added faces
  SheetThickness thickness;       // the reached thickness
  std::vector<bool> isThickened;  // one value per sheet; false if the file cannot represent the thickness
};

// Thickens open sheets into thin bodies by an offset copy on the back of each. The faces stay as they are. A copy with
// reversed orientation is offset by the thickness (offsetBehind()), opposite to the normals, and a strip of side faces
// joins the outlines of both. If new faces intersect others or flip, the offsets of their vertices are halved a few
// times; a face whose back then coincides with it is removed together with its back. A vertex gets no offset if it is
// on an outline and halving does not help, if outlines touch at it, or if it is in a fold and no direction is behind
// the fold. At such vertices both sides meet in a sharp edge; edges and faces without an offset at any vertex get an
// offset in their middle. The new faces may still intersect others where the sheet is folded, or where others intersect
// or touch it. The caller must relink the mesh (relink()). O(n log n) for each halving of offsets.
ThickenedSheets thickenSheets(HalfEdgeMesh& mesh, std::span<const OpenSheet> sheets, NumberType numbers,
                              Progress progress = {});

// Returns the default thickness of thickened sheets, mm. It is a fraction of the diagonal of the mesh's box.
double defaultSheetThickness(const Box& box);
double defaultSheetThickness(const HalfEdgeMesh& mesh);  // O(n)

// Returns the thickness proposed to the user for sheets with outlines in these boxes, mm. It is a hundredth of the
// diagonal of the largest box, rounded to one digit in a unit of the given size (mm), and at least about ten times the
// distance of near vertices of the part. Returns the default if no outline has a finite size.
double proposedSheetThickness(std::span<const Box> outlines, const Box& part, double unit);

// Finds all faces that are connected with f through paired edges. f is the first.
std::vector<Face> sheetOf(const HalfEdgeMesh& mesh, Face f);

}  // namespace handwheel
