// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

namespace handwheel {

// A quadric error metric: a weighted sum of squared distances from planes. It is a function of the position relative to
// a nearby origin that its owner keeps: far from the origin, differences of large numbers would lose all precision
// (Garland and Heckbert, "Surface simplification using quadric error metrics", 1997).
struct Quadric {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Vec3 b = Vec3::Zero();
  double c = 0.0;

  // Returns the quadric of the plane through a point relative to the origin; the normal must have unit length.
  static Quadric ofPlane(const Vec3& point, const Vec3& normal, double weight) {
    const double offset = -normal.dot(point);
    return {weight * normal * normal.transpose(), weight * offset * normal, weight * offset * offset};
  }

  Quadric& operator+=(const Quadric& other) {
    a += other.a;
    b += other.b;
    c += other.c;
    return *this;
  }

  // Returns the same function relative to another origin, which is "by" away from the present origin.
  Quadric movedTo(const Vec3& by) const { return {a, b + a * by, c + 2.0 * b.dot(by) + by.dot(a * by)}; }

  double at(const Vec3& p) const { return p.dot(a * p) + 2.0 * b.dot(p) + c; }

  // Returns the position of the minimum. If the minimum is a line or a plane, the result is a position on it near
  // "wanted". pull is the weight of the distance from "wanted", as a fraction of the trace.
  Vec3 leastNear(const Vec3& wanted, double pull) const {
    const double weight = pull * a.trace();
    if (!(weight > 0.0)) return wanted;
    const Eigen::Matrix3d m = a + weight * Eigen::Matrix3d::Identity();
    return m.llt().solve(Vec3(weight * wanted - b));
  }
};

}  // namespace handwheel
