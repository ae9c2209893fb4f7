// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/openmesh/OpenMeshCopy.h"

#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/EdgeTable.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace handwheel {
namespace {

bool isBackToBack(const HalfEdgeMesh& mesh, Face f) {
  const HalfEdge h = 3 * f;
  for (HalfEdge g = h; g < h + 3; ++g)
    if (!mesh.hasOpposite(g)) return false;
  const Face other = HalfEdgeMesh::face(mesh.opposite(h));
  return HalfEdgeMesh::face(mesh.opposite(h + 1)) == other && HalfEdgeMesh::face(mesh.opposite(h + 2)) == other;
}

OpenMeshRefusal refusalOf(const HalfEdgeMesh& mesh, const HalfEdgeMesh::Compact& compact, const Progress& progress) {
  for (const Face f : compact.faceOf) {
    if (!mesh.isProper(f)) return OpenMeshRefusal::Degenerate;
    if (isBackToBack(mesh, f)) return OpenMeshRefusal::BackToBack;
  }
  const EdgeTable edges(compact.soup.triangles, compact.soup.points.size(), progress.part(0.0, 0.5));
  const auto ours = [&](std::uint32_t h) { return 3 * compact.faceOf[h / 3] + h % 3; };
  bool isDouble = false;
  edges.forEachEdge(
      [&](std::uint32_t, std::uint32_t, std::span<const EdgeTable::Entry> uses) {
        isDouble = isDouble || uses.size() > 2 ||
                   (uses.size() == 2 && mesh.opposite(ours(uses[0].halfEdge)) != ours(uses[1].halfEdge));
      },
      progress.part(0.5, 1.0));
  return isDouble ? OpenMeshRefusal::DoubleEdge : OpenMeshRefusal::None;
}

bool sameBits(const Vec3& a, const Vec3& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

// Returns the corners in the order in which most of them are unchanged.
Triangle likeBefore(const Triangle& corners, const Triangle& before) {
  Triangle best = corners;
  int most = -1;
  for (std::size_t turn = 0; turn < 3; ++turn) {
    const Triangle turned{corners[turn], corners[(turn + 1) % 3], corners[(turn + 2) % 3]};
    int same = 0;
    for (std::size_t k = 0; k < 3; ++k) same += turned[k] == before[k];
    if (same > most) best = turned;
    most = std::max(most, same);
  }
  return best;
}

}  // namespace

OpenMeshRefusal OpenMeshCopy::take(const HalfEdgeMesh& mesh, Progress progress) {
  HalfEdgeMesh::Compact compact = mesh.compact();
  const OpenMeshRefusal refusal = refusalOf(mesh, compact, progress.part(0.0, 0.5));
  if (refusal != OpenMeshRefusal::None || progress.cancelled()) return refusal;
  m_faceOf = std::move(compact.faceOf);
  m_vertexOf = std::move(compact.vertexOf);
  m_surface.add_property(m_isSeam);
  m_surface.reserve(m_vertexOf.size(), m_faceOf.size() * 3 / 2 + 1, m_faceOf.size());
  for (const Vec3& p : compact.soup.points) m_surface.add_vertex(openMeshPoint(p));
  link(mesh, compact.soup.triangles, progress.part(0.5, 1.0));
  return OpenMeshRefusal::None;
}

// Not by add_face(), whose time for a vertex goes with the square of its faces: all neighbours are known.
bool OpenMeshCopy::link(const HalfEdgeMesh& mesh, std::span<const Triangle> triangles, const Progress& progress) {
  std::vector<OpenMesh::HalfedgeHandle> handleOf(mesh.halfEdgeSlots());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (!pollProgress(i, triangles.size(), progress.part(0.0, 0.5))) return false;
    const auto face = m_surface.new_face();
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge h = 3 * m_faceOf[i] + k;
      const OpenMesh::VertexHandle from{static_cast<int>(triangles[i][k])},
          to{static_cast<int>(triangles[i][(k + 1) % 3])};
      if (!handleOf[h].is_valid()) {
        handleOf[h] = m_surface.new_edge(from, to);
        if (mesh.hasOpposite(h)) handleOf[mesh.opposite(h)] = m_surface.opposite_halfedge_handle(handleOf[h]);
      }
      m_surface.set_face_handle(handleOf[h], face);
      m_surface.set_halfedge_handle(from, handleOf[h]);
      if (k > 0) m_surface.set_next_halfedge_handle(handleOf[h - 1], handleOf[h]);
    }
    const HalfEdge first = 3 * m_faceOf[i];
    m_surface.set_next_halfedge_handle(handleOf[first + 2], handleOf[first]);
    m_surface.set_halfedge_handle(face, handleOf[first]);
  }
  // At rims, each open half-edge gets an opposite without a face, from which its end vertex starts, as OpenMesh
  // requires.
  for (std::size_t i = 0; i < m_faceOf.size(); ++i) {
    if (!pollProgress(i, triangles.size(), progress.part(0.5, 1.0))) return false;
    for (HalfEdge h = 3 * m_faceOf[i]; h < 3 * m_faceOf[i] + 3; ++h) {
      if (mesh.hasOpposite(h)) continue;
      const auto beyond = m_surface.opposite_halfedge_handle(handleOf[h]);
      m_surface.set_next_halfedge_handle(m_surface.opposite_halfedge_handle(handleOf[mesh.nextOpen(h)]), beyond);
      m_surface.set_halfedge_handle(m_surface.to_vertex_handle(handleOf[h]), beyond);
      if (!mesh.isSeam(h)) continue;
      setSeam(m_surface.edge_handle(handleOf[h]));
      m_hasSeams = true;
    }
  }
  return true;
}

