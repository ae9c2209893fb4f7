// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/VertexDrag.h"

#include <algorithm>
#include <utility>

namespace handwheel {
namespace {

// Places of the way looked at for the first that is not allowed, and again between it and the one before. Looking for
// crossings takes longest, so fewer do.
constexpr int kTurnPlaces = 32, kCrossPlaces = 8;

// The furthest share of a way, at most this, at which it is allowed, 0 if none; the furthest of all is looked at first.
template <class IsAllowed>
double furthest(double most, int places, IsAllowed isAllowed) {
  if (isAllowed(most)) return most;
  double good = 0.0, bad = most;
  for (int i = 1; i < places; ++i) {
    const double share = most * i / places;
    if (!isAllowed(share)) {
      bad = share;
      break;
    }
    good = share;
  }
  for (int i = 0; i < places; ++i) {
    const double middle = 0.5 * (good + bad);
    (isAllowed(middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace

VertexDrag::VertexDrag(std::shared_ptr<const FaceLocator> near, Vertex v)
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

std::vector<TrianglePoints> VertexDrag::shapes(const Vec3& place) const {
  std::vector<TrianglePoints> result = m_before;
  for (TrianglePoints& t : result) std::replace(t.begin(), t.end(), m_start, place);
  return result;
}

bool VertexDrag::turnsAFace(const Vec3& place) const {
  const std::vector<TrianglePoints> after = shapes(place);
  for (std::size_t i = 0; i < after.size(); ++i)
    if (!mayBecome(m_before[i], after[i])) return true;
  return false;
}

bool VertexDrag::crosses(const Vec3& place, const FaceLocator& near) const {
  return !forEachNewCrossing(near, {m_faces, shapes(place)}, [](std::size_t) { return false; });
}

VertexDrag::Place VertexDrag::towards(const Vec3& target, NumberType numbers) const {
  if (!target.allFinite() || m_faces.empty()) return {m_start, JoinProblem::NoBorder};
  const auto at = [&](double share) -> Vec3 {
    if (share == 0.0) return m_start;
    return rounded(share < 1.0 ? Vec3(m_start + share * (target - m_start)) : target, numbers);
  };
  const double unturned = furthest(1.0, kTurnPlaces, [&](double share) { return !turnsAFace(at(share)); });
  const double free = furthest(unturned, kCrossPlaces, [&](double share) { return !crosses(at(share), *m_near); });
  if (free < unturned) return {at(free), JoinProblem::Crosses};
  return {at(free), free < 1.0 ? JoinProblem::FlippedFace : JoinProblem::None};
}

bool VertexDrag::apply(HalfEdgeMesh& mesh, const Vec3& place) const {
  Box reach(m_start, m_start);
  for (std::size_t i = 0; i < m_faces.size(); ++i) {
    const Face f = m_faces[i];
    if (f >= mesh.faceSlots() || !mesh.isLive(f) || mesh.points(f) != m_before[i]) return false;
    for (const Vec3& p : m_before[i]) reach.extend(p);
  }
  if (m_faces.empty() || !place.allFinite()) return false;
  if (turnsAFace(place) || crosses(place, FaceLocator(mesh, reach.extend(place)))) return false;
  for (const Vertex v : m_vertices) mesh.setPosition(v, place);
  return true;
}

}  // namespace handwheel
