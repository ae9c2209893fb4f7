// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillRecord.h"

#include "base/Fingerprint.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr double kMostWhole = 9e15;  // up to there doubles hold all whole numbers

// Returns an integer from least to kMostWhole; 0 for NaN.
std::int64_t nearest(double value, double least) {
  if (std::isnan(value)) return 0;
  return static_cast<std::int64_t>(std::clamp(std::round(value), least, kMostWhole));
}

}  // namespace

DrillPose DrillPose::of(const Vec3& position, const Vec3& axis, double seconds) {
  DrillPose pose;
  pose.micros = static_cast<std::uint64_t>(nearest(1e6 * seconds, 0.0));
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    pose.at[k] = nearest(position[i] / kStep, -kMostWhole);
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

void addTo(Fingerprint& mark, const DrillPose& pose) {
  mark.add(pose.micros);
  for (const std::int64_t at : pose.at) mark.add(static_cast<std::uint64_t>(at));
  for (const float direction : pose.axis) mark.add(static_cast<double>(direction));
}

}  // namespace handwheel
