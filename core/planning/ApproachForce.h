// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/DistanceForce.h"
#include "planning/RobotScene.h"

namespace handwheel {

// The repulsive force on a hand-guided robot near obstacles. Each link is pushed away from the obstacles near it
// (distanceForce()); the arm, taken as massless, transmits this to its tool and the guiding hand as a force and a
// torque. Near singular configurations the levers of the arm are bounded. Distance results are reused for the next
// configuration of the robot.
class ApproachForce {
 public:
  // The scene and the arm must outlive it; the arm has the joints of the scene. tool: centre point in the arm's tip.
  ApproachForce(const RobotScene& scene, const SerialArm& arm, const Pose& tool, const DistanceForceSettings& settings);

  // The force and torque at the tool's centre point.
  struct Felt {
    Vec3 force = Vec3::Zero();   // N, in the base; never larger than the limit in the settings
    Vec3 torque = Vec3::Zero();  // N·mm, about that point
    double distance =
        std::numeric_limits<double>::infinity();  // mm to the nearest obstacle; infinity: beyond the reach
    double energy = 0.0;                          // N·mm
  };
  Felt at(const ArmValues& values);

 private:
  const RobotScene& m_scene;
  const SerialArm& m_arm;
  Pose m_tool;
  DistanceForceSettings m_settings;
  std::vector<std::uint32_t> m_joints;  // joint of the scene that carries each of the first bodies
  ProximityQuery m_query;
  std::vector<NearPair> m_near;
};

}  // namespace handwheel
