// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/Submesh.h"

#include "mesh/search/IncrementalHierarchy.h"
#include "mesh/structure/MeshBuilder.h"

#include <algorithm>
#include <unordered_map>

namespace handwheel {

namespace {

Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

}  // namespace

Submesh::Submesh(const HalfEdgeMesh& whole, const Box& box) {
  std::unordered_map<Vertex, Vertex> vertexIn;
  for (Face f = 0; f < whole.faceSlots(); ++f) {
    if (!whole.isLive(f) || !boxOf(whole.points(f)).intersects(box)) continue;
    Triangle corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex v = whole.triangle(f)[k];
      const auto [it, isNew] = vertexIn.emplace(v, static_cast<Vertex>(m_mesh.vertexSlots()));
      if (isNew) m_mesh.addVertex(whole.position(v));
      corners[k] = it->second;
    }
    m_mesh.addFace(corners);
    m_faceOf.push_back(f);
  }
  relink(m_mesh);  // at its edge a vertex may have more fans now
  m_vertexOf.assign(m_mesh.vertexSlots(), kNone);
  for (Face f = 0; f < m_mesh.faceSlots(); ++f) {
    for (const Vertex v : m_mesh.triangle(f)) {
      for (const Vertex w : whole.triangle(m_faceOf[f]))
        if (whole.position(w) == m_mesh.position(v)) m_vertexOf[v] = w;
    }
  }
}

HalfEdge Submesh::halfEdgeOf(const HalfEdgeMesh& whole, HalfEdge h) const {
  const auto it = std::lower_bound(m_faceOf.begin(), m_faceOf.end(), HalfEdgeMesh::face(h));
  if (it == m_faceOf.end() || *it != HalfEdgeMesh::face(h)) return kNone;
  const Vec3 &from = whole.position(whole.from(h)), &to = whole.position(whole.to(h));
  const HalfEdge first = 3 * static_cast<HalfEdge>(it - m_faceOf.begin());
  for (HalfEdge own = first; own < first + 3; ++own)
    if (m_mesh.position(m_mesh.from(own)) == from && m_mesh.position(m_mesh.to(own)) == to) return own;
  return kNone;
}

Box Submesh::changesIn(const HalfEdgeMesh& changed) const {
  Box box;
  for (Face f = 0; f < changed.faceSlots(); ++f) {
    const bool was = f < m_mesh.faceSlots(), is = changed.isLive(f);
    if (was && is && m_mesh.points(f) == changed.points(f)) continue;
    if (was) box.extend(boxOf(m_mesh.points(f)));
    if (is) box.extend(boxOf(changed.points(f)));
  }
  return box;
}

void Submesh::writeBack(HalfEdgeMesh& whole, const HalfEdgeMesh& changed) const {
  std::vector<Vertex> vertexOf = m_vertexOf;
  vertexOf.resize(changed.vertexSlots(), kNone);
  const auto vertex = [&](Vertex v) {
    if (vertexOf[v] == kNone) vertexOf[v] = whole.addVertex(changed.position(v));
    return vertexOf[v];
  };
  for (Vertex v = 0; v < m_mesh.vertexSlots(); ++v) {
    if (m_vertexOf[v] != kNone && m_mesh.position(v) != changed.position(v))
      whole.setPosition(m_vertexOf[v], changed.position(v));
  }
  for (Face f = 0; f < changed.faceSlots(); ++f) {
    const bool was = f < m_mesh.faceSlots(), is = changed.isLive(f);
    if (was && !is) whole.removeFace(m_faceOf[f]);
    if (!is) continue;
    const Triangle& t = changed.triangle(f);
    const Triangle corners = {vertex(t[0]), vertex(t[1]), vertex(t[2])};
    if (!was) {
      whole.addFace(corners);
    } else if (sorted(corners) != sorted(whole.triangle(m_faceOf[f]))) {  // also where fans have exchanged vertices
      whole.setTriangle(m_faceOf[f], corners);
    }
  }
}

}  // namespace handwheel
