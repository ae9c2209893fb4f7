// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

#include <algorithm>
#include <cmath>
#include <limits>

// The distance of two surfaces by brute force. All pairs of triangles, and of each all pairs of features, are compared.
// This is slow, but independent of the algorithms of the program.
namespace handwheel::test {

using Corners = std::array<Vec3, 3>;

inline double segmentDistance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = d - c, w = a - c;
  const auto along = [](const Vec3& p, const Vec3& from, const Vec3& ab) {
    const double t = ab.squaredNorm() > 0.0 ? std::clamp((p - from).dot(ab) / ab.squaredNorm(), 0.0, 1.0) : 0.0;
    return (p - from - t * ab).norm();
  };
  double least = std::min({along(a, c, v), along(b, c, v), along(c, a, u), along(d, a, u)});
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), det = uu * vv - uv * uv;
  if (det <= 0.0) return least;
  const double s = (uv * v.dot(w) - vv * u.dot(w)) / det, t = (uu * v.dot(w) - uv * u.dot(w)) / det;
  if (s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0) least = std::min(least, (w + s * u - t * v).norm());
  return least;
}

// Returns true if the foot of the perpendicular from a point to the plane of a triangle lies within the triangle.
inline bool isAbove(const Vec3& p, const Corners& t) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    if (n.dot((t[(k + 1) % 3] - t[k]).cross(p - t[k])) < 0.0) return false;
  }
  return true;
}

inline double pointDistance(const Vec3& p, const Corners& t) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  if (isAbove(p, t) && n.norm() > 0.0) return std::abs(n.dot(p - t[0])) / n.norm();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) least = std::min(least, segmentDistance(p, p, t[k], t[(k + 1) % 3]));
  return least;
}

inline bool isPierced(const Vec3& a, const Vec3& b, const Corners& t) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  const double da = n.dot(a - t[0]), db = n.dot(b - t[0]);
  if (da * db > 0.0 || da == db) return false;
  return isAbove(a + da / (da - db) * (b - a), t);
}

inline double triangleDistance(const Corners& s, const Corners& t) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    least = std::min({least, pointDistance(s[i], t), pointDistance(t[i], s)});
    if (isPierced(s[i], s[(i + 1) % 3], t) || isPierced(t[i], t[(i + 1) % 3], s)) return 0.0;
    for (std::size_t j = 0; j < 3; ++j)
      least = std::min(least, segmentDistance(s[i], s[(i + 1) % 3], t[j], t[(j + 1) % 3]));
  }
  return least;
}

inline Corners cornersOf(const TriangleSoup& soup, std::size_t i, const Pose& pose) {
  const Triangle& t = soup.triangles[i];
  return {pose * soup.points[t[0]], pose * soup.points[t[1]], pose * soup.points[t[2]]};
}

inline double surfaceDistance(const TriangleSoup& a, const Pose& poseA, const TriangleSoup& b, const Pose& poseB) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    for (std::size_t j = 0; j < b.triangles.size(); ++j)
      least = std::min(least, triangleDistance(cornersOf(a, i, poseA), cornersOf(b, j, poseB)));
  }
  return least;
}

inline double distanceFromSurface(const Vec3& p, const TriangleSoup& a, const Pose& pose) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.triangles.size(); ++i) least = std::min(least, pointDistance(p, cornersOf(a, i, pose)));
  return least;
}

}  // namespace handwheel::test
