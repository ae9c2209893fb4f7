// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/HalfEdgeMesh.h"

#include "mesh/structure/EdgeTable.h"

namespace handwheel {

bool HalfEdgeMesh::isProper(Face f) const {
  return isLive(f) && !hasRepeatedVertex(triangle(f));
}

bool HalfEdgeMesh::isBorder(HalfEdge h) const {
  return opposite(h) == static_cast<HalfEdge>(Open::Border) && isProper(face(h));
}

bool HalfEdgeMesh::isSeam(HalfEdge h) const {
  return opposite(h) == static_cast<HalfEdge>(Open::Seam) && isProper(face(h));
}

HalfEdge HalfEdgeMesh::nextOpen(HalfEdge h) const {
  HalfEdge g = next(h);
  while (hasOpposite(g)) g = next(opposite(g));
  return g;
}

std::vector<HalfEdge> HalfEdgeMesh::fan(HalfEdge h) const {
  constexpr std::size_t kUsual = 8;  // faces; six on average
  std::vector<HalfEdge> result;
  result.reserve(kUsual);
  visitFan(h, [&](HalfEdge g) { result.push_back(g); });
  return result;
}

HalfEdgeMesh::Compact HalfEdgeMesh::compact() const {
  Compact result;
  std::vector<std::uint32_t> number(vertexSlots(), kNone);
  for (Face f = 0; f < faceSlots(); ++f) {
    if (!isLive(f)) continue;
    Triangle t = triangle(f);
    for (std::uint32_t& v : t) {
      if (number[v] == kNone) {
        number[v] = static_cast<std::uint32_t>(result.vertexOf.size());
        result.vertexOf.push_back(v);
        result.soup.points.push_back(position(v));
      }
      v = number[v];
    }
    result.soup.triangles.push_back(t);
    result.faceOf.push_back(f);
  }
  return result;
}

TrianglePoints HalfEdgeMesh::points(Face f) const {
  const Triangle& t = triangle(f);
  return {position(t[0]), position(t[1]), position(t[2])};
}

Vertex HalfEdgeMesh::addVertex(const Vec3& p) {
  m_positions.push_back(p);
  return static_cast<Vertex>(m_positions.size() - 1);
}

Face HalfEdgeMesh::addSlot(const Triangle& corners, const std::array<HalfEdge, 3>& opposites) {
  const FaceSlot slot{corners, opposites};
  m_faces.push_back(slot);
  m_liveFaces += slot.isLive();
  return static_cast<Face>(m_faces.size() - 1);
}

Face HalfEdgeMesh::addFace(const Triangle& corners) {
  return addSlot(corners, FaceSlot().opposites);
}

void HalfEdgeMesh::setSlot(Face f, const FaceSlot& slot) {
  m_liveFaces = m_liveFaces - isLive(f) + slot.isLive();
  m_faces.set(f, slot);
}

void HalfEdgeMesh::removeFace(Face f) {
  for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
    if (hasOpposite(h)) setOpen(opposite(h), Open::Border);
  }
  setSlot(f, FaceSlot{});
}

void HalfEdgeMesh::setCorner(HalfEdge h, Vertex v) {
  if (from(h) == v) return;  // keeps the page shared
  FaceSlot slot = m_faces[face(h)];
  slot.corners[h % 3] = v;
  setSlot(face(h), slot);
}

void HalfEdgeMesh::truncate(std::size_t vertexSlots, std::size_t faceSlots) {
  for (std::size_t f = faceSlots; f < m_faces.size(); ++f) m_liveFaces -= m_faces[f].isLive();
  m_positions.truncate(vertexSlots);
  m_faces.truncate(faceSlots);
}

void HalfEdgeMesh::setTriangle(Face f, const Triangle& corners) {
  for (std::uint32_t k = 0; k < 3; ++k) setCorner(3 * f + k, corners[k]);
}

void HalfEdgeMesh::setOpposite(HalfEdge h, HalfEdge value) {
  if (opposite(h) == value) return;  // keeps the page shared
  FaceSlot slot = m_faces[face(h)];
  slot.opposites[h % 3] = value;
  m_faces.set(face(h), slot);
}

void HalfEdgeMesh::pair(HalfEdge a, HalfEdge b) {
  setOpposite(a, b);
  setOpposite(b, a);
}

void HalfEdgeMesh::setOpen(HalfEdge h, Open kind) {
  setOpposite(h, static_cast<HalfEdge>(kind));
}

}  // namespace handwheel
