// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nurbs/UnitCircle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handwheel::unit_circle {

std::array<Eigen::Vector2d, 9> poles() {
  std::array<Eigen::Vector2d, 9> result;
  const std::array<double, 8> x = {1, 1, 0, -1, -1, -1, 0, 1};
  for (std::size_t i = 0; i < 9; ++i) result[i] = {x[i % 8], x[(i + 6) % 8]};
  return result;
}

std::array<double, 9> weights() {
  constexpr double w = std::numbers::sqrt2 / 2.0;
  return {1, w, 1, w, 1, w, 1, w, 1};
}

std::vector<double> knots() {
  return {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1};
}

Point at(double u) {
  const double parameter = 4.0 * std::clamp(u, 0.0, 1.0);
  const int quarter = std::min(3, static_cast<int>(parameter));
  const double t = parameter - quarter, s = 1.0 - t;
  const double middle = std::numbers::sqrt2 * t * s;
  const double w = s * s + middle + t * t;
  const double cosine = (s * s + middle) / w, sine = (middle + t * t) / w;
  // With a = s² + √2ts and b = √2ts + t², a² + b² = w² and ab' - a'b = √2w; so θ' = √2/w in each of four quarters.
  const double speed = 4.0 * std::numbers::sqrt2 / w;
  switch (quarter) {
    case 0:
      return {{cosine, sine}, speed};
    case 1:
      return {{-sine, cosine}, speed};
    case 2:
      return {{-cosine, -sine}, speed};
    default:
      return {{sine, -cosine}, speed};
  }
}

}  // namespace handwheel::unit_circle
