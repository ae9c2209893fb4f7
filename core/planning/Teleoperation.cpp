// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/Teleoperation.h"

#include "robot/arm/NumericalIk.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kLongestStep = 10.0;  // mm of the tool
constexpr double kLargestTurn = 0.05;  // rad
constexpr double kStepSeconds = 0.05;  // what the joints have for such a step
constexpr int kMostSteps = 40;         // of a lead; a hand that leaps further is followed less closely
constexpr double kLongestLead = 0.05;  // rad, of a joint that follows the hand itself
constexpr double kNoNearer = 1e-3;     // mm

double angleBetween(const Pose& a, const Pose& b) {
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
}

}  // namespace

Teleoperation::Teleoperation(const RobotScene& scene, const SerialArm& arm, const Pose& tool, const ArmValues& start,
                             const TeleoperationSettings& settings)
    : m_scene(scene),
      m_arm(arm),
      m_tool(tool),
      m_settings(settings),
      m_values(start),
      m_wanted(Teleoperation::tool()) {}

// A joint that is beyond a limit may only come back.
ArmValues Teleoperation::withinLimits(ArmValues to) const {
  for (Eigen::Index i = 0; i < to.size(); ++i) {
    const ArmJoint& joint = m_scene.joint(i);
    if (to[i] > joint.upper) to[i] = std::max(joint.upper, std::min(to[i], m_values[i]));
    if (to[i] < joint.lower) to[i] = std::min(joint.lower, std::max(to[i], m_values[i]));
  }
  return to;
}

// The joint values next to those now that are nearest to what is wanted, no further than the joints get in that time.
ArmValues Teleoperation::towards(const Pose& wanted, double seconds) const {
  NumericalIkSettings ik;
  ik.mostStarts = 1;
  ik.tolerance = m_settings.tolerance;
  const NumericalIkResult found = solvedNumerically(m_arm, wanted * m_tool.inverse(Eigen::Isometry), m_values, ik);
  const ArmValues way = found.values - m_values;
  double slower = 1.0;
  for (Eigen::Index i = 0; i < way.size(); ++i) {
    const ArmJoint& joint = m_scene.joint(i);
    const double most = seconds * joint.velocity.value_or(joint.isPrismatic ? m_settings.sliding : m_settings.turning);
    if (std::abs(way[i]) > most) slower = std::min(slower, most / std::abs(way[i]));
  }
  return withinLimits(m_values + slower * way);
}

// Goes there, or as near as halving the way shows to be free. False: not all of the way. Where the robot meets
// something already, it may go where it gets no deeper.
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
  const RobotScene::Nearest now = blockerAt(m_scene, from, m_settings.check);
  if (now.link == kNone) return false;
  const RobotScene::Nearest then = blockerAt(m_scene, to, m_settings.check);
  if (then.link != kNone && then.distance < now.distance) return false;
  m_values = to;
  return true;
}

// Where the straight way is blocked, joints that bring the tool nearer go on alone.
bool Teleoperation::slide(const ArmValues& to, const Pose& wanted) {
  if (advance(to)) return true;
  for (Eigen::Index i = 0; i < to.size(); ++i) {
    ArmValues alone = m_values;
    alone[i] = to[i];
    const double before = (tool().translation() - wanted.translation()).norm();
    const double after = ((m_arm.tipPose(alone) * m_tool).translation() - wanted.translation()).norm();
    if (alone[i] != m_values[i] && after < before) advance(alone);
  }
  return false;
}

Teleoperation::Step Teleoperation::stepTo(const Pose& wanted) const {
  Step step;
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

Teleoperation::Step Teleoperation::follow(const Pose& wanted, double seconds) {
  const bool isUsable = wanted.matrix().allFinite() && seconds > 0.0;
  const bool isBlocked = isUsable && !slide(towards(wanted, seconds), wanted);
  Step step = stepTo(wanted);
  step.isBlocked = isBlocked;
  return step;
}

Teleoperation::Step Teleoperation::lead(const Pose& wanted) {
  if (!wanted.matrix().allFinite()) return stepTo(m_wanted);
  const Pose from = m_wanted;
  const Vec3 way = wanted.translation() - from.translation();
  const Eigen::Quaterniond before(from.linear()), after(wanted.linear());
  const double steps = std::ceil(std::max(way.norm() / kLongestStep, angleBetween(from, wanted) / kLargestTurn));
  const int count = static_cast<int>(std::clamp(steps, 1.0, static_cast<double>(kMostSteps)));
  Step step;
  for (int i = 1; i <= count; ++i) {
    const double share = static_cast<double>(i) / count;
    m_wanted = Eigen::Translation3d(from.translation() + share * way) * before.slerp(share, after);
    step = follow(i == count ? wanted : m_wanted, kStepSeconds);
  }
  m_wanted = wanted;
  for (int i = 0; i < kMostSteps && !step.isBlocked; ++i) {
    const double off = step.behind + kLongestStep / kLargestTurn * angleBetween(step.tool, wanted);
    const ArmValues values = m_values;
    if (off < kNoNearer) break;
    step = follow(wanted, kStepSeconds);
    if ((m_values - values).cwiseAbs().maxCoeff() < 1e-7) break;
  }
  return step;
}

Teleoperation::Step Teleoperation::lead(const ArmValues& wanted) {
  bool isBlocked = false;
  if (wanted.allFinite()) {
    const ArmValues to = withinLimits(wanted), from = m_values;
    const double steps = std::ceil((to - from).cwiseAbs().maxCoeff() / kLongestLead);
    const int count = static_cast<int>(std::clamp(steps, 1.0, static_cast<double>(kMostSteps)));
    for (int i = 1; i <= count && !isBlocked; ++i)
      isBlocked = !advance(i == count ? to : ArmValues(from + (to - from) * (static_cast<double>(i) / count)));
  }
  Step step = stepTo(wanted.allFinite() ? Pose(m_arm.tipPose(wanted) * m_tool) : tool());
  step.isBlocked = isBlocked;
  return step;
}

}  // namespace handwheel
