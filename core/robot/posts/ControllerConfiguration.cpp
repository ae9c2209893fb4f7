// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/ControllerConfiguration.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

struct ArmPoints {
  Vec3 base, up, shoulder, elbow, wrist, across;  // mm; across: the second axis
};

ArmPoints pointsOf(const SerialArm& arm, const ArmValues& values) {
  std::array<Pose, 6> poses;
  arm.jointPoses(values, poses);
  const Vec3 first = poses[0].linear().col(2);  // down if the joint has a negative sign
  return {poses[0].translation(), first.z() < 0.0 ? Vec3(-first) : first,
          poses[1].translation(), poses[2].translation(),
          poses[4].translation(), poses[1].linear().col(2)};
}

constexpr double kLimitSlack = 1e-5;  // rad: excess over its limits of an axis in a file, as files round poses

enum class Slack { Least, OfRounding };

// Moves a value by whole turns into the limits; returns the nearest of the accepted ones.
std::optional<double> turnedInto(const ArmJoint& joint, double value, double near,
                                 const std::function<bool(double)>& takes) {
  std::optional<double> nearest;
  for (int turns = -2; turns <= 2; ++turns) {
    const double moved = value + 2.0 * M_PI * turns;
    if (!joint.isWithin(moved, kLimitSlack) || !takes(moved)) continue;
    const double within = std::min(std::max(moved, joint.lower), joint.upper);
    if (!nearest || std::abs(within - near) < std::abs(*nearest - near)) nearest = within;
  }
  return nearest;
}

std::optional<ArmValues> nearestOfConfiguration(const WantedConfiguration& wanted, const SerialArm& arm,
                                                const ClosedFormIk& closed, const Pose& tip, const ArmValues& reference,
                                                Slack slack) {
  IkSolutions solutions;
  closed.solve(tip, reference, solutions);
  std::optional<ArmValues> nearest;
  for (const IkSolutions::Solution& solution : solutions) {
    ArmValues values = solution.values;
    bool isWithin = true;
    for (Eigen::Index i = 0; i < values.size() && isWithin; ++i) {
      const double off = slack == Slack::Least ? kPoseRounding : jointRounding(solution.values, i);
      const auto value = turnedInto(arm.joints()[static_cast<std::size_t>(i)], values[i], reference[i],
                                    [&](double moved) { return wanted.takesJoint(i, moved, off); });
      isWithin = value.has_value();
      values[i] = value.value_or(0.0);
    }
    if (!isWithin || !wanted.takes(values)) continue;
    if (arm.coupling() && !arm.coupling()->isWithin(values, kLimitSlack)) continue;
    if (!nearest || (values - reference).squaredNorm() < (*nearest - reference).squaredNorm()) nearest = values;
  }
  return nearest;
}

}  // namespace

ControllerConfiguration controllerConfigurationOf(const SerialArm& arm, const ArmValues& values) {
  const ArmPoints rest = pointsOf(arm, ArmValues::Zero(6)), now = pointsOf(arm, values);
  const double side = (rest.wrist - rest.base).dot(rest.across.cross(rest.up)) < 0.0 ? -1.0 : 1.0;
  const Vec3 forward = side * now.across.cross(now.up), across = now.up.cross(forward);
  ControllerConfiguration configuration;
  configuration.isRear = (now.wrist - now.base).dot(forward) < 0.0;
  configuration.isElbowDown = across.dot((now.elbow - now.shoulder).cross(now.wrist - now.shoulder)) < 0.0;
  configuration.isFlipped = values[4] < 0.0;
  return configuration;
}

std::optional<ClosedFormIk> closedFormOfSphericalWrist(const SerialArm& arm) {
  auto closed = ClosedFormIk::of(arm);
  if (!closed) return closed;
  const auto shoulder = closed->configurationOf(arm, ArmValues::Zero(arm.size())).shoulder;
  const bool isSpherical =
      shoulder == ArmConfiguration::Shoulder::Front || shoulder == ArmConfiguration::Shoulder::Rear;
  return isSpherical ? closed : std::nullopt;
}

ArmValues countedByController(const SerialArm& arm, ArmValues values) {
  if (arm.coupling()) values[2] = arm.coupling()->third(values);
  return values;
}

ArmValues countedByModel(const SerialArm& arm, ArmValues values) {
  if (arm.coupling()) values[2] -= arm.coupling()->factor * values[1];
  return values;
}

bool hasParallelLinkage(const SerialArm& arm) {
  return arm.coupling() && arm.coupling()->factor > 0.0;
}

bool isWristInLine(const ArmValues& values) {
  return std::abs(std::sin(values[4])) < 2.0 * kPoseRounding;
}

double jointRounding(const ArmValues& values, Eigen::Index joint) {
  const bool isBesideFifth = joint == 3 || joint == 5;
  return isBesideFifth && !isWristInLine(values) ? kPoseRounding / std::abs(std::sin(values[4])) : kPoseRounding;
}

std::optional<ArmValues> jointsOfConfiguration(const WantedConfiguration& wanted, const SerialArm& arm,
                                               const ClosedFormIk& closed, const Pose& tip,
                                               std::span<const ArmValues> references) {
  const auto found = [&](const Pose& pose, Slack slack) -> std::optional<ArmValues> {
    for (const ArmValues& reference : references) {
      if (auto values = nearestOfConfiguration(wanted, arm, closed, pose, reference, slack)) return values;
    }
    return std::nullopt;
  };
  if (auto values = found(tip, Slack::Least)) return values;
  if (auto values = found(tip, Slack::OfRounding)) return values;
  // The pose was written with the axes in line, and rounded: the angles of the axes 4 and 6 come from the rounding.
  IkSolutions solutions;
  closed.solve(tip, references.front(), solutions);
  for (const IkSolutions::Solution& solution : solutions) {
    if (!isWristInLine(solution.values)) continue;
    ArmValues straight = solution.values;
    straight[4] = M_PI * std::round(straight[4] / M_PI);
    if (auto values = found(arm.tipPose(straight), Slack::Least)) return values;
  }
  return std::nullopt;
}

}  // namespace handwheel
