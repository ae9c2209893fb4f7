// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/VertexDrag.h"

#include <algorithm>
#include <utility>

namespace handwheel {
namespace {

// Numbers of samples on the path to find the first forbidden one, and of bisections between it and the previous one.
// The search for crossings is slowest, so it uses fewer.
constexpr int kTurnSamples = 32, kCrossSamples = 8;

// Returns the largest allowed share of a path up to "most", 0 if there is none. "most" itself is tested first.
template <class IsAllowed>
double furthest(double most, int samples, IsAllowed isAllowed) {
  if (isAllowed(most)) return most;
  double good = 0.0, bad = most;
  for (int i = 1; i < samples; ++i) {
    const double share = most * i / samples;
    if (!isAllowed(share)) {
      bad = share;
      break;
    }
    good = share;
  }
  for (int i = 0; i < samples; ++i) {
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

std::vector<TrianglePoints> VertexDrag::shapes(const Vec3& position) const {
  std::vector<TrianglePoints> result = m_before;
  for (TrianglePoints& t : result) std::replace(t.begin(), t.end(), m_start, position);
  return result;
}

bool VertexDrag::turnsAFace(const Vec3& position) const {
  const std::vector<TrianglePoints> after = shapes(position);
  for (std::size_t i = 0; i < after.size(); ++i)
    if (!mayBecome(m_before[i], after[i])) return true;
  return false;
}

bool VertexDrag::crosses(const Vec3& position, const FaceLocator& near) const {
  return !forEachNewCrossing(near, {m_faces, shapes(position)}, [](std::size_t) { return false; });
}

VertexDrag::ReachablePoint VertexDrag::towards(const Vec3& target, NumberType numbers) const {
  if (!target.allFinite() || m_faces.empty()) return {m_start, JoinProblem::NoBorder};
  const auto at = [&](double share) -> Vec3 {
    if (share == 0.0) return m_start;
    return rounded(share < 1.0 ? Vec3(m_start + share * (target - m_start)) : target, numbers);
  };
  const double unturned = furthest(1.0, kTurnSamples, [&](double share) { return !turnsAFace(at(share)); });
  const double free = furthest(unturned, kCrossSamples, [&](double share) { return !crosses(at(share), *m_near); });
  if (free < unturned) return {at(free), JoinProblem::Crosses};
  return {at(free), free < 1.0 ? JoinProblem::FlippedFace : JoinProblem::None};
}

bool VertexDrag::apply(HalfEdgeMesh& mesh, const Vec3& position) const {
  Box reach(m_start, m_start);
  for (std::size_t i = 0; i < m_faces.size(); ++i) {
    const Face f = m_faces[i];
    if (f >= mesh.faceSlots() || !mesh.isLive(f) || mesh.points(f) != m_before[i]) return false;
    for (const Vec3& p : m_before[i]) reach.extend(p);
  }
  if (m_faces.empty() || !position.allFinite()) return false;
  if (turnsAFace(position) || crosses(position, FaceLocator(mesh, reach.extend(position)))) return false;
  for (const Vertex v : m_vertices) mesh.setPosition(v, position);
  return true;
}

}  // namespace handwheel
