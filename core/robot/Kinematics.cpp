// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/Kinematics.h"

#include <cassert>

namespace handwheel {

double jointPosition(const Joint& joint, const JointValues& values) {
  return joint.dof == kNone ? joint.offset : joint.factor * values[joint.dof] + joint.offset;
}

std::vector<Pose> linkPoses(const RobotModel& robot, const JointValues& values) {
  assert(values.size() == static_cast<Eigen::Index>(robot.dofs.size()));
  std::vector<Pose> poses(robot.links.size(), Pose::Identity());
  for (std::uint32_t j : robot.order) {
    const Joint& joint = robot.joints[j];
    Pose& child = poses[joint.child];
    child = poses[joint.parent] * joint.origin;
    if (joint.kind == JointKind::Fixed) continue;
    const double position = jointPosition(joint, values);
    if (joint.kind == JointKind::Prismatic)
      child.translate(position * joint.axis);
    else
      child.rotate(Eigen::AngleAxisd(position, joint.axis));
  }
  return poses;
}

Jacobian jacobian(const RobotModel& robot, const std::vector<Pose>& poses, std::uint32_t link, const Vec3& point) {
  Jacobian columns = Jacobian::Zero(6, static_cast<Eigen::Index>(robot.dofs.size()));
  for (std::uint32_t j = robot.links[link].parentJoint; j != kNone;
       j = robot.links[robot.joints[j].parent].parentJoint) {
    const Joint& joint = robot.joints[j];
    if (joint.dof == kNone || joint.kind == JointKind::Fixed) continue;
    // A joint's own motion does not move its axis, nor its origin if it is revolute.
    const Pose& frame = poses[joint.child];
    const Vec3 axis = joint.factor * (frame.linear() * joint.axis);
    if (joint.kind == JointKind::Prismatic) {
      columns.col(joint.dof).head<3>() += axis;
    } else {
      columns.col(joint.dof).head<3>() += axis.cross(point - frame.translation());
      columns.col(joint.dof).tail<3>() += axis;
    }
  }
  return columns;
}

}  // namespace handwheel
