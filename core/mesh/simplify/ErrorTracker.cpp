// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/simplify/ErrorTracker.h"

#include "mesh/search/IncrementalHierarchy.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/FaceNormal.h"
#include "proximity/ClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {
namespace {

constexpr double kMostEdgeSteps = 24.0;  // along the edges of a face: 300 points
// Largest density of the points on replacements, relative to those on the original. Most replacements that are too far
// from the original are so at their new corner or along the edges from it.
constexpr double kEdgeDensity = 8.0, kInnerDensity = 0.25;
constexpr double kMostStepsOfEdge = kEdgeDensity * kMostEdgeSteps;

double longestEdge(const TrianglePoints& t) {
  return std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
}

}  // namespace

ReachOfTriangle::ReachOfTriangle(const TrianglePoints& t) : m_corners(t), m_box(boxOf(t)), m_normal(unitNormal(t)) {
  for (std::size_t k = 0; k < 3; ++k) m_outwards[k] = (t[(k + 1) % 3] - t[k]).cross(m_normal).normalized();
}

double ReachOfTriangle::squaredDistance(const Vec3& p, double limit) const {
  const double beyond = m_box.squaredExteriorDistance(p);
  if (beyond > limit) return beyond;
  const double height = m_normal.dot(p - m_corners[0]);
  double aside = 0.0;
  for (std::size_t k = 0; k < 3; ++k) aside = std::max(aside, m_outwards[k].dot(p - m_corners[k]));
  const double least = height * height + aside * aside;
  if (aside == 0.0 || least > limit) return least;
  return (closestOnTriangle(p, m_corners[0], m_corners[1], m_corners[2]) - p).squaredNorm();
}

ErrorTracker::ErrorTracker(const HalfEdgeMesh& original, double error, int density, Progress progress)
    : m_original(original, progress.part(0.0, 0.8)), m_error(error), m_head(original.faceSlots(), kNone) {
  const std::vector<Face>& faces = m_original.faces();
  double length = 0.0;
  for (const Face f : faces) {
    const TrianglePoints t = original.points(f);
    length += (t[1] - t[0]).norm() + (t[2] - t[1]).norm() + (t[0] - t[2]).norm();
  }
  m_spacing = length / (3.0 * density * static_cast<double>(std::max<std::size_t>(faces.size(), 1)));
  std::vector<bool> isAssigned(original.vertexSlots(), false);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!pollProgress(i, faces.size(), progress.part(0.8, 1.0))) return;
    for (const Vertex v : original.triangle(faces[i])) {
      if (!isAssigned[v]) assign(faces[i], original.position(v));
      isAssigned[v] = true;
    }
    assignInner(faces[i], original.points(faces[i]));
  }
}

void ErrorTracker::assign(Face f, const Vec3& p) {
  m_next.push_back(std::exchange(m_head[f], static_cast<std::uint32_t>(m_points.size())));
  m_points.push_back(p);
}

// Assigns the middle of a face; for larger faces, points as dense as the vertices elsewhere.
void ErrorTracker::assignInner(Face f, const TrianglePoints& t) {
  const int steps = static_cast<int>(std::min(kMostEdgeSteps, std::ceil(longestEdge(t) / m_spacing)));
  if (steps <= 2) return assign(f, (t[0] + t[1] + t[2]) / 3.0);
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps - i; ++j) {
      assign(f, t[0] + (i + 0.5) / steps * (t[1] - t[0]) + double(j) / steps * (t[2] - t[0]));
    }
  }
}

bool ErrorTracker::isNear(const Vec3& p, Near& near) const {
  if (near.triangle) {
    const auto [a, b, c] = m_original.hierarchy().corners(*near.triangle);
    near.distance = (closestOnTriangle(p, a, b, c) - p).norm();
    if (near.distance < m_error) return true;
  }
  const auto nearest = m_original.hierarchy().nearest(p, m_error);
  if (!nearest) return false;
  near = {nearest->triangle, std::sqrt(nearest->squaredDistance)};
  return true;
}

bool ErrorTracker::isEdgeNear(const Vec3& from, const Vec3& to, Near near) const {
  const double length = (to - from).norm();
  const double step = std::max(m_spacing / kEdgeDensity, length / kMostStepsOfEdge);
  const auto next = [&](double at) { return at + std::max(step, m_error - near.distance); };
  for (double at = next(0.0); at < length; at = next(at)) {
    if (!isNear(from + at / length * (to - from), near)) return false;
  }
  return true;
}

bool ErrorTracker::isInnerNear(const TrianglePoints& t, Near near) const {
  const double wanted = std::ceil(kInnerDensity * longestEdge(t) / m_spacing);
  const int steps = static_cast<int>(std::min(kMostEdgeSteps, wanted));
  for (int i = 1; i < steps; ++i) {
    for (int j = 1; j < i; ++j) {
      if (!isNear(t[0] + double(i - j) / steps * (t[1] - t[0]) + double(j) / steps * (t[2] - t[0]), near)) return false;
    }
  }
  return true;
}

bool ErrorTracker::isAssignedNear(std::uint32_t point) {
  double least = m_error * m_error;
  std::uint32_t best = kNone;
  for (std::uint32_t i = 0; i < m_reaches.size(); ++i) {
    const double distance = m_reaches[i].squaredDistance(m_points[point], least);
    if (distance > least) continue;
    least = distance;
    best = i;
  }
  m_moves.push_back({point, best});
  return best != kNone;
}

bool ErrorTracker::allows(std::span<const Face> old, std::span<const TrianglePoints> replacements) {
  m_moves.clear();
  m_reaches.clear();
  for (const TrianglePoints& t : replacements) m_reaches.emplace_back(t);
  for (const Face f : old) {
    for (std::uint32_t point = m_head[f], last = kNone; point != kNone; last = std::exchange(point, m_next[point])) {
      if (isAssignedNear(point)) continue;
      // The point is tested first from now on, because it is probably too far from the next replacements too.
      if (last != kNone) m_next[last] = std::exchange(m_next[point], std::exchange(m_head[f], point));
      return false;
    }
  }
  Near near;
  if (replacements.empty()) return true;
  if (!isNear(replacements[0][0], near)) return false;
  const auto isSecond = [&](const Vec3& p) {
    return std::any_of(replacements.begin(), replacements.end(), [&](const TrianglePoints& t) { return t[1] == p; });
  };
  return std::all_of(replacements.begin(), replacements.end(), [&](const TrianglePoints& t) {
    // At a border, the last edge from the new corner belongs to one face only.
    return isEdgeNear(t[0], t[1], near) && (isSecond(t[2]) || isEdgeNear(t[0], t[2], near)) && isInnerNear(t, near);
  });
}

void ErrorTracker::replace(std::span<const Face> old, std::span<const Face> by) {
  for (const Face f : old) m_head[f] = kNone;
  for (const Face f : by) m_head.resize(std::max<std::size_t>(m_head.size(), f + 1), kNone);
  for (const Assigned& move : m_moves) m_next[move.point] = std::exchange(m_head[by[move.replacement]], move.point);
}

}  // namespace handwheel
