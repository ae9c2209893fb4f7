// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/BoundaryWelding.h"

#include "mesh/search/MovedFaces.h"
#include "mesh/structure/EdgeCollapse.h"
#include "mesh/structure/PositionKey.h"

#include <algorithm>
#include <map>

namespace handwheel {
namespace {

struct Shift {
  Vertex from, onto;
};

// Moves vertices onto others, and pairs the boundaries that coincide then.
class Welding {
 public:
  Welding(const FaceLocator& near, std::vector<Shift> shifts)
      : m_near(near), m_mesh(near.mesh()), m_shifts(std::move(shifts)) {}

  BoundaryWeld run() {
    BoundaryWeld weld;
    for (const auto step : {&Welding::move, &Welding::checkCrossings, &Welding::pair}) {
      weld.problem = (this->*step)();
      if (weld.problem != JoinProblem::None) return weld;
    }
    weld.mesh = std::move(m_mesh);
    weld.changed = std::move(m_moved.faces);
    weld.shapes = soupOf(m_moved.shapes);
    return weld;
  }

 private:
  bool isMoved(Face f) const { return std::binary_search(m_moved.faces.begin(), m_moved.faces.end(), f); }

  JoinProblem move() {
    std::vector<Face>& faces = m_moved.faces;
    for (const Shift& s : m_shifts) {
      const Vec3 p = m_mesh.position(s.from);
      for (const HalfEdge h : m_near.leaving(p)) {
        if (m_mesh.from(h) != s.from)
          return JoinProblem::NonManifoldVertex;  // the vertex would be separated from what it touches
        faces.push_back(HalfEdgeMesh::face(h));
      }
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    for (const Face f : faces) {
      const TrianglePoints before = m_mesh.points(f);
      for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h)
        for (const Shift& s : m_shifts)
          if (m_near.mesh().from(h) == s.from) m_mesh.setCorner(h, s.onto);
      m_moved.shapes.push_back(m_mesh.points(f));
      if (!m_mesh.isProper(f) || isDegenerate(m_moved.shapes.back())) return JoinProblem::DegenerateFace;
      if (!mayBecome(before, m_moved.shapes.back())) return JoinProblem::FlippedFace;
    }
    return JoinProblem::None;
  }

  JoinProblem checkCrossings() {
    const bool isFree = forEachNewCrossing(m_near, m_moved, [](std::size_t) { return false; });
    return isFree ? JoinProblem::None : JoinProblem::Crosses;
  }

  // Returns the current half-edges at the positions that vertices were moved onto.
  std::vector<HalfEdge> around() const {
    std::vector<HalfEdge> all;
    const auto add = [&](Face f) {
      for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) all.push_back(h);
    };
    for (const Face f : m_moved.faces) add(f);
    for (const Shift& s : m_shifts)
      for (const HalfEdge h : m_near.leaving(m_mesh.position(s.onto)))
        if (!isMoved(HalfEdgeMesh::face(h))) add(HalfEdgeMesh::face(h));
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  // An edge that already had two faces is unrelated.
  JoinProblem pair() {
    const std::vector<HalfEdge> all = around();
    std::map<EdgeKey, std::vector<HalfEdge>> edges;
    for (const HalfEdge h : all) edges[positionKey(m_mesh, h)].push_back(h);
    for (const auto& [line, run] : edges) {
      const bool isNew =
          std::any_of(run.begin(), run.end(), [&](HalfEdge h) { return isMoved(HalfEdgeMesh::face(h)); });
      if (!isNew || run.size() == 1 || (run.size() == 2 && m_mesh.opposite(run[0]) == run[1])) continue;
      const bool canPair = run.size() == 2 && m_mesh.isBorder(run[0]) && m_mesh.isBorder(run[1]) &&
                           m_mesh.position(m_mesh.from(run[0])) == m_mesh.position(m_mesh.to(run[1]));
      if (!canPair) return JoinProblem::NonManifoldEdge;
      m_mesh.pair(run[0], run[1]);
    }
    return unite(all);
  }

