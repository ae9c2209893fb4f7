// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <cmath>

// Exact orientation predicates for lines and planes. They are computed in floating point with an error bound first; if
// that is inconclusive, by CGAL's exact predicates. All coordinates must be finite. The predicates are thread-safe.
namespace handwheel {

using Vec2 = Eigen::Vector2d;

namespace exact {

// The first-stage error bounds of orient2d and orient3d, rounded up, as fractions of the sum of the absolute products
// (Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates", 1997).
inline constexpr double kLineError = 3.4e-16;
inline constexpr double kPlaneError = 8.0e-16;
// A generous bound of the rounding error of a product that underflows. ExactPlane::side() multiplies such products by a
// third factor, and the bound by the same factor.
inline constexpr double kUnderflow = 1e-300;

int side(const Vec2& p, const Vec2& q, const Vec2& r);
int side(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s);

}  // namespace exact

// Returns the side of the line from p to q on which r lies: 1 for the left, -1 for the right, 0 if r is on the line or
// p equals q.
inline int sideOfLine(const Vec2& p, const Vec2& q, const Vec2& r) {
  const double left = (q.x() - p.x()) * (r.y() - p.y());
  const double right = (q.y() - p.y()) * (r.x() - p.x());
  const double bound = exact::kLineError * (std::abs(left) + std::abs(right)) + exact::kUnderflow;
  if (left - right > bound) return 1;
  if (right - left > bound) return -1;
  return exact::side(p, q, r);
}

// A plane through three points, for repeated exact orientation tests. The points must outlive the plane.
class ExactPlane {
 public:
  ExactPlane(const Vec3& p, const Vec3& q, const Vec3& r) : m_p(p), m_q(q), m_r(r), m_a(q - p), m_b(r - p) {
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      const double left = m_a[l] * m_b[m];
      const double right = m_a[m] * m_b[l];
      m_normal[k] = left - right;
      m_sum[k] = std::abs(left) + std::abs(right);
    }
  }

  // Returns the sign of det(q - p, r - p, s - p): 1 if p, q, r are seen counter-clockwise from s, 0 if s is on the
  // plane.
  int side(const Vec3& s) const {
    const Vec3 c = s - m_p;
    const Vec3 size = c.cwiseAbs();
    const double determinant = c.dot(m_normal);
    const double bound = exact::kPlaneError * size.dot(m_sum) + exact::kUnderflow * (size.sum() + 1.0);
    if (determinant > bound) return 1;
    if (-determinant > bound) return -1;
    // All four points have an equal coordinate. This case is frequent in designed parts, and the test is exact, because
    // only the difference of equal numbers is 0.
    for (int k = 0; k < 3; ++k)
      if (m_a[k] == 0.0 && m_b[k] == 0.0 && c[k] == 0.0) return 0;
    return exact::side(m_p, m_q, m_r, s);
  }

 private:
  const Vec3 &m_p, &m_q, &m_r;
  Vec3 m_a, m_b, m_normal;
  Vec3 m_sum;  // sums of the absolute products in the normal
};

}  // namespace handwheel
