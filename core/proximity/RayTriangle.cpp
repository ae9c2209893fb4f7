// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proximity/RayTriangle.h"

#include <cmath>

namespace handwheel {
namespace {

// ab - cd with the right sign, and 0 only when it is 0 (Kahan's difference of products). Swapping the products gives
// exactly the opposite number.
double crossOf(double a, double b, double c, double d) {
  const double plain = a * b - c * d;  // rounding is monotonic: its sign is right, or it is 0
  if (plain != 0.0) return plain;
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

}  // namespace

RayTriangleTest::RayTriangleTest(const Vec3& origin, const Vec3& direction) : m_origin(origin) {
  int longest = 0;
  direction.cwiseAbs().maxCoeff(&longest);
  m_axes = {(longest + 1) % 3, (longest + 2) % 3, longest};
  const double length = direction[longest];
  m_shear = {direction[m_axes[0]] / length, direction[m_axes[1]] / length, length};
}

// The ray becomes the third axis, its origin the origin.
Vec3 RayTriangleTest::sheared(const Vec3& p) const {
  const Vec3 r = p - m_origin;
  const double along = r[m_axes[2]];
  return {r[m_axes[0]] - m_shear.x() * along, r[m_axes[1]] - m_shear.y() * along, along};
}

std::optional<double> RayTriangleTest::hit(const Vec3& a, const Vec3& b, const Vec3& c) const {
  const Vec3 p = sheared(a), q = sheared(b), r = sheared(c);
  // Twice the signed areas between the axis and the edges. The triangle on the other side of an edge gets exactly the
  // opposite number. A 0 where there is none would let a triangle that is seen nearly edge-on be hit by rays that pass
  // it in its plane.
  const double u = crossOf(r.x(), q.y(), r.y(), q.x());
  const double v = crossOf(p.x(), r.y(), p.y(), r.x());
  const double w = crossOf(q.x(), p.y(), q.y(), p.x());
  if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return std::nullopt;
  const double area = u + v + w;
  if (area == 0.0) return std::nullopt;
  const double along = (u * p.z() + v * q.z() + w * r.z()) / area;
  const double distance = along / m_shear.z();
  if (!(distance >= 0.0)) return std::nullopt;
  return distance;
}

}  // namespace handwheel
