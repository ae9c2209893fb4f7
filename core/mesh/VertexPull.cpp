// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/VertexPull.h"

#include "mesh/FaceNormal.h"

#include <algorithm>

namespace handwheel {
namespace {

constexpr double kSlimmest = 0.02;  // slimness() that any face may have
constexpr double kSlimmer = 0.5;    // share of its own that a slimmer one keeps
constexpr int kSamples = 32;        // of the way, looked at for the first place that is not allowed
constexpr int kHalvings = 20;       // of the way between two of them

}  // namespace

double slimness(const TrianglePoints& t) {
  Vec3 a = t[1] - t[0], b = t[2] - t[0], c = t[2] - t[1];
  const double longest = std::max({a.stableNorm(), b.stableNorm(), c.stableNorm()});
  return longest > 0.0 ? (a / longest).cross(b / longest).norm() : 0.0;
}

bool mayBecome(const TrianglePoints& before, const TrianglePoints& after) {
  const Vec3 was = unitNormal(before), is = unitNormal(after);
  if (was.isZero(0.0)) return true;
  return is.dot(was) > 0.0 && slimness(after) >= std::min(kSlimmest, kSlimmer * slimness(before));
}

VertexPull::VertexPull(const NearFaces& near, Vertex v) : m_start(near.mesh().position(v)) {
  for (const HalfEdge h : near.leaving(m_start)) {
    m_vertices.push_back(near.mesh().from(h));
    m_faces.push_back(HalfEdgeMesh::face(h));
    m_before.push_back(near.mesh().points(HalfEdgeMesh::face(h)));
  }
  std::sort(m_vertices.begin(), m_vertices.end());
  m_vertices.erase(std::unique(m_vertices.begin(), m_vertices.end()), m_vertices.end());
}

TrianglePoints VertexPull::shape(std::size_t i, const Vec3& place) const {
  TrianglePoints t = m_before[i];
  std::replace(t.begin(), t.end(), m_start, place);
  return t;
}

bool VertexPull::isAllowed(const Vec3& place) const {
  for (std::size_t i = 0; i < m_faces.size(); ++i)
    if (!mayBecome(m_before[i], shape(i, place))) return false;
  return true;
}

VertexPull::Place VertexPull::towards(const Vec3& target) const {
  if (!target.allFinite()) return {m_start, true};
  const auto at = [&](double share) -> Vec3 { return m_start + share * (target - m_start); };
  double good = 0.0, bad = 0.0;
  for (int i = 1; i <= kSamples && bad == 0.0; ++i) {
    const double share = static_cast<double>(i) / kSamples;
    (isAllowed(i == kSamples ? target : at(share)) ? good : bad) = share;
  }
  if (bad == 0.0) return {target, false};
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (good + bad);
    (isAllowed(at(middle)) ? good : bad) = middle;
  }
  return {good > 0.0 ? at(good) : m_start, true};
}

TriangleSoup VertexPull::shapes(const Vec3& place) const {
  TriangleSoup soup;
  for (std::size_t i = 0; i < m_faces.size(); ++i) {
    const auto n = static_cast<std::uint32_t>(soup.points.size());
    for (const Vec3& p : shape(i, place)) soup.points.push_back(p);
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  return soup;
}

bool VertexPull::apply(HalfEdgeMesh& mesh, const Vec3& place) const {
  for (std::size_t i = 0; i < m_faces.size(); ++i) {
    const Face f = m_faces[i];
    if (f >= mesh.faceSlots() || !mesh.isLive(f) || mesh.points(f) != m_before[i]) return false;
  }
  if (m_faces.empty() || !place.allFinite() || !isAllowed(place)) return false;
  for (const Vertex v : m_vertices) mesh.setPosition(v, place);
  return true;
}

}  // namespace handwheel
