// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/device/PoseTrajectory.h"

#include <algorithm>
#include <cassert>

namespace handwheel {

namespace {
bool isEarlier(const HandPose& a, const HandPose& b) {
  return a.time < b.time;
}
}  // namespace

PoseTrajectory::PoseTrajectory(std::vector<HandPose> poses) : m_poses(std::move(poses)) {
  assert(std::is_sorted(m_poses.begin(), m_poses.end(), isEarlier));
}

HandPose PoseTrajectory::at(double time) const noexcept {
  HandPose wanted;
  wanted.time = time;
  const auto next = std::upper_bound(m_poses.begin(), m_poses.end(), wanted, isEarlier);
  const HandPose& from = next == m_poses.begin() ? *next : *(next - 1);
  wanted.buttons = from.buttons;
  wanted.position = from.position;
  wanted.orientation = from.orientation;
  if (next == m_poses.begin() || next == m_poses.end()) return wanted;
  const double share = (time - from.time) / (next->time - from.time);
  wanted.position += share * (next->position - from.position);
  wanted.orientation = from.orientation.slerp(share, next->orientation);
  return wanted;
}

}  // namespace handwheel
