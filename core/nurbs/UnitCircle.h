// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace handwheel {

// The unit circle as a rational quadratic B-spline of nine poles. It consists of four quarters with the weights 1, √½,
// 1 (Piegl and Tiller, "The NURBS Book", 7.3). Every point is on the circle to the last digit.
namespace unit_circle {

std::array<Eigen::Vector2d, 9> poles();
std::array<double, 9> weights();
std::vector<double> knots();  // 12 knots, over 0…1

// A point (cos θ, sin θ) of the unit circle with its angular speed dθ/du. The speed is between 2π · 0.90 and 2π · 1.06.
struct Point {
  Eigen::Vector2d direction;
  double speed;
};
// Returns the point at u, which is clamped to 0…1.
Point at(double u);

}  // namespace unit_circle

}  // namespace handwheel
