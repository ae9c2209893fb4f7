// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "robot/RobotModel.h"

#include <span>

namespace handwheel {

// A joint of a serial arm, revolute or prismatic. It turns about, or slides along, the z axis of its frame.
struct ArmJoint {
  Pose before = Pose::Identity();  // of its frame at 0, in the frame of the joint before; of the first: in the base
  bool isPrismatic = false;
  double lower = -std::numeric_limits<double>::infinity();  // rad, mm
  double upper = std::numeric_limits<double>::infinity();
  std::optional<double> velocity = {};  // rad/s, mm/s; none: unknown

  bool isWithin(double value, double slack = 1e-9) const { return value >= lower - slack && value <= upper + slack; }
};

// One value per joint of an arm; rad, mm. Its memory is its own: computing with it allocates nothing.
inline constexpr int kMostArmJoints = 24;
using ArmValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostArmJoints, 1>;
using ArmJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMostArmJoints>;

// A kinematic chain of joints from a base to a tip, for fast computation. Immutable; any thread. Nothing but of()
// and withTool() allocates.
class SerialArm {
 public:
  // tip: in the frame of the last joint. At most kMostArmJoints joints.
  SerialArm(std::vector<ArmJoint> joints, const Pose& tip) : m_joints(std::move(joints)), m_tip(tip) {}

  // The joints between two links of a robot, the nearer one to the root first, and the degrees of freedom that they
  // are. Errors: ElementMalformed {robot, reason} where the tip does not hang on the base, a degree of freedom moves
  // more than one joint, or there are too many.
  struct InRobot;
  static Result<InRobot> of(const RobotModel& robot, std::uint32_t base, std::uint32_t tip);

  Eigen::Index size() const { return static_cast<Eigen::Index>(m_joints.size()); }
  std::span<const ArmJoint> joints() const { return m_joints; }
  const Pose& tip() const { return m_tip; }

  // The pose of the tip in the base (forward kinematics; He 2008, equations 6-2 and 6-3).
  Pose tipPose(const ArmValues& values) const;
  // The same, and the Jacobian of the tip in the frame of the base: rows 0–2 mm/rad or mm/mm, rows 3–5 rad/rad or 0
  // (equations 6-6 and 6-7).
  Pose tipPose(const ArmValues& values, ArmJacobian& jacobian) const;
  // The frames of all joints in the base; as many as there are joints.
  void jointPoses(const ArmValues& values, std::span<Pose> poses) const;

  // The same joints, with the tip at this pose in that of this arm.
  SerialArm withTool(const Pose& tool) const { return {m_joints, m_tip * tool}; }

  bool isWithinLimits(const ArmValues& values, double slack = 1e-9) const;
  // The middle of each joint's range; 0 where it is not bounded on both sides.
  ArmValues middle() const;
  // The length of the arm (mm): what its joints are apart, and the travel of its slides.
  double reach() const;

 private:
  std::vector<ArmJoint> m_joints;
  Pose m_tip;
};

struct SerialArm::InRobot {
  SerialArm arm;
  std::vector<std::uint32_t> dofs;  // of the robot, one per joint of the arm
};

// A row of a table after Denavit and Hartenberg, in its standard form: a turn by `theta` about z, a way `d` along z, a
// way `a` along the new x, a turn by `alpha` about it.
struct DhRow {
  double a = 0.0, alpha = 0.0, d = 0.0, theta = 0.0;  // mm, rad; theta, of a slide d, is added to the joint's value
  double sign = 1.0;                                  // of the joint's value: 1 or -1
  bool isPrismatic = false;
  double lower = -std::numeric_limits<double>::infinity();  // rad, mm; of the joint's value
  double upper = std::numeric_limits<double>::infinity();
  std::optional<double> velocity = {};  // rad/s, mm/s
};

// The arm of such a table. Its tip is the last frame.
SerialArm armOf(std::span<const DhRow> table);

}  // namespace handwheel
