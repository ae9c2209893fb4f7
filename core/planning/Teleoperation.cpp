// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/Teleoperation.h"

#include "robot/arm/NumericalIk.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

Teleoperation::Teleoperation(const RobotScene& scene, const SerialArm& arm, const Pose& tool, const ArmValues& start,
                             const TeleoperationSettings& settings)
    : m_scene(scene), m_arm(arm), m_tool(tool), m_settings(settings), m_values(start) {}

// The joint values next to those now that are nearest to what is wanted, no further than the joints get in that time.
ArmValues Teleoperation::towards(const Pose& wanted, double seconds) const {
  NumericalIkSettings ik;
  ik.mostStarts = 1;
  const NumericalIkResult found = solvedNumerically(m_arm, wanted * m_tool.inverse(Eigen::Isometry), m_values, ik);
  ArmValues way = found.values - m_values;
  double slower = 1.0;
  for (Eigen::Index i = 0; i < way.size(); ++i) {
    const ArmJoint& joint = m_scene.joint(i);
    const double most = seconds * joint.velocity.value_or(joint.isPrismatic ? m_settings.sliding : m_settings.turning);
    if (std::abs(way[i]) > most) slower = std::min(slower, most / std::abs(way[i]));
  }
  ArmValues to = m_values + slower * way;
  for (Eigen::Index i = 0; i < to.size(); ++i) {
    // A joint that is beyond a limit may only come back.
    const ArmJoint& joint = m_scene.joint(i);
    if (to[i] > joint.upper) to[i] = std::max(joint.upper, std::min(to[i], m_values[i]));
    if (to[i] < joint.lower) to[i] = std::min(joint.lower, std::max(to[i], m_values[i]));
  }
  return to;
}

// Goes there, or as near as halving the way shows to be free. False: not all of the way.
bool Teleoperation::advance(const ArmValues& to) {
  constexpr int kHalvings = 4;
  const ArmValues from = m_values;
  double share = 1.0;
  for (int i = 0; i <= kHalvings; ++i, share *= 0.5) {
    const ArmValues place = i == 0 ? to : ArmValues(from + share * (to - from));
    if (MotionCheck(m_scene, from, place, m_settings.check).run() != MotionCheck::State::Free) continue;
    m_values = place;
    return i == 0;
  }
  return false;
}

Teleoperation::Step Teleoperation::follow(const Pose& wanted, double seconds) {
  Step step;
  if (wanted.matrix().allFinite() && seconds > 0.0) {
    const ArmValues to = towards(wanted, seconds);
    step.isBlocked = !advance(to);
    if (step.isBlocked) {
      for (Eigen::Index i = 0; i < to.size(); ++i) {
        ArmValues alone = m_values;
        alone[i] = to[i];
        const double before = (tool().translation() - wanted.translation()).norm();
        const double after = ((m_arm.tipPose(alone) * m_tool).translation() - wanted.translation()).norm();
        if (alone[i] != m_values[i] && after < before) advance(alone);
      }
    }
  }
  step.tool = tool();
  const Vec3 away = step.tool.translation() - wanted.translation();
  step.behind = wanted.matrix().allFinite() ? away.norm() : 0.0;
  if (step.behind > 0.0) {
    const double size = std::min(m_settings.largestForce, m_settings.stiffness * step.behind);
    step.force = away * (size / step.behind);
  }
  for (Eigen::Index i = 0; i < m_values.size(); ++i) {
    const ArmJoint& joint = m_scene.joint(i);
    constexpr double kAt = 1e-9;  // rad, mm
    step.isAtLimit |= m_values[i] >= joint.upper - kAt || m_values[i] <= joint.lower + kAt;
  }
  return step;
}

}  // namespace handwheel
