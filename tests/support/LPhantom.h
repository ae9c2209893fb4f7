// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace handwheel::test {

// A phantom without any symmetry. It has bars of 8 × 8 mm² from a corner at the origin: 30 mm to the left (+x), 22 mm
// to the back (+y) and 14 mm to the head (+z). Beside them is a ball of 8 mm across.
inline const Vec3 kLPhantomBall(-12, 10, 6);
inline constexpr double kLPhantomVolume = 8.0 * 8.0 * (30.0 + 22.0 + 14.0 - 2 * 8.0) + M_PI / 6.0 * 8.0 * 8.0 * 8.0;

// Returns 1000 in the phantom, 0 outside of it, and whole values over 3 mm at its surface, with 500 on it.
inline double lPhantom(const Vec3& p) {
  const auto depthInBox = [&](const Vec3& size) {
    const Vec3 beyond = (p - 0.5 * size).cwiseAbs() - 0.5 * size;
    const double outside = beyond.cwiseMax(0.0).norm();
    return outside > 0.0 ? -outside : -beyond.maxCoeff();
  };
  const double depth = std::max({depthInBox(Vec3(30, 8, 8)), depthInBox(Vec3(8, 22, 8)), depthInBox(Vec3(8, 8, 14)),
                                 4.0 - (p - kLPhantomBall).norm()});
  return std::round(1000.0 * std::clamp(0.5 + depth / 3.0, 0.0, 1.0));
}

// Returns the 24 rotations of a cube.
inline std::vector<Eigen::Matrix3d> turnsOfCube() {
  std::vector<Eigen::Matrix3d> turns;
  for (int first = 0; first < 6; ++first)
    for (int second = 0; second < 6; ++second) {
      if (first / 2 == second / 2) continue;
      Eigen::Matrix3d turn;
      turn.col(0) = (first % 2 == 0 ? 1.0 : -1.0) * Vec3::Unit(first / 2);
      turn.col(1) = (second % 2 == 0 ? 1.0 : -1.0) * Vec3::Unit(second / 2);
      turn.col(2) = turn.col(0).cross(turn.col(1));
      turns.push_back(turn);
    }
  return turns;
}

}  // namespace handwheel::test
