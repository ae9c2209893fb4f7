// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/problems/PlanningSet.h"
#include "robot/dh/DhTable.h"

#include <rapidcheck.h>

#include <numeric>

// Robots among obstacles, for tests of planning.
namespace handwheel::test {

inline double evenly(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

// Returns an arm in the plane z = 0 with links of these lengths (mm), each a row of balls of this radius, and joints
// that turn from -3 to 3 rad.
inline RobotModel planarArm(const std::vector<double>& lengths, double radius) {
  DhTable table;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    DhJoint joint;
    joint.name = "joint_" + std::to_string(i + 1);
    joint.a = lengths[i];
    joint.lower = -3.0;
    joint.upper = 3.0;
    table.joints.push_back(joint);
  }
  RobotModel robot = robotOf(table);
  robot.shapes.clear();
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    Link& link = robot.links[l];
    link.visuals.clear();
    link.collisions.clear();
    if (l == 0 || l > lengths.size()) continue;
    for (double x = 2.0 * radius; x <= lengths[l - 1]; x += radius) {
      link.collisions.push_back(
          {static_cast<std::uint32_t>(robot.shapes.size()), Pose(Eigen::Translation3d(x, 0.0, 0.0)), {}});
      robot.shapes.emplace_back(SphereShape{radius});
    }
  }
  return robot;
}

inline RobotScene sceneOf(const RobotModel& robot) {
  std::vector<std::uint32_t> dofs(robot.dofs.size());
  std::iota(dofs.begin(), dofs.end(), 0u);
  return RobotScene(robot, Pose::Identity(), collisionBodies(robot), dofs, restValues(robot), neighbours(robot));
}

inline void addBall(RobotScene& scene, const Vec3& at, double radius, std::uint32_t owner) {
  scene.addObstacle(CollisionBody({CollisionPiece::sphere(at, radius)}), Pose::Identity(), owner);
}

// Returns the least distance from obstacles at densely spaced points of a motion.
inline double leastAlong(const RobotScene& scene, const ArmValues& from, const ArmValues& to, double step) {
  const int count = std::max(1, static_cast<int>(std::ceil((to - from).cwiseAbs().maxCoeff() / step)));
  double least = 1e9;
  for (int i = 0; i <= count; ++i)
    least = std::min(least, scene.nearest(from + (to - from) * (static_cast<double>(i) / count), 1e9).distance);
  return least;
}

inline double leastAlong(const RobotScene& scene, const JointPath& path, double step) {
  double least = 1e9;
  for (std::size_t i = 1; i < path.size(); ++i) least = std::min(least, leastAlong(scene, path[i - 1], path[i], step));
  return least;
}

}  // namespace handwheel::test
