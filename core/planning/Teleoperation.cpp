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
constexpr double kStepSeconds = 0.05;  // duration of such a step for the joints
constexpr int kMostSteps = 40;         // limit for one lead; a hand that leaps further is followed less closely
constexpr double kLongestLead = 0.05;  // rad, for a joint that follows the hand itself
constexpr double kNoNearer = 1e-3;     // mm
constexpr double kStill = 1e-7;        // rad, mm: of the joints

double angleBetween(const Pose& a, const Pose& b) {
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
}

}  // namespace

Teleoperation::Teleoperation(const RobotScene& scene, const SerialArm& arm, const Pose& tool, const ArmValues& start,
                             const TeleoperationSettings& settings)
    : m_scene(scene),
      m_arm(arm.withTool(tool)),
      m_settings(settings),
      m_values(start),
      m_wanted(Teleoperation::tool()) {}

// Clamps values to the limits. A joint beyond a limit may only return.
ArmValues Teleoperation::withinLimits(ArmValues to) const {
  for (Eigen::Index i = 0; i < to.size(); ++i) {
    const ArmJoint& joint = m_scene.joint(i);
    if (to[i] > joint.upper) to[i] = std::max(joint.upper, std::min(to[i], m_values[i]));
    if (to[i] < joint.lower) to[i] = std::min(joint.lower, std::max(to[i], m_values[i]));
  }
  return to;
}

// Returns the joint values nearest to the wanted pose, no further than the joints get in that time.
ArmValues Teleoperation::towards(const Pose& wanted, double seconds) const {
  NumericalIkSettings ik;
  ik.mostStarts = 1;
  ik.tolerance = m_settings.tolerance;
  NumericalIkResult found = solvedNumerically(m_arm, wanted, m_values, ik);
  if (!found.isSolved && m_arm.size() < kJointsOfAnyPose) found = solvedForPosition(m_arm, wanted, m_values, ik);
  const ArmValues change = found.values - m_values;
  double slower = 1.0;
  for (Eigen::Index i = 0; i < change.size(); ++i) {
    const ArmJoint& joint = m_scene.joint(i);
    const double most = seconds * joint.velocity.value_or(joint.isPrismatic ? m_settings.sliding : m_settings.turning);
    if (std::abs(change[i]) > most) slower = std::min(slower, most / std::abs(change[i]));
  }
  return withinLimits(m_values + slower * change);
}

// Moves to these values, or as near as bisection of the motion proves free by this check. None: no motion. Otherwise
// true if it arrived.
std::optional<bool> Teleoperation::advanceProven(const ArmValues& to, const MotionCheckSettings& check, double least) {
  constexpr int kHalvings = 4;
  const ArmValues from = m_values;
  double share = 1.0;
  for (int i = 0; i <= kHalvings; ++i, share *= 0.5) {
    const ArmValues values = i == 0 ? to : ArmValues(from + share * (to - from));
    if (MotionCheck(m_scene, from, values, check).run() != MotionCheck::State::Free) continue;
    if (least > 0.0 && m_scene.nearestObstacle(values, least).distance < least) continue;
    m_values = values;
    return i == 0;
  }
  return std::nullopt;
}

// Returns false if it did not arrive. A robot that violates its clearance may move if it gets no nearer; one in
// collision, in small steps out of it.
bool Teleoperation::advance(const ArmValues& to) {
  if (const auto went = advanceProven(to, m_settings.check, 0.0)) return *went;
  if (isFreeAt(m_scene, m_values, m_settings.check)) return false;
  MotionCheckSettings nearer = m_settings.check;
  const double distance = m_scene.nearestObstacle(m_values, nearer.clearance + nearer.resolution).distance;
  if (distance > nearer.resolution) {
    nearer.clearance = std::min(nearer.clearance, distance - nearer.resolution);
    if (const auto went = advanceProven(to, nearer, distance)) return *went;
    if (isFreeAt(m_scene, m_values, nearer)) return false;
  }
  if (!m_escape) m_escape.emplace(m_scene);
  const ArmValues change = to - m_values;
  const double travel = m_scene.travelBound(m_values, change.cwiseAbs());
  const double share = travel > ContactEscape::kLongestStep ? ContactEscape::kLongestStep / travel : 1.0;
  const ArmValues values = m_values + 0.99 * share * change;
  if (!m_escape->mayGo(m_values, values, m_settings.check.resolution)) return false;
  m_values = values;
  return true;
}

// Moves joints that bring the tool nearer one by one if the straight motion is blocked.
bool Teleoperation::slide(const ArmValues& to, const Pose& wanted) {
  if (advance(to)) return true;
  for (Eigen::Index i = 0; i < to.size(); ++i) {
    ArmValues alone = m_values;
    alone[i] = to[i];
    const double before = (tool().translation() - wanted.translation()).norm();
    const double after = (m_arm.tipPose(alone).translation() - wanted.translation()).norm();
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
  const Vec3 translation = wanted.translation() - from.translation();
  const Eigen::Quaterniond before(from.linear()), after(wanted.linear());
  const double steps =
      std::ceil(std::max(translation.norm() / kLongestStep, angleBetween(from, wanted) / kLargestTurn));
  const int count = static_cast<int>(std::clamp(steps, 1.0, static_cast<double>(kMostSteps)));
  Step step;
  int held = 0;  // steps without any motion: pushing on has no effect
  for (int i = 1; i <= count && held < 2; ++i) {
    const double share = static_cast<double>(i) / count;
    m_wanted = Eigen::Translation3d(from.translation() + share * translation) * before.slerp(share, after);
    const ArmValues values = m_values;
    step = follow(i == count ? wanted : m_wanted, kStepSeconds);
    held = step.isBlocked && (m_values - values).cwiseAbs().maxCoeff() < kStill ? held + 1 : 0;
  }
  m_wanted = wanted;
  if (held > 0) {
    step = stepTo(wanted);
    step.isBlocked = true;
  }
  for (int i = 0; i < kMostSteps && !step.isBlocked; ++i) {
    const double off = step.behind + kLongestStep / kLargestTurn * angleBetween(step.tool, wanted);
    const ArmValues values = m_values;
    if (off < kNoNearer) break;
    step = follow(wanted, kStepSeconds);
    if ((m_values - values).cwiseAbs().maxCoeff() < kStill) break;
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
  Step step = stepTo(wanted.allFinite() ? m_arm.tipPose(wanted) : tool());
  step.isBlocked = isBlocked;
  return step;
}

}  // namespace handwheel
