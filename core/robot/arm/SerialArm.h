// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "robot/RobotModel.h"

#include <span>

namespace handwheel {

// A joint of a serial arm, revolute or prismatic. It turns about, or slides along, the z axis of its frame.
struct ArmJoint {
  // The pose of the joint's frame at 0, in the frame of the preceding joint; for the first joint in the base.
  Pose before = Pose::Identity();
  bool isPrismatic = false;
  double lower = -std::numeric_limits<double>::infinity();  // rad, mm
  double upper = std::numeric_limits<double>::infinity();
  std::optional<double> velocity = {};  // rad/s, mm/s; none: unknown

  bool isWithin(double value, double slack = 1e-9) const { return value >= lower - slack && value <= upper + slack; }
};

// One value per joint of an arm; rad, mm. The values are stored inline, so that computations allocate nothing.
inline constexpr int kMostArmJoints = 24;
using ArmValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostArmJoints, 1>;
using ArmJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMostArmJoints>;

// The third axis as a controller has it that couples the second and third joint: joint 3 + factor · joint 2. Its limits
// hold together with those of the joints.
struct AxisCoupling {
  double factor = 0.0;                                      // 1 for the parallel linkages of ABB, -1 for Fanuc
  double lower = -std::numeric_limits<double>::infinity();  // rad
  double upper = std::numeric_limits<double>::infinity();

  double third(const ArmValues& values) const { return values[2] + factor * values[1]; }
  bool isWithin(const ArmValues& values, double slack = 1e-9) const {
    return third(values) >= lower - slack && third(values) <= upper + slack;
  }
  bool operator==(const AxisCoupling&) const = default;
};

// A kinematic chain of joints from a base to a tip, for fast computation. An arm is immutable and may be used on any
// thread. Only of() and withTool() allocate.
class SerialArm {
 public:
  // tip: pose of the tip in the frame of the last joint. There may be at most kMostArmJoints joints.
  SerialArm(std::vector<ArmJoint> joints, const Pose& tip) : m_joints(std::move(joints)), m_tip(tip) {}

  struct InRobot;
  // Returns the arm of the joints between two links of a robot, with their degrees of freedom. base: the link nearer to
  // the root. Errors: ElementMalformed {robot, reason} if the tip does not depend on the base, a degree of freedom
  // moves more than one joint, or there are more than kMostArmJoints joints.
  static Result<InRobot> of(const RobotModel& robot, std::uint32_t base, std::uint32_t tip);

  Eigen::Index size() const { return static_cast<Eigen::Index>(m_joints.size()); }
  std::span<const ArmJoint> joints() const { return m_joints; }
  const Pose& tip() const { return m_tip; }

  // Returns the pose of the tip in the frame of the base (forward kinematics; He 2008, equations 6-2 and 6-3).
  Pose tipPose(const ArmValues& values) const;
  // Returns the pose of the tip, and computes its Jacobian in the frame of the base: rows 0–2 are in mm/rad or mm/mm,
  // rows 3–5 in rad/rad or 0 (He 2008, equations 6-6 and 6-7).
  Pose tipPose(const ArmValues& values, ArmJacobian& jacobian) const;
  // Computes the frames of all joints in the frame of the base. poses: one element per joint.
  void jointPoses(const ArmValues& values, std::span<Pose> poses) const;

  // Returns an arm with the same joints and another tip. tool: the new tip in the frame of the present one.
  SerialArm withTool(const Pose& tool) const { return SerialArm(m_joints, m_tip * tool).withCoupling(m_coupling); }
  // Returns the same arm with another coupling. An arm with a coupling has at least three joints.
  SerialArm withCoupling(const std::optional<AxisCoupling>& coupling) const {
    SerialArm arm = *this;
    arm.m_coupling = coupling;
    return arm;
  }
  const std::optional<AxisCoupling>& coupling() const { return m_coupling; }  // none: every joint is counted by itself

  bool isWithinLimits(const ArmValues& values, double slack = 1e-9) const;
  // Returns the middle of the range of each joint; 0 for a joint that is not bounded on both sides.
  ArmValues middle() const;
  // Returns the length of the arm (mm): the sum of the distances between its joints and of the travel of its slides.
  double reach() const;

 private:
  std::vector<ArmJoint> m_joints;
  Pose m_tip;
  std::optional<AxisCoupling> m_coupling = {};
};

struct SerialArm::InRobot {
  SerialArm arm;
  std::vector<std::uint32_t> dofs;  // degrees of freedom of the robot, one per joint of the arm
};

// A row of a Denavit-Hartenberg table in its standard form: a rotation by `theta` about z, a translation `d` along z, a
// translation `a` along the new x axis, and a rotation by `alpha` about that axis.
struct DhRow {
  double a = 0.0, alpha = 0.0, d = 0.0, theta = 0.0;  // mm, rad; theta, or d of a slide, is added to the joint's value
  double sign = 1.0;                                  // sign of the joint's value: 1 or -1
  bool isPrismatic = false;
  double lower = -std::numeric_limits<double>::infinity();  // rad, mm; limits of the joint's value
  double upper = std::numeric_limits<double>::infinity();
  std::optional<double> velocity = {};  // rad/s, mm/s
};

// Returns the arm of a Denavit-Hartenberg table. Its tip is the last frame.
SerialArm armOf(std::span<const DhRow> table);

}  // namespace handwheel
