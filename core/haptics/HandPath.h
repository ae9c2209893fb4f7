// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <cstdint>
#include <vector>

namespace handwheel {

// Where a hand is, or wants to be, at a time; in the frame of the device.
struct HandPose {
  double time = 0.0;             // s
  Vec3 position = Vec3::Zero();  // mm
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  std::uint32_t buttons = 0;
};

// A way through poses: straight and at constant speed from one to the next, turning the short way; buttons change with
// the pose that has them. Before the first pose and after the last it rests there.
class HandPath {
 public:
  HandPath() = default;
  // Times must not fall.
  explicit HandPath(std::vector<HandPose> poses);

  bool isEmpty() const { return m_poses.empty(); }
  double duration() const { return m_poses.empty() ? 0.0 : m_poses.back().time; }
  // For a path that is not empty. In O(log n), without allocation.
  HandPose at(double time) const noexcept;

 private:
  std::vector<HandPose> m_poses;
};

}  // namespace handwheel