  // Each fan gets one vertex; the number of vertices at the new positions must not grow.
  JoinProblem unite(const std::vector<HalfEdge>& all) {
    for (const HalfEdge h : all) {
      const std::vector<HalfEdge> fan = m_mesh.fan(h);
      Vertex kept = m_mesh.from(fan.front());
      for (const HalfEdge g : fan) kept = std::min(kept, m_mesh.from(g));
      for (const HalfEdge g : fan) m_mesh.setCorner(g, kept);
    }
    for (const Shift& s : m_shifts) {
      std::size_t leaving = 0;
      HalfEdge one = kNone;
      for (const HalfEdge h : all) {
        if (m_mesh.from(h) != s.onto) continue;
        one = h;
        ++leaving;
      }
      if (one != kNone && m_mesh.fan(one).size() != leaving) return JoinProblem::NonManifoldVertex;
    }
    return JoinProblem::None;
  }

  const FaceLocator& m_near;
  HalfEdgeMesh m_mesh;
  std::vector<Shift> m_shifts;
  MovedFaces m_moved;
};

// Shrinks a boundary edge to the position of one of its ends.
BoundaryWeld collapsed(const FaceLocator& near, HalfEdge h, Shift shift) {
  BoundaryWeld weld;
  const HalfEdgeMesh& mesh = near.mesh();
  const Vec3 &from = mesh.position(shift.from), &onto = mesh.position(shift.onto);
  if (!canCollapse(mesh, h)) weld.problem = JoinProblem::NonManifoldEdge;
  MovedFaces moved;
  for (const HalfEdge g : near.leaving(from)) {
    if (mesh.from(g) != shift.from) weld.problem = JoinProblem::NonManifoldVertex;
    weld.changed.push_back(HalfEdgeMesh::face(g));
  }
  std::sort(weld.changed.begin(), weld.changed.end());
  for (const Face f : weld.changed) {
    TrianglePoints t = mesh.points(f);
    if (f == HalfEdgeMesh::face(h)) t.fill(onto);  // the face is removed
    std::replace(t.begin(), t.end(), from, onto);
    if (f != HalfEdgeMesh::face(h) && !mayBecome(mesh.points(f), t)) weld.problem = JoinProblem::FlippedFace;
    moved.faces.push_back(f);
    moved.shapes.push_back(t);
  }
  const bool isFree = forEachNewCrossing(near, moved, [](std::size_t) { return false; });
  if (!isFree && weld.problem == JoinProblem::None) weld.problem = JoinProblem::Crosses;
  std::erase_if(moved.shapes, [](const TrianglePoints& t) { return t[0] == t[1]; });
  weld.shapes = soupOf(moved.shapes);
  if (weld.problem != JoinProblem::None) return weld;
  weld.mesh = mesh;
  collapseEdge(weld.mesh, h, onto);
  return weld;
}

}  // namespace

BoundaryWeld weldBoundary(const FaceLocator& near, const BoundaryPair& ends) {
  const HalfEdgeMesh& mesh = near.mesh();
  const Vertex v = mesh.from(ends.a), w = mesh.from(ends.b);
  BoundaryWeld weld;
  weld.problem = JoinProblem::SamePoint;
  if (mesh.position(v) == mesh.position(w)) return weld;
  if (mesh.to(ends.a) == w) return collapsed(near, ends.a, {v, w});
  if (mesh.to(ends.b) == v) return collapsed(near, ends.b, {v, w});
  // The neighbours that would meet: each with the one on the other side of the other point.
  std::vector<Shift> along = {{mesh.to(ends.a), mesh.from(previousOpen(mesh, ends.b))},
                              {mesh.from(previousOpen(mesh, ends.a)), mesh.to(ends.b)}};
  const auto distance = [&](const Shift& s) { return (mesh.position(s.onto) - mesh.position(s.from)).stableNorm(); };
  if (distance(along[1]) < distance(along[0])) std::swap(along[0], along[1]);
  for (const Shift& neighbour : along) {
    std::vector<Shift> shifts = {{v, w}};
    if (neighbour.from != neighbour.onto) shifts.push_back(neighbour);
    BoundaryWeld tried = Welding(near, shifts).run();
    if (tried.problem == JoinProblem::None) return tried;
    if (weld.problem == JoinProblem::SamePoint) weld = std::move(tried);
  }
  return weld;
}

}  // namespace handwheel
