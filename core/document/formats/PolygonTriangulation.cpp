// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/PolygonTriangulation.h"

#include "base/Tolerance.h"

#include <cmath>
#include <iterator>

namespace handwheel {

namespace {

constexpr std::uint64_t kTestsPerLook = 500'000;
constexpr std::uint64_t kTestsPerCorner = 100;  // enough for polygons of some hundred corners, however many

// Slacks in relation to the extent: more than the rounding of single and of double precision. A smaller one counts if
// nothing can be cut with a larger one.
constexpr double kSlacks[] = {1e-6, 1e-10, 1e-14, 0.0};

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Returns twice the area vector of a closed polygon (Newell).
Vec3 areaVector(const std::vector<Vec3>& points, std::span<const std::uint32_t> corners) {
  const Vec3& origin = points[corners[0]];
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += (points[corners[i]] - origin).cross(points[corners[i + 1]] - origin);
  return sum;
}

void appendFan(std::span<const std::uint32_t> corners, std::vector<Triangle>& triangles) {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) triangles.push_back({corners[0], corners[i], corners[i + 1]});
}

}  // namespace

PolygonTriangulation::Outcome PolygonTriangulation::cut(const std::vector<Vec3>& points,
                                                        std::span<const std::uint32_t> corners,
                                                        std::vector<Triangle>& triangles) {
  if (corners.size() > 3 && flatten(points, corners) && !isStrictlyConvex()) return clipEars(corners, triangles);
  appendFan(corners, triangles);
  return Outcome::Done;
}

// Drops the coordinate along which the polygon extends least: the others stay exactly as they are, so collinear corners
// stay collinear. Returns false if the polygon is not planar or has no area.
bool PolygonTriangulation::flatten(const std::vector<Vec3>& points, std::span<const std::uint32_t> corners) {
  const Vec3 area = areaVector(points, corners);
  const double length = area.stableNorm();
  if (!(length > 0.0) || !std::isfinite(length)) return false;
  const Vec3 normal = area / length;
  const Vec3& origin = points[corners[0]];
  double size = 0.0, low = 0.0, high = 0.0;
  for (std::uint32_t c : corners) {
    const Vec3 d = points[c] - origin;
    size = std::max(size, d.cwiseAbs().maxCoeff());
    low = std::min(low, normal.dot(d));
    high = std::max(high, normal.dot(d));
  }
  if (!(high - low <= tolerance::kPlanarPolygon * size)) return false;

  Eigen::Index drop = 0;
  normal.cwiseAbs().maxCoeff(&drop);
  const Eigen::Index u = (drop + 1) % 3, v = (drop + 2) % 3;
  const bool turned = normal[drop] < 0.0;
  m_size = size;
  m_flat.clear();
  for (std::uint32_t c : corners)
    m_flat.push_back(turned ? Vec2(points[c][v], points[c][u]) : Vec2(points[c][u], points[c][v]));
  return true;
}

bool PolygonTriangulation::isStrictlyConvex() {
  linkRing();
  m_slack = kSlacks[0] * m_size;
  listReflex(0);
  return m_reflex.empty();
}

PolygonTriangulation::Outcome PolygonTriangulation::clipEars(std::span<const std::uint32_t> corners,
                                                             std::vector<Triangle>& triangles) {
  m_allowedTests += kTestsPerCorner * corners.size();
  std::uint32_t at = 0;
  std::size_t left = corners.size(), sinceLastEar = 0, level = 0;
  while (left > 3) {
    if (m_tests >= m_nextLook) {
      if (!m_keepGoing()) return Outcome::Stopped;
      m_nextLook = m_tests + kTestsPerLook;
    }
    // After a full round without an ear the slack was too large, or the outline crosses itself. Any corner is then cut.
    const bool stuck = sinceLastEar > left;
    if (stuck && level + 1 < std::size(kSlacks)) {
      m_slack = kSlacks[++level] * m_size;
      listReflex(at);
      sinceLastEar = 0;
      continue;
    }
    if (m_tests < m_allowedTests && !stuck && !isEar(at)) {
      ++sinceLastEar;
      at = m_next[at];
      continue;
    }
    triangles.push_back({corners[m_previous[at]], corners[at], corners[m_next[at]]});
    unlink(at);
    --left;
    sinceLastEar = 0;
    at = m_next[m_next[at]];  // skipping one corner keeps the triangles from all meeting in one
  }
  triangles.push_back({corners[m_previous[at]], corners[at], corners[m_next[at]]});
  return m_tests < m_allowedTests ? Outcome::Done : Outcome::TooComplex;
}

void PolygonTriangulation::linkRing() {
  const auto n = static_cast<std::uint32_t>(m_flat.size());
  m_previous.resize(n);
  m_next.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    m_previous[i] = i == 0 ? n - 1 : i - 1;
    m_next[i] = i + 1 == n ? 0 : i + 1;
  }
}

// Lists the reflex corners of the ring, from one of its corners on.
void PolygonTriangulation::listReflex(std::uint32_t first) {
  m_reflex.clear();
  std::uint32_t corner = first;
  do {
    if (isReflex(corner)) m_reflex.push_back(corner);
    corner = m_next[corner];
  } while (corner != first);
}

void PolygonTriangulation::unlink(std::uint32_t corner) {
  m_next[m_previous[corner]] = m_next[corner];
  m_previous[m_next[corner]] = m_previous[corner];
  m_previous[corner] = kNone;  // removed from the ring; m_next stays for continuing from it
}

bool PolygonTriangulation::isReflex(std::uint32_t corner) const {
  const Vec2 &before = m_flat[m_previous[corner]], &after = m_flat[m_next[corner]];
  return cross(before, m_flat[corner], after) <= m_slack * (after - before).norm();
}

bool PolygonTriangulation::isEar(std::uint32_t corner) {
  if (isReflex(corner)) return false;
  const Vec2 &a = m_flat[m_previous[corner]], &b = m_flat[corner], &c = m_flat[m_next[corner]];
  const double ab = -m_slack * (b - a).norm(), bc = -m_slack * (c - b).norm(), ca = -m_slack * (a - c).norm();
  for (std::size_t i = 0; i < m_reflex.size();) {
    const std::uint32_t other = m_reflex[i];
    ++m_tests;
    if (m_previous[other] == kNone || !isReflex(other)) {  // a corner never becomes reflex again
      m_reflex[i] = m_reflex.back();
      m_reflex.pop_back();
      continue;
    }
    ++i;
    const Vec2& p = m_flat[other];
    if (p == a || p == b || p == c) continue;  // outlines that lead to an island touch themselves in such corners
    if (cross(a, b, p) >= ab && cross(b, c, p) >= bc && cross(c, a, p) >= ca) return false;
  }
  return true;
}

}  // namespace handwheel
