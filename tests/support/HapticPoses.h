// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mapping/WorkspaceMapping.h"

#include <rapidcheck.h>
#include <numbers>

// Random vectors, rotations and mappings for property tests.
namespace handwheel::test {

inline double anyNumber(double largest = 100.0) {
  return largest * *rc::gen::inRange(-10000, 10001) / 10000.0;
}

inline Vec3 anyVector(double largest = 100.0) {
  const double x = anyNumber(largest), y = anyNumber(largest), z = anyNumber(largest);
  return {x, y, z};
}

inline Eigen::Quaterniond anyRotation() {
  const Vec3 axis = anyVector() + Vec3(0, 0, 1e-3);
  const double angle = anyNumber(std::numbers::pi);
  return Eigen::Quaterniond(
      Eigen::AngleAxisd(angle, axis.norm() > 0.0 ? Vec3(axis.normalized()) : Vec3(Vec3::UnitX())));
}

inline WorkspaceMapping anyMapping() {
  WorkspaceMapping mapping;
  mapping.sceneFromView.linear() = anyRotation().toRotationMatrix();
  mapping.sceneFromView.translation() = anyVector(1000.0);
  mapping.scale = *rc::gen::element(0.01, 0.5, 1.0, 3.0, 100.0);
  mapping.forceGain = *rc::gen::element(0.1, 1.0, 2.0);
  const int first = *rc::gen::inRange(0, 3), turn = *rc::gen::inRange(1, 3);
  const std::array<int, 3> order{first, (first + turn) % 3, (first + 2 * turn) % 3};
  for (std::size_t i = 0; i < 3; ++i) mapping.axes[i] = {order[i], *rc::gen::inRange(0, 2) == 1};
  return mapping;
}

}  // namespace handwheel::test
