// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/VertexPull.h"

#include <algorithm>
#include <utility>

namespace handwheel {
namespace {

// Places of the way looked at for the first that is not allowed, and again between it and the one before; fewer where
// there are many faces, so that the pointer is followed.
constexpr std::size_t kMostPlaces = 32, kLeastPlaces = 2, kMostLooks = 2000;

}  // namespace

VertexPull::VertexPull(std::shared_ptr<const NearFaces> near, Vertex v)
    : m_near(std::move(near)), m_start(m_near->mesh().position(v)) {
  for (const HalfEdge h : m_near->leaving(m_start)) {
    m_vertices.push_back(m_near->mesh().from(h));
    m_faces.push_back(HalfEdgeMesh::face(h));
  }
  for (auto* list : {&m_vertices, &m_faces}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  for (const Face f : m_faces) m_before.push_back(m_near->mesh().points(f));
}

std::vector<TrianglePoints> VertexPull::shapes(const Vec3& place) const {
  std::vector<TrianglePoints> result = m_before;
  for (TrianglePoints& t : result) std::replace(t.begin(), t.end(), m_start, place);
  return result;
}

JoinProblem VertexPull::problemAt(const Vec3& place, const NearFaces& near) const {
  const MovedFaces moved{m_faces, shapes(place)};
  for (std::size_t i = 0; i < m_faces.size(); ++i)
    if (!mayBecome(m_before[i], moved.shapes[i])) return JoinProblem::TurnsOver;
  const bool isFree = forEachNewCrossing(near, moved, [](std::size_t) { return false; });
  return isFree ? JoinProblem::None : JoinProblem::Crosses;
}

VertexPull::Place VertexPull::towards(const Vec3& target) const {
  if (!target.allFinite() || m_faces.empty()) return {m_start, JoinProblem::NoBorder};
  const std::size_t places = std::clamp(kMostLooks / m_faces.size(), kLeastPlaces, kMostPlaces);
  Place good{m_start};
  double reached = 0.0, stop = 0.0;
  const auto isAllowed = [&](double share) {
    const Vec3 place = share < 1.0 ? Vec3(m_start + share * (target - m_start)) : target;
    const JoinProblem problem = problemAt(place, *m_near);
    if (problem == JoinProblem::None) {
      good.point = place;
      reached = share;
    } else {
      good.problem = problem;
      stop = share;
    }
    return problem == JoinProblem::None;
  };
  for (std::size_t i = 1; i <= places; ++i)
    if (!isAllowed(static_cast<double>(i) / static_cast<double>(places))) break;
  for (std::size_t i = 0; i < places && good.problem != JoinProblem::None; ++i) isAllowed(0.5 * (reached + stop));
  return good;
}

bool VertexPull::apply(HalfEdgeMesh& mesh, const Vec3& place) const {
  Box reach(m_start, m_start);
  for (std::size_t i = 0; i < m_faces.size(); ++i) {
    const Face f = m_faces[i];
    if (f >= mesh.faceSlots() || !mesh.isLive(f) || mesh.points(f) != m_before[i]) return false;
    for (const Vec3& p : m_before[i]) reach.extend(p);
  }
  if (m_faces.empty() || !place.allFinite()) return false;
  if (problemAt(place, NearFaces(mesh, reach.extend(place))) != JoinProblem::None) return false;
  for (const Vertex v : m_vertices) mesh.setPosition(v, place);
  return true;
}

}  // namespace handwheel
