// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillBit.h"

#include "volume/drilling/DrillHead.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace handwheel {
double DrillBit::reach() const {
  if (shape == DrillShape::Saw) return 0.5 * width;
  return shape == DrillShape::Twist ? radius() / std::tan(0.5 * pointAngle) : radius();
}

double DrillBit::signedDepth(const Vec3& from, const Vec3& axis) const {
  const DrillHead head(*this);
  const double bound = head.inside(from, axis);
  if (head.isBall() || bound >= 0.0) return bound;
  // In the half plane through the axis: from the front to the rim, the back and the axis again.
  using Point = Eigen::Vector2d;
  const double up = from.dot(axis);
  const bool isSaw = shape == DrillShape::Saw;
  const double front = isSaw ? -0.5 * width : 0.0, back = isSaw ? 0.5 * width : length;
  const Point p((from - up * axis).norm(), up);
  const std::array<Point, 4> outline{Point(0.0, -reach()), Point(radius(), front), Point(radius(), back),
                                     Point(0.0, back)};
  double squared = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    const Point along = outline[i + 1] - outline[i];
    const double t = std::clamp((p - outline[i]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    squared = std::min(squared, (outline[i] + t * along - p).squaredNorm());
  }
  return -std::sqrt(squared);
}

}  // namespace handwheel
