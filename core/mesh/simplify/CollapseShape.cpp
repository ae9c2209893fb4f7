// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/simplify/CollapseShape.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr double kFlipCosine = 0.2;  // between a face's normals before and after
constexpr double kNeedle = 0.01;     // area as a share of an equilateral triangle's with the same sum of squares
constexpr double kThinner = 0.9;     // share of the thinnest before: needles may shear a little

Vec3 areaNormal(const TrianglePoints& t) {
  return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]);
}

// Returns the shape quality: 1 for an equilateral triangle, 0 for one without area.
double roundnessOf(const TrianglePoints& t) {
  const double squares = (t[1] - t[0]).squaredNorm() + (t[2] - t[1]).squaredNorm() + (t[0] - t[2]).squaredNorm();
  return squares > 0.0 ? 4.0 * std::sqrt(3.0) * areaNormal(t).norm() / squares : 0.0;
}

}  // namespace

bool keepsShape(std::span<const TrianglePoints> before, std::span<const TrianglePoints> after) {
  double thinnest = 1.0, thinnestBefore = 1.0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const Vec3 was = areaNormal(before[i]), is = areaNormal(after[i]);
    if (isDegenerate(after[i])) return false;
    if (!was.isZero() && was.dot(is) <= kFlipCosine * was.norm() * is.norm()) return false;
    thinnest = std::min(thinnest, roundnessOf(after[i]));
    thinnestBefore = std::min(thinnestBefore, roundnessOf(before[i]));
  }
  return thinnest >= std::min(kNeedle, kThinner * thinnestBefore);
}

}  // namespace handwheel
