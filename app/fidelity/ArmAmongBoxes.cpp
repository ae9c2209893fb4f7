// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fidelity/ArmAmongBoxes.h"

#include "planning/problems/PlanningSet.h"
#include "robot/dh/DhTable.h"

#include <algorithm>
#include <numeric>

namespace handwheel {

ArmAmongBoxes::ArmAmongBoxes(double thickness, std::uint64_t seed) : m_scene(made()) {
  constexpr std::uint32_t kBoxes = 12;
  constexpr double kNearest = 330.0, kFarthest = 620.0, kHighest = 700.0;  // mm from the base, where the arm reaches
  Random random(seed);
  for (std::uint32_t i = 0; i < kBoxes; ++i) {
    const double angle = random.between(-M_PI, M_PI), away = random.between(kNearest, kFarthest);
    Pose pose(Eigen::Translation3d(away * std::cos(angle), away * std::sin(angle), random.between(0.0, kHighest)));
    pose.rotate(Eigen::AngleAxisd(random.between(-M_PI, M_PI), random.direction()));
    m_scene.addObstacle(CollisionBody({CollisionPiece::box(Pose::Identity(), {250.0, 250.0, thickness})}), pose, i);
  }
}

RobotScene ArmAmongBoxes::made() {
  const DhTable& table = *libraryTable("irb120");
  const RobotModel robot = robotOf(table);
  std::vector<std::uint32_t> dofs(robot.dofs.size());
  std::iota(dofs.begin(), dofs.end(), 0u);
  std::set<LinkPair> allowed = neighbours(robot);
  allowed.merge(overlappingLinks(table));
  RobotScene scene(robot, Pose::Identity(), collisionBodies(robot), dofs, restValues(robot), allowed);
  scene.allowPairs(scene.alwaysMeeting());
  return scene;
}

ArmValues ArmAmongBoxes::anywhere(Random& random) const {
  ArmValues values(m_scene.size());
  for (Eigen::Index i = 0; i < values.size(); ++i)
    values[i] = random.between(std::max(-M_PI, m_scene.joint(i).lower), std::min(M_PI, m_scene.joint(i).upper));
  return values;
}

ArmValues ArmAmongBoxes::anywhereFree(Random& random) const {
  while (true) {
    const ArmValues values = anywhere(random);
    if (m_scene.isFree(values, 0.1, 0.1)) return values;
  }
}

ArmValues ArmAmongBoxes::near(const ArmValues& middle, Random& random) const {
  ArmValues values = middle;
  for (Eigen::Index i = 0; i < values.size(); ++i)
    values[i] = std::clamp(middle[i] + random.between(-1.0, 1.0), m_scene.joint(i).lower, m_scene.joint(i).upper);
  return values;
}

}  // namespace handwheel
