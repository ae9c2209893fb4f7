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
  double tolerance = 1e-5;    // tolerance of the joints, metres and rad: the setting ik.tolerance
  double turning = M_PI;      // rad/s of revolute joints whose velocity is unknown
  double sliding = 500.0;     // mm/s of slides
  double stiffness = 0.2;     // N/mm: stiffness of the pull of the hand towards the tool
  double largestForce = 5.0;  // N
};

// A robot under teleoperation, whose tool follows the hand without collisions. Its tool's centre point moves as fast as
// the joints allow, never beyond a limit and never through anything: each step is proven free (MotionCheck). If the
// straight step is blocked, joints move on alone as far as they can, so that the tool slides along. Near singular
// configurations the step is damped and does not stop. With fewer than six joints the tool takes the position of the
// hand, and an orientation as near to it as possible. The hand is pulled towards the tool.
class Teleoperation {
 public:
  // The state of the robot after a step.
  struct Step {
    Pose tool = Pose::Identity();
    Vec3 force = Vec3::Zero();  // N, on the hand
    double behind = 0.0;        // mm: distance of the tool from the wanted position
    bool isBlocked = false;     // by its surroundings or its own links
    bool isAtLimit = false;     // a joint is at its limit
  };

  // The scene must outlive it. From a start beyond a limit the robot can only be led back, and from a collision only so
  // that it gets no deeper. tool: centre point in the arm's tip.
  Teleoperation(const RobotScene& scene, const SerialArm& arm, const Pose& tool, const ArmValues& start,
                const TeleoperationSettings& settings);

  const ArmValues& values() const { return m_values; }
  Pose tool() const { return m_arm.tipPose(m_values); }

  // Follows to a pose of the tool's centre point in the base. seconds: time since the last step.
  Step follow(const Pose& wanted, double seconds);
  // Follows along the straight line from the last wanted pose, in steps that are small for the arm, until it comes no
  // nearer: for a hand that rests while the robot still moves.
  Step lead(const Pose& wanted);
  // Follows to joint values in the same manner.
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
  Pose m_wanted;                          // the last one of lead()
  std::optional<ContactEscape> m_escape;  // created on demand
};

}  // namespace handwheel
