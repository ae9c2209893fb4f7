// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/DistanceForce.h"
#include "planning/RobotScene.h"

namespace handwheel {

// The repulsive force on a hand-guided robot near obstacles. Each link is pushed away from the obstacles near it
// (distanceForce()). The arm is treated as massless and transmits these forces to its tool and the guiding hand as one
// force and torque. The computation is damped, so that the force stays finite at singular configurations. Results of
// distance queries are reused for the next configuration of the robot.
class ApproachForce {
 public:
  // Prepares the computation. The scene and the arm must outlive this object; the arm must have the joints of the
  // scene. tool: the tool's centre point in the frame of the arm's tip.
  ApproachForce(const RobotScene& scene, const SerialArm& arm, const Pose& tool, const DistanceForceSettings& settings);

  // The force and torque at the tool's centre point.
  struct Felt {
    Vec3 force = Vec3::Zero();   // N, in the frame of the base; never larger than the limit in the settings
    Vec3 torque = Vec3::Zero();  // N·mm, about the tool's centre point
    // Distance to the nearest obstacle, mm; infinity: no obstacle is within the reach.
    double distance = std::numeric_limits<double>::infinity();
    double energy = 0.0;  // N·mm
  };
  Felt at(const ArmValues& values);

 private:
  const RobotScene& m_scene;
  const SerialArm& m_arm;
  Pose m_tool;
  DistanceForceSettings m_settings;
  std::vector<std::uint32_t> m_joints;  // joint of the scene that carries each moving body of the query
  ProximityQuery m_query;
  std::vector<NearPair> m_near;
};

}  // namespace handwheel
