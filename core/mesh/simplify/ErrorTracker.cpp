// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/simplify/ErrorTracker.h"

#include "mesh/search/IncrementalHierarchy.h"
#include "mesh/structure/CancelPolling.h"
#include "proximity/ClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {
namespace {

constexpr double kMostEdgeSteps = 24.0;  // along the edges of a face: 300 points

double longestEdge(const TrianglePoints& t) {
  return std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
}

}  // namespace

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

bool ErrorTracker::isNear(const TrianglePoints& t) const {
  const int steps = static_cast<int>(std::min(kMostEdgeSteps, std::max(1.0, std::ceil(longestEdge(t) / m_spacing))));
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j <= i; ++j) {
      const Vec3 p = t[0] + double(i - j) / steps * (t[1] - t[0]) + double(j) / steps * (t[2] - t[0]);
      if (!m_original.hierarchy().isWithin(p, m_error)) return false;
    }
  }
  return true;
}

bool ErrorTracker::isAssignedNear(std::uint32_t point, std::span<const TrianglePoints> replacements) {
  double least = m_error * m_error;
  std::uint32_t best = kNone;
  for (std::uint32_t i = 0; i < replacements.size(); ++i) {
    if (m_boxes[i].squaredExteriorDistance(m_points[point]) > least) continue;
    const auto& [a, b, c] = replacements[i];
    const double distance = (closestOnTriangle(m_points[point], a, b, c) - m_points[point]).squaredNorm();
    if (distance > least) continue;
    least = distance;
    best = i;
  }
  m_moves.push_back({point, best});
  return best != kNone;
}

bool ErrorTracker::allows(std::span<const Face> old, std::span<const TrianglePoints> replacements) {
  m_moves.clear();
  m_boxes.clear();
  for (const TrianglePoints& t : replacements) m_boxes.push_back(boxOf(t));
  for (const Face f : old) {
    for (std::uint32_t point = m_head[f], last = kNone; point != kNone; last = std::exchange(point, m_next[point])) {
      if (isAssignedNear(point, replacements)) continue;
      // The point is tested first from now on, because it is probably too far from the next replacements too.
      if (last != kNone) m_next[last] = std::exchange(m_next[point], std::exchange(m_head[f], point));
      return false;
    }
  }
  return std::all_of(replacements.begin(), replacements.end(), [&](const TrianglePoints& t) { return isNear(t); });
}

void ErrorTracker::replace(std::span<const Face> old, std::span<const Face> by) {
  for (const Face f : old) m_head[f] = kNone;
  for (const Assigned& move : m_moves) m_next[move.point] = std::exchange(m_head[by[move.replacement]], move.point);
}

}  // namespace handwheel
