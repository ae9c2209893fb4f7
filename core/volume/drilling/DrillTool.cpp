// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillTool.h"

#include "base/NumberText.h"

#include <algorithm>
#include <array>
#include <cmath>
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
