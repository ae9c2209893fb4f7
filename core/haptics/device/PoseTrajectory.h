// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <cstdint>
#include <vector>

namespace handwheel {

// Measured or desired pose of the hand at a time, in device coordinates.
struct HandPose {
  double time = 0.0;             // s
  Vec3 position = Vec3::Zero();  // mm
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  std::uint32_t buttons = 0;
};

// Trajectory that interpolates linearly between timed poses. The speed between two poses is constant, and rotations
// take the shorter arc. Buttons change when a pose is reached. The hand is at rest before the first pose and after the
// last.
class PoseTrajectory {
 public:
  PoseTrajectory() = default;
  // The times must not decrease.
  explicit PoseTrajectory(std::vector<HandPose> poses);

  bool isEmpty() const { return m_poses.empty(); }
  double duration() const { return m_poses.empty() ? 0.0 : m_poses.back().time; }
  // Returns the pose at a time, s. The trajectory must not be empty. O(log n), without allocation.
  HandPose at(double time) const noexcept;

 private:
  std::vector<HandPose> m_poses;
};

}  // namespace handwheel
