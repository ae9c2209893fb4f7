// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/PagedArray.h"
#include "mesh/structure/TriangleSoup.h"
#include "proximity/TriangleIntersection.h"

namespace handwheel {

using Vertex = std::uint32_t;
using Face = std::uint32_t;
using HalfEdge = std::uint32_t;

// The kinds of half-edges without an opposite.
enum class Open : std::uint32_t {
  Border = kNone,  // no other face at the edge: the surface ends at it
  // The faces at the edge are unpaired: it has more than two faces in the file, or the surface is non-orientable
  // (Möbius strip). A seam is not a hole by itself, but the loop of a hole may run along it.
  Seam = kNone - 1,
};

// An oriented manifold triangle mesh as a half-edge structure. Every vertex has one fan of faces and every edge has at
// most two faces. It is the directed edge structure of Campagna, Kobbelt, Seidel, "Directed Edges" (1998): half-edge h
// belongs to face h / 3, runs from corner h % 3 to the next, and stores its opposite. All three arrays are paged and
// shared between copies, so a copy is a cheap snapshot and two versions are compared page by page (MeshDelta). Faces
// and vertices never change their numbers: removed ones leave a dead slot. A face with a repeated vertex is kept but
// connects nothing: its half-edges have no opposite and are not border.
class HalfEdgeMesh {
 public:
  std::size_t vertexSlots() const { return m_positions.size(); }
  std::size_t faceSlots() const { return m_faces.size(); }
  std::size_t halfEdgeSlots() const { return 3 * m_faces.size(); }

  const Vec3& position(Vertex v) const { return m_positions[v]; }
  const Triangle& triangle(Face f) const { return m_faces[f].corners; }
  bool isLive(Face f) const { return m_faces[f].isLive(); }
  // Returns true if all three corners differ, so that the face is part of the surface.
  bool isProper(Face f) const;

  static Face face(HalfEdge h) { return h / 3; }
  static HalfEdge next(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static HalfEdge previous(HalfEdge h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Vertex from(HalfEdge h) const { return m_faces[h / 3].corners[h % 3]; }
  Vertex to(HalfEdge h) const { return from(next(h)); }
  // Returns the half-edge of the neighbour, or a value of Open.
  HalfEdge opposite(HalfEdge h) const { return m_faces[h / 3].opposites[h % 3]; }
  bool hasOpposite(HalfEdge h) const { return opposite(h) < static_cast<std::uint32_t>(Open::Seam); }
  bool isBorder(HalfEdge h) const;
  bool isSeam(HalfEdge h) const;

  // Returns the next open half-edge along the rim, walking around the end vertex of h. h must be open and proper.
  HalfEdge nextOpen(HalfEdge h) const;

  // Returns the half-edges that start at the vertex of h in its fan of faces, counter-clockwise, starting with the open
  // one if there is one. h must be proper.
  std::vector<HalfEdge> fan(HalfEdge h) const;
  // Calls visit with each half-edge of fan(h), without allocating memory.
  template <class Visit>
  void visitFan(HalfEdge h, Visit visit) const;
  TrianglePoints points(Face f) const;

  std::size_t liveFaceCount() const { return m_liveFaces; }
  // The live faces and the vertices they use, renumbered without gaps; faceOf[i] is the face of triangle i.
  struct Compact {
    TriangleSoup soup;
    std::vector<Face> faceOf;
    std::vector<Vertex> vertexOf;
  };
  Compact compact() const;

  // Low-level changes. The caller must restore consistency, or call relink() (MeshBuilder.h). A sequence of changes
  // must end with a mesh that validate() (MeshValidator.h) accepts.
  Vertex addVertex(const Vec3& p);
  void setPosition(Vertex v, const Vec3& p) { m_positions.set(v, p); }
  Face addFace(const Triangle& corners);
  // Adds a face with its neighbours, or a dead slot, as read from a file.
  Face addSlot(const Triangle& corners, const std::array<HalfEdge, 3>& opposites);
  void removeFace(Face f);  // the half-edges of its neighbours become border
  // Removes the slots from these numbers on. The mesh must have at least these numbers of slots.
  void truncate(std::size_t vertexSlots, std::size_t faceSlots);
  void setCorner(HalfEdge h, Vertex v);
  void setTriangle(Face f, const Triangle& corners);
  void setOpposite(HalfEdge h, HalfEdge value);
  void pair(HalfEdge a, HalfEdge b);
  void setOpen(HalfEdge h, Open kind);

 private:
  friend class MeshDelta;

  struct FaceSlot {
    Triangle corners{kNone, kNone, kNone};
    std::array<HalfEdge, 3> opposites{kNone, kNone, kNone};
    bool isLive() const { return corners[0] != kNone; }
    bool operator==(const FaceSlot&) const = default;
  };
  void setSlot(Face f, const FaceSlot& slot);

  PagedArray<Vec3> m_positions;
  PagedArray<FaceSlot> m_faces;
  std::size_t m_liveFaces = 0;
};

template <class Visit>
void HalfEdgeMesh::visitFan(HalfEdge h, Visit visit) const {
  HalfEdge first = h;
  while (hasOpposite(first)) {
    first = next(opposite(first));
    if (first == h) break;
  }
  for (HalfEdge g = first;;) {
    visit(g);
    const HalfEdge back = previous(g);
    if (!hasOpposite(back)) break;
    g = opposite(back);
    if (g == first) break;
  }
}

}  // namespace handwheel
