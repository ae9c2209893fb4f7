// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/ContactEscape.h"
#include "planning/MotionCheck.h"
#include "robot/arm/SerialArm.h"

namespace handwheel {

// Settings of a robot that follows a hand.
struct TeleoperationSettings {
  MotionCheckSettings check;
  double tolerance = 1e-5;    // tolerance of the joints, m and rad (setting ik.tolerance)
  double turning = M_PI;      // rad/s: velocity of revolute joints without a known limit
  double sliding = 500.0;     // mm/s: velocity of slides without a known limit
  double stiffness = 0.2;     // N/mm: stiffness of the force that pulls the hand towards the tool
  double largestForce = 5.0;  // N: limit of the force that pulls the hand
};

// A robot under teleoperation, whose tool follows the hand without collisions. The tool's centre point moves as fast as
// the joints allow. No joint exceeds its limits, and each step is proven free of collisions (MotionCheck). If the
// straight step is blocked, single joints move on as far as they can, so that the tool slides along obstacles. Near
// singular configurations the motion is damped but does not stop. With fewer than six joints the tool takes the
// position of the hand, and an orientation as near to that of the hand as possible. The hand is pulled towards the
// tool.
class Teleoperation {
 public:
  // The state of the robot after a step.
  struct Step {
    Pose tool = Pose::Identity();
    Vec3 force = Vec3::Zero();  // N, on the hand
    double behind = 0.0;        // mm: distance of the tool from the wanted position
    bool isBlocked = false;     // the robot is blocked by its surroundings or by its own links
    bool isAtLimit = false;     // a joint is at its limit
  };

  // Begins at a configuration of the robot. The scene must outlive this object. If a joint begins beyond its limits, it
  // can only be led back. If the robot begins in collision, it can only move so that no contact gets deeper. tool: the
  // tool's centre point in the frame of the arm's tip.
  Teleoperation(const RobotScene& scene, const SerialArm& arm, const Pose& tool, const ArmValues& start,
                const TeleoperationSettings& settings);

  const ArmValues& values() const { return m_values; }
  Pose tool() const { return m_arm.tipPose(m_values); }

  // Moves towards a pose of the tool's centre point in the frame of the base. seconds: the time since the last step.
  Step follow(const Pose& wanted, double seconds);
  // Moves along the straight line from the last wanted pose in small steps, until the tool comes no nearer. Unlike
  // follow(), it does not depend on time.
  Step lead(const Pose& wanted);
  // Moves straight towards joint values in small steps, until the robot arrives or is blocked.
  Step lead(const ArmValues& wanted);

 private:
  ArmValues towards(const Pose& wanted, double seconds) const;
  ArmValues withinLimits(ArmValues to) const;
  std::optional<bool> advanceProven(const ArmValues& to, const MotionCheckSettings& check, double least);
  bool advance(const ArmValues& to);
  bool slide(const ArmValues& to, const Pose& wanted);
  Step stepTo(const Pose& wanted) const;

  const RobotScene& m_scene;
  const SerialArm m_arm;  // its tip is the tool's centre point
  TeleoperationSettings m_settings;
  ArmValues m_values;
  Pose m_wanted;                          // the last wanted pose of lead()
  std::optional<ContactEscape> m_escape;  // created on demand
};

}  // namespace handwheel
