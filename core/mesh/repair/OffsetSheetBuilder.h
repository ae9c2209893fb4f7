// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/repair/SheetThickening.h"
#include "mesh/repair/VertexOffsets.h"

#include <unordered_map>
#include <unordered_set>

namespace handwheel {

// The offset that defines the vertex behind a point of a sheet.
struct SheetOffset {
  Vec3 from;
  Vec3 direction;  // result of offsetBehind()
  double depth;    // factor of the direction
  double reach;    // distance behind the nearest plane of the faces, per unit of depth; at most 1
  Vertex front;    // vertex in front of it; kNone behind the middle of an edge or face
  bool isOnOutline;
  int halvings = 0;
};

// Builds the backs of thickened sheets and the side faces along their outlines. thickenSheets() uses it.
class OffsetSheetBuilder {
 public:
  // kept: the vertices that get no offset. It must outlive the object.
  OffsetSheetBuilder(HalfEdgeMesh& mesh, NumberType numbers, const std::unordered_set<Vertex>& kept)
      : m_mesh(mesh), m_numbers(numbers), m_kept(kept) {}

  // Adds the back of a sheet. Returns false, without a change, if the number type of the file cannot represent the
  // thickness.
  bool add(const OpenSheet& sheet);

  const std::vector<Face>& faces() const { return m_faces; }
  // Returns the pairs of a back face and its face in the sheet. Side faces, faces of a split back, and faces between
  // the parts of a divided back are in no pair, because no face is in front of them. If such a face flips, it
  // intersects others.
  const std::vector<std::pair<Face, Face>>& facePairs() const { return m_facePairs; }
  // Returns the offset of a back vertex; null for a vertex of a sheet.
  const SheetOffset* offsetOf(Vertex v) const;
  // Halves the depth of a vertex behind a sheet. Returns false if the depth was already halved too often.
  bool halve(Vertex v);
  // Returns the reached thickness of the faces that are still live.
  SheetThickness reached() const;

 private:
  struct Corner {
    std::vector<HalfEdge> fan;
    bool isOpen = false;
    VertexOffsets behind;
    std::array<double, 2> reaches{1.0, 1.0};  // SheetOffset::reach of each offset
    std::array<Vertex, 2> backs{kNone, kNone};

    bool stays() const { return behind.offsets.empty(); }
    std::size_t offsetOf(Face f) const;
  };

  Corner cornerOf(HalfEdge h) const;
  bool hasRoom() const;
  Vec3 positionOf(const SheetOffset& offset) const;
  Vertex behind(const SheetOffset& offset);
  Vertex back(Vertex v, Face f);
  Vertex middle(HalfEdge h);
  Face add(Vertex a, Vertex b, Vertex c);
  void cover(Face f);
  void coverWhole(Face f, const std::array<Vertex, 3>& v);
  void addSides(Face f);
  void closeGaps(Face f);

  HalfEdgeMesh& m_mesh;
  NumberType m_numbers;
  const std::unordered_set<Vertex>& m_kept;
  double m_thickness = 0.0;                         // thickness of the current sheet
  std::size_t m_vertices = 0, m_sharpVertices = 0;  // vertices of all sheets; those without offset
  std::unordered_map<Vertex, Corner> m_corners;     // corners of the current sheet
  std::unordered_map<HalfEdge, Vertex> m_middles;   // middles of the current sheet's edges, by the smaller half-edge
  std::unordered_map<Vertex, SheetOffset> m_offsets;
  std::vector<std::pair<Face, Face>> m_facePairs;
  std::vector<Face> m_faces;
};

// Returns the unit normal of a face; zero if it is degenerate.
Vec3 unitNormal(const HalfEdgeMesh& mesh, Face f);

}  // namespace handwheel
