// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/FaceJoining.h"

#include "mesh/search/IncrementalHierarchy.h"

#include <algorithm>

namespace handwheel {
namespace {

// Returns the half-edges of the mesh from one position to another.
std::vector<HalfEdge> between(const FaceLocator& near, const Vec3& from, const Vec3& to) {
  std::vector<HalfEdge> result = near.leaving(from);
  std::erase_if(result, [&](HalfEdge h) { return near.mesh().position(near.mesh().to(h)) != to; });
  return result;
}

// A side of a new triangle with the half-edge to pair it with.
struct Side {
  Vec3 from, to;
  HalfEdge opposite = static_cast<HalfEdge>(Open::Border);
};

class Joining {
 public:
  Joining(const HalfEdgeMesh& mesh, std::span<const Triangle> triangles, const FaceLocator& near)
      : m_mesh(mesh), m_triangles(triangles), m_near(near), m_first(static_cast<HalfEdge>(mesh.halfEdgeSlots())) {}

  JoinProblem run(HalfEdgeMesh& result) {
    for (const auto step : {&Joining::checkShapes, &Joining::findOpposites, &Joining::checkCrossings, &Joining::join}) {
      if (const JoinProblem problem = (this->*step)(); problem != JoinProblem::None) return problem;
    }
    result = std::move(m_mesh);
    return JoinProblem::None;
  }

 private:
  TrianglePoints points(const Triangle& t) const {
    return {m_mesh.position(t[0]), m_mesh.position(t[1]), m_mesh.position(t[2])};
  }

  JoinProblem checkShapes() {
    for (const Triangle& t : m_triangles) {
      const TrianglePoints p = points(t);
      if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) return JoinProblem::SamePoint;
      if (isDegenerate(p)) return JoinProblem::DegenerateFace;
      for (std::size_t k = 0; k < 3; ++k) m_sides.push_back({p[k], p[(k + 1) % 3]});
    }
    return JoinProblem::None;
  }

  JoinProblem findOpposites() {
    bool isInconsistent = false;
    for (std::size_t i = 0; i < m_sides.size(); ++i) {
      Side& side = m_sides[i];
      const auto along = between(m_near, side.from, side.to), against = between(m_near, side.to, side.from);
      std::size_t others = along.size() + against.size();
      if (!against.empty()) side.opposite = against.front();
      isInconsistent |= !along.empty();
      for (std::size_t k = 0; k < m_sides.size(); ++k) {
        if (k == i) continue;
        const bool same = m_sides[k].from == side.from && m_sides[k].to == side.to;
        const bool turned = m_sides[k].from == side.to && m_sides[k].to == side.from;
        if (turned) side.opposite = m_first + static_cast<HalfEdge>(k);
        isInconsistent |= same;
        others += same || turned;
      }
      if (others > 1 || (against.size() == 1 && !m_mesh.isBorder(against.front()))) return JoinProblem::NonManifoldEdge;
      if (along.size() == 1 && !m_mesh.isBorder(along.front())) return JoinProblem::NonManifoldEdge;
    }
    return isInconsistent ? JoinProblem::InconsistentOrientation : JoinProblem::None;
  }

  JoinProblem checkCrossings() {
    for (std::size_t i = 0; i < m_triangles.size(); ++i) {
      const TrianglePoints t = points(m_triangles[i]);
      for (std::size_t k = 0; k < i; ++k)
        if (trianglesMeet(t, points(m_triangles[k]))) return JoinProblem::Crosses;
      const bool isFree = m_near.forEachInBox(boxOf(t), [&](Face f) {
        const TrianglePoints other = m_mesh.points(f);
        return isDegenerate(other) || !trianglesMeet(t, other);
      });
      if (!isFree) return JoinProblem::Crosses;
    }
    return JoinProblem::None;
  }

  // Each old fan is completely in one new fan, so any of its vertices represents it.
  JoinProblem join() {
    for (const Triangle& t : m_triangles) m_mesh.addFace(t);
    for (HalfEdge i = 0; i < m_sides.size(); ++i)
      if (m_sides[i].opposite != static_cast<HalfEdge>(Open::Border)) m_mesh.pair(m_first + i, m_sides[i].opposite);
    for (HalfEdge h = m_first; h < m_mesh.halfEdgeSlots(); ++h) {
      const std::vector<HalfEdge> fan = m_mesh.fan(h);
      const auto old = std::find_if(fan.begin(), fan.end(), [&](HalfEdge g) { return g < m_first; });
      if (old == fan.end()) return JoinProblem::NonManifoldVertex;
      const Vertex v = m_mesh.from(*old);
      for (const HalfEdge g : fan) m_mesh.setCorner(g, v);
    }
    return JoinProblem::None;
  }

  HalfEdgeMesh m_mesh;
  std::span<const Triangle> m_triangles;
  const FaceLocator& m_near;
  HalfEdge m_first;
  std::vector<Side> m_sides;
};

}  // namespace

JoinProblem addFaces(HalfEdgeMesh& mesh, std::span<const Triangle> triangles, const FaceLocator& near) {
  return Joining(mesh, triangles, near).run(mesh);
}

}  // namespace handwheel
