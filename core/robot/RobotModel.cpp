// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/RobotModel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace handwheel {

std::uint32_t linkNamed(const RobotModel& robot, std::string_view name) {
  const auto found =
      std::find_if(robot.links.begin(), robot.links.end(), [&](const Link& link) { return link.name == name; });
  return found == robot.links.end() ? kNone : static_cast<std::uint32_t>(found - robot.links.begin());
}

std::uint32_t toolLink(const RobotModel& robot) {
  std::vector<int> moving(robot.links.size()), all(robot.links.size());  // joints above each link
  std::vector<bool> isLeaf(robot.links.size(), true);
  int most = 0;
  for (std::uint32_t j : robot.order) {
    const Joint& joint = robot.joints[j];
    const bool isOwn = joint.dof != kNone && robot.dofs[joint.dof] == j;
    moving[joint.child] = moving[joint.parent] + isOwn;
    all[joint.child] = all[joint.parent] + 1;
    isLeaf[joint.parent] = false;
    most = std::max(most, moving[joint.child]);
  }
  const auto rank = [&](std::uint32_t l) {
    const Link& link = robot.links[l];
    const bool isFixed = link.parentJoint != kNone && robot.joints[link.parentJoint].kind == JointKind::Fixed;
    const bool isFrame = isFixed && link.visuals.empty() && link.collisions.empty() && 2 * moving[l] >= most;
    return std::tuple(bool(isLeaf[l]), isFrame, moving[l], all[l]);
  };
  std::uint32_t best = robot.root;
  for (std::uint32_t link = 0; link < robot.links.size(); ++link) {
    if (rank(link) > rank(best)) best = link;
  }
  return best;
}

std::uint32_t dofMoving(const RobotModel& robot, std::uint32_t link) {
  for (std::uint32_t j = robot.links[link].parentJoint; j != kNone;
       j = robot.links[robot.joints[j].parent].parentJoint) {
    if (robot.joints[j].dof != kNone) return robot.joints[j].dof;
  }
  return kNone;
}

namespace {

// Returns true for each degree of freedom for which a whole turn changes nothing. For those with followers it does, as
// their turn is not whole.
std::vector<bool> turnFreely(const RobotModel& robot) {
  std::vector<bool> all(robot.dofs.size());
  for (std::size_t dof = 0; dof < robot.dofs.size(); ++dof)
    all[dof] = robot.jointOfDof(dof).kind == JointKind::Continuous;
  for (std::uint32_t j = 0; j < robot.joints.size(); ++j) {
    const std::uint32_t dof = robot.joints[j].dof;
    if (dof != kNone && robot.dofs[dof] != j) all[dof] = false;
  }
  return all;
}

}  // namespace

JointValues withinLimits(const RobotModel& robot, JointValues values) {
  const std::vector<bool> isFree = turnFreely(robot);
  for (std::size_t dof = 0; dof < robot.dofs.size(); ++dof) {
    const Joint& joint = robot.jointOfDof(dof);
    double& value = values[static_cast<Eigen::Index>(dof)];
    if (isFree[dof] && std::abs(value) > kMostTurn)
      value = std::remainder(value, 2.0 * std::numbers::pi);
    else if (joint.kind == JointKind::Continuous)
      value = std::clamp(value, -kMostTurn, kMostTurn);
    else
      value = joint.nearest(value);
  }
  return values;
}

JointValues byShortestTurn(const RobotModel& robot, const JointValues& from, JointValues to) {
  const std::vector<bool> isFree = turnFreely(robot);
  for (Eigen::Index dof = 0; dof < to.size(); ++dof) {
    if (isFree[static_cast<std::size_t>(dof)])
      to[dof] = from[dof] + std::remainder(to[dof] - from[dof], 2.0 * std::numbers::pi);
  }
  return to;
}

JointValues restValues(const RobotModel& robot) {
  return withinLimits(robot, JointValues::Zero(static_cast<Eigen::Index>(robot.dofs.size())));
}

}  // namespace handwheel
