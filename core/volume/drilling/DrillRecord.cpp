// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillRecord.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

// Whole, within what a type can hold; 0 for what is no number.
template <class Whole>
Whole nearest(double value) {
  if (std::isnan(value)) return 0;
  return static_cast<Whole>(
      std::clamp<double>(std::round(value), std::numeric_limits<Whole>::min(), std::numeric_limits<Whole>::max()));
}

}  // namespace

DrillPose DrillPose::of(const Vec3& place, const Vec3& axis, double seconds) {
  DrillPose pose;
  pose.micros = nearest<std::uint32_t>(1e6 * seconds);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    pose.at[k] = nearest<std::int32_t>(place[i] / kStep);
    pose.axis[k] = static_cast<float>(axis[i]);
  }
  return pose;
}

Vec3 DrillPose::direction() const {
  return Vec3(axis[0], axis[1], axis[2]).normalized();
}

bool DrillPose::isSound() const {
  const Vec3 along(axis[0], axis[1], axis[2]);
  return along.allFinite() && along.norm() > 0.5 && along.norm() < 2.0;
}

}  // namespace handwheel