Triangle OpenMeshCopy::cornersOf(OpenMesh::FaceHandle f, std::span<const Vertex> vertexOf) const {
  Triangle corners;
  auto h = m_surface.halfedge_handle(f);
  for (Vertex& v : corners) {
    v = vertexOf[std::size_t(m_surface.from_vertex_handle(h).idx())];
    h = m_surface.next_halfedge_handle(h);
  }
  return corners;
}

bool OpenMeshCopy::bringBack(HalfEdgeMesh& mesh, Progress progress) const {
  HalfEdgeMesh next = mesh;
  std::vector<Vertex> vertexOf = m_vertexOf;
  vertexOf.resize(m_surface.n_vertices(), kNone);
  for (std::size_t i = 0; i < vertexOf.size(); ++i) {
    if (!pollProgress(i, vertexOf.size(), progress.part(0.0, 0.2))) return false;
    const OpenMesh::VertexHandle v{int(i)};
    if (!m_surface.halfedge_handle(v).is_valid() || m_surface.status(v).deleted()) continue;
    const Vec3 p = pointOf(m_surface.point(v));
    if (vertexOf[i] == kNone) {
      vertexOf[i] = next.addVertex(p);
    } else if (!sameBits(next.position(vertexOf[i]), p)) {
      next.setPosition(vertexOf[i], p);
    }
  }
  for (std::size_t i = 0; i < m_faceOf.size(); ++i)
    if (m_surface.status(OpenMesh::FaceHandle(int(i))).deleted()) next.removeFace(m_faceOf[i]);
  std::vector<HalfEdge> halfEdgeOf(m_surface.n_halfedges(), kNone);
  for (std::size_t i = 0; i < m_surface.n_faces(); ++i) {
    if (!pollProgress(i, m_surface.n_faces(), progress.part(0.2, 0.7))) return false;
    const OpenMesh::FaceHandle f{int(i)};
    if (m_surface.status(f).deleted()) continue;
    const bool isNew = i >= m_faceOf.size();
    Triangle corners = cornersOf(f, vertexOf);
    if (!isNew) corners = likeBefore(corners, next.triangle(m_faceOf[i]));
    const Face slot = isNew ? next.addFace(corners) : m_faceOf[i];
    if (!isNew) next.setTriangle(slot, corners);
    auto h = m_surface.halfedge_handle(f);
    while (vertexOf[std::size_t(m_surface.from_vertex_handle(h).idx())] != corners[0])
      h = m_surface.next_halfedge_handle(h);
    for (std::uint32_t k = 0; k < 3; ++k, h = m_surface.next_halfedge_handle(h))
      halfEdgeOf[std::size_t(h.idx())] = 3 * slot + k;
  }
  for (std::size_t i = 0; i < halfEdgeOf.size(); i += 2) {
    if (!pollProgress(i / 2, halfEdgeOf.size() / 2, progress.part(0.7, 1.0))) return false;
    const HalfEdge a = halfEdgeOf[i], b = halfEdgeOf[i + 1];
    if (a != kNone && b != kNone) {
      next.pair(a, b);
    } else if (a != b) {
      next.setOpen(a == kNone ? b : a, isSeam(OpenMesh::EdgeHandle(int(i / 2))) ? Open::Seam : Open::Border);
    }
  }
  mesh = std::move(next);
  return true;
}

}  // namespace handwheel
