// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/arm/SerialArm.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace handwheel {

namespace {

// Applies a joint's motion along or about its z axis to a frame.
void move(Pose& frame, const ArmJoint& joint, double value) {
  if (joint.isPrismatic) {
    frame.translation() += value * frame.linear().col(2);
    return;
  }
  const double c = std::cos(value), s = std::sin(value);
  const Vec3 x = frame.linear().col(0), y = frame.linear().col(1);
  frame.linear().col(0) = c * x + s * y;
  frame.linear().col(1) = c * y - s * x;
}

// Returns a rotation that takes z to the axis.
Eigen::Matrix3d aligned(const Vec3& axis) {
  return Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), axis).toRotationMatrix();
}

Error noArm(std::string reason) {
  return {ErrorCode::ElementMalformed, {"robot", std::move(reason)}, {}, {}};
}

}  // namespace

Pose SerialArm::tipPose(const ArmValues& values) const {
  assert(values.size() == size());
  Pose frame = Pose::Identity();
  for (Eigen::Index i = 0; i < size(); ++i) {
    const ArmJoint& joint = m_joints[static_cast<std::size_t>(i)];
    frame = frame * joint.before;
    move(frame, joint, values[i]);
  }
  return frame * m_tip;
}

Pose SerialArm::tipPose(const ArmValues& values, ArmJacobian& jacobian) const {
  assert(values.size() == size());
  jacobian.resize(6, size());
  std::array<Vec3, kMostArmJoints> origins;
  Pose frame = Pose::Identity();
  for (Eigen::Index i = 0; i < size(); ++i) {
    const ArmJoint& joint = m_joints[static_cast<std::size_t>(i)];
    frame = frame * joint.before;
    origins[static_cast<std::size_t>(i)] = frame.translation();
    jacobian.col(i).tail<3>() = frame.linear().col(2);
    move(frame, joint, values[i]);
  }
  const Pose tip = frame * m_tip;
  for (Eigen::Index i = 0; i < size(); ++i) {
    const Vec3 axis = jacobian.col(i).tail<3>();
    if (m_joints[static_cast<std::size_t>(i)].isPrismatic) {
      jacobian.col(i).head<3>() = axis;
      jacobian.col(i).tail<3>().setZero();
    } else {
      jacobian.col(i).head<3>() = axis.cross(tip.translation() - origins[static_cast<std::size_t>(i)]);
    }
  }
  return tip;
}

void SerialArm::jointPoses(const ArmValues& values, std::span<Pose> poses) const {
  assert(values.size() == size() && poses.size() == m_joints.size());
  Pose frame = Pose::Identity();
  for (std::size_t i = 0; i < m_joints.size(); ++i) {
    frame = frame * m_joints[i].before;
    move(frame, m_joints[i], values[static_cast<Eigen::Index>(i)]);
    poses[i] = frame;
  }
}

bool SerialArm::isWithinLimits(const ArmValues& values, double slack) const {
  for (Eigen::Index i = 0; i < size(); ++i) {
    if (!m_joints[static_cast<std::size_t>(i)].isWithin(values[i], slack)) return false;
  }
  return !m_coupling || m_coupling->isWithin(values, slack);
}

ArmValues SerialArm::middle() const {
  ArmValues values = ArmValues::Zero(size());
  for (Eigen::Index i = 0; i < size(); ++i) {
    const ArmJoint& joint = m_joints[static_cast<std::size_t>(i)];
    if (std::isfinite(joint.lower) && std::isfinite(joint.upper)) values[i] = 0.5 * (joint.lower + joint.upper);
  }
  return values;
}

double SerialArm::reach() const {
  double reach = m_tip.translation().norm();
  for (const ArmJoint& joint : m_joints) {
    reach += joint.before.translation().norm();
    if (joint.isPrismatic && std::isfinite(joint.upper - joint.lower)) reach += joint.upper - joint.lower;
  }
  return reach;
}

Result<SerialArm::InRobot> SerialArm::of(const RobotModel& robot, std::uint32_t base, std::uint32_t tip) {
  std::vector<std::uint32_t> chain;  // joints, from the tip on
  for (std::uint32_t link = tip; link != base;) {
    const std::uint32_t joint = robot.links[link].parentJoint;
    if (joint == kNone) return noArm("the tip is not connected to the base");
    chain.push_back(joint);
    link = robot.joints[joint].parent;
  }
  std::reverse(chain.begin(), chain.end());
  std::vector<ArmJoint> joints;
  std::vector<std::uint32_t> dofs;
  Pose before = Pose::Identity();  // since the last joint that moves
  for (const std::uint32_t j : chain) {
    const Joint& joint = robot.joints[j];
    before = before * joint.origin;
    if (joint.kind == JointKind::Fixed) continue;
    const bool isPrismatic = joint.kind == JointKind::Prismatic;
    const Eigen::Matrix3d turn = aligned(joint.dof == kNone || joint.factor >= 0.0 ? joint.axis : Vec3(-joint.axis));
    ArmJoint made;
    made.isPrismatic = isPrismatic;
    Pose offset = Pose::Identity();  // displacement by the joint with its degree of freedom at 0
    if (isPrismatic)
      offset.translate(joint.offset * joint.axis);
    else
      offset.rotate(Eigen::AngleAxisd(joint.offset, joint.axis));
    if (joint.dof == kNone) {
      before = before * offset;
      continue;
    }
    if (std::abs(joint.factor) != 1.0) return noArm("a joint is geared");
    if (std::find(dofs.begin(), dofs.end(), joint.dof) != dofs.end())
      return noArm("a degree of freedom moves several joints");
    if (joints.size() == kMostArmJoints) return noArm("it has too many joints");
    const Joint& named = robot.jointOfDof(joint.dof);
    if (named.kind != JointKind::Continuous) {
      made.lower = named.limits.lower;
      made.upper = named.limits.upper;
    }
    made.velocity = named.limits.velocity;
    made.before = before * offset;
    made.before.rotate(turn);
    joints.push_back(made);
    dofs.push_back(joint.dof);
    before = Pose(turn.transpose());
  }
  return InRobot{SerialArm(std::move(joints), before), std::move(dofs)};
}

SerialArm armOf(std::span<const DhRow> table) {
  assert(table.size() <= kMostArmJoints);
  std::vector<ArmJoint> joints;
  Pose before = Pose::Identity();
  for (const DhRow& row : table) {
    ArmJoint joint;
    joint.isPrismatic = row.isPrismatic;
    joint.lower = row.lower;
    joint.upper = row.upper;
    joint.velocity = row.velocity;
    // A joint with a negative sign has its z axis down; the rotation is undone after it.
    const Pose flip = row.sign < 0.0 ? Pose(Eigen::AngleAxisd(M_PI, Vec3::UnitX())) : Pose::Identity();
    joint.before = before * flip;
    joints.push_back(joint);
    before = flip * Eigen::AngleAxisd(row.theta, Vec3::UnitZ()) * Eigen::Translation3d(row.a, 0.0, row.d) *
             Eigen::AngleAxisd(row.alpha, Vec3::UnitX());
  }
  return SerialArm(std::move(joints), before);
}

}  // namespace handwheel
