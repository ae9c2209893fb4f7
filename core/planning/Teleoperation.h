// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/ContactEscape.h"
#include "planning/MotionCheck.h"
#include "robot/arm/SerialArm.h"

namespace handwheel {

// How a robot follows a hand.
struct TeleoperationSettings {
  MotionCheckSettings check;
  double tolerance = 1e-5;    // that the joints reach what is wanted to within, metres and rad: setting ik.tolerance
  double turning = M_PI;      // rad/s of revolute joints whose velocity is not known
  double sliding = 500.0;     // mm/s of slides
  double stiffness = 0.2;     // N/mm: how hard the hand is pulled to where the tool is
  double largestForce = 5.0;  // N
};

// A robot under teleoperation, whose tool follows the hand without collisions. Its tool's centre point goes as fast as
// the joints let it, never beyond a limit and never through anything: each step is proven free (MotionCheck). Where the
// straight step is blocked, joints move on alone as far as they can, so that the tool slides along. Near singular
// places the step is damped and does not stop. With fewer than six joints the tool is where the hand is, turned as near
// to it as that lets it be. The hand is pulled to where the tool is.
class Teleoperation {
 public:
  // Where the robot is after a step.
  struct Step {
    Pose tool = Pose::Identity();
    Vec3 force = Vec3::Zero();  // N, on the hand
    double behind = 0.0;        // mm that the tool is off what the hand wants
    bool isBlocked = false;     // by what stands around it or its own links
    bool isAtLimit = false;     // a joint is
  };

  // The scene must outlive it. From a start beyond a limit the robot can only be led back, and where it meets something
  // only so that it gets no deeper. tool: of the centre point in the arm's tip.
  Teleoperation(const RobotScene& scene, const SerialArm& arm, const Pose& tool, const ArmValues& start,
                const TeleoperationSettings& settings);

  const ArmValues& values() const { return m_values; }
  Pose tool() const { return m_arm.tipPose(m_values); }

  // Follows to a pose of the tool's centre point in the base. seconds: since the step before.
  Step follow(const Pose& wanted, double seconds);
  // Follows along the straight way from what was wanted before, in steps that are small for the arm, and until it comes
  // no nearer: for a hand that rests while the robot still moves.
  Step lead(const Pose& wanted);
  // The same where the hand wants joint values.
  Step lead(const ArmValues& wanted);

 private:
  ArmValues towards(const Pose& wanted, double seconds) const;
  ArmValues withinLimits(ArmValues to) const;
  std::optional<bool> advanceProven(const ArmValues& to, const MotionCheckSettings& check, double least);
  bool advance(const ArmValues& to);
  bool slide(const ArmValues& to, const Pose& wanted);
  Step stepTo(const Pose& wanted) const;

  const RobotScene& m_scene;
  const SerialArm m_arm;  // to the tool's centre point
  TeleoperationSettings m_settings;
  ArmValues m_values;
  Pose m_wanted;                          // by lead(), last
  std::optional<ContactEscape> m_escape;  // made when it is needed
};

}  // namespace handwheel
