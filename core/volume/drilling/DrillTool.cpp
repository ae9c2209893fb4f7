// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillTool.h"

#include "base/NumberText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace handwheel {

double DrillTool::reach() const {
  return shape == DrillShape::Twist ? radius() / std::tan(0.5 * pointAngle) : radius();
}

double DrillTool::inside(const Vec3& from, const Vec3& axis) const {
  if (shape != DrillShape::Twist) return radius() - from.norm();
  const double up = from.dot(axis), across = (from - up * axis).norm(), half = 0.5 * pointAngle;
  const double cone = (up + reach()) * std::sin(half) - across * std::cos(half);
  return std::min({radius() - across, cone, length - up});
}

double DrillTool::signedDepth(const Vec3& from, const Vec3& axis) const {
  const double bound = inside(from, axis);
  if (shape != DrillShape::Twist || bound >= 0.0) return bound;
  // In the half plane through the axis: from the tip to the rim, the back and the axis again.
  using Point = Eigen::Vector2d;
  const double up = from.dot(axis);
  const Point p((from - up * axis).norm(), up);
  const std::array<Point, 4> outline{Point(0.0, -reach()), Point(radius(), 0.0), Point(radius(), length),
                                     Point(0.0, length)};
  double squared = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    const Point along = outline[i + 1] - outline[i];
    const double t = std::clamp((p - outline[i]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    squared = std::min(squared, (outline[i] + t * along - p).squaredNorm());
  }
  return -std::sqrt(squared);
}

std::optional<DrillTool> drillToolOf(std::string_view word) {
  static constexpr std::array<std::pair<std::string_view, DrillShape>, 3> kShapes{
      {{"ball", DrillShape::Ball}, {"burr", DrillShape::Burr}, {"twist", DrillShape::Twist}}};
  const std::size_t colon = word.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto shape = std::find_if(kShapes.begin(), kShapes.end(),
                                  [&](const auto& entry) { return entry.first == word.substr(0, colon); });
  double diameter = 0.0;
  ErrorCode why{};
  if (shape == kShapes.end() || !parseDecimal(word.substr(colon + 1), diameter, why)) return std::nullopt;
  if (!(diameter >= DrillTool::kLeastDiameter && diameter <= DrillTool::kLargestDiameter)) return std::nullopt;
  DrillTool tool;
  tool.shape = shape->second;
  tool.diameter = diameter;
  tool.length = 10.0 * diameter;
  return tool;
}

}  // namespace handwheel
