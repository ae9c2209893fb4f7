// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/DistanceForce.h"
#include "planning/RobotScene.h"

namespace handwheel {

// The repulsive force on a hand-guided robot near obstacles. Each link is pushed away from the obstacles near
// to it (distanceForce()), and the arm, which weighs nothing, hands this on to its tool and the hand that leads it, as
// a force and a torque. Near singular places the arm's levers are bounded. It keeps what it found for the next place of
// the robot.
class ApproachForce {
 public:
  // scene and arm must outlive it; the arm has the joints of the scene. tool: of the centre point in the arm's tip.
  ApproachForce(const RobotScene& scene, const SerialArm& arm, const Pose& tool, const DistanceForceSettings& settings);

  // What is felt at the tool's centre point while the joints are at these values.
  struct Felt {
    Vec3 force = Vec3::Zero();   // N, in the base; never larger than that of the settings
    Vec3 torque = Vec3::Zero();  // N·mm, about that point
    double distance = std::numeric_limits<double>::infinity();  // mm to what is nearest; infinity: beyond the reach
    double energy = 0.0;                                        // N·mm
  };
  Felt at(const ArmValues& values);

 private:
  const RobotScene& m_scene;
  const SerialArm& m_arm;
  Pose m_tool;
  DistanceForceSettings m_settings;
  std::vector<std::uint32_t> m_joints;  // of the scene, which carries each of the first bodies
  ProximityQuery m_query;
  std::vector<NearPair> m_near;
};

}  // namespace handwheel
