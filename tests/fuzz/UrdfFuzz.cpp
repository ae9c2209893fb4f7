// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/Kinematics.h"
#include "robot/MeshLocation.h"
#include "robot/PointTarget.h"
#include "robot/UrdfReader.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is the file; its length
// chooses how the joints stand.

namespace {

using namespace handwheel;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "UrdfFuzz: %s\n", what);
  std::abort();
}

// The links form one tree, and the order goes through it from the root.
void judgeTree(const RobotModel& robot) {
  require(robot.root < robot.links.size(), "no root");
  require(robot.order.size() == robot.joints.size() && robot.joints.size() + 1 == robot.links.size(), "not a tree");
  std::vector<bool> reached(robot.links.size());
  reached[robot.root] = true;
  for (std::uint32_t j : robot.order) {
    const Joint& joint = robot.joints[j];
    require(reached[joint.parent] && !reached[joint.child], "out of order");
    require(robot.links[joint.child].parentJoint == j, "a link does not know its joint");
    reached[joint.child] = true;
  }
}

void judgeJoints(const RobotModel& robot) {
  for (const Joint& joint : robot.joints) {
    require(joint.origin.matrix().allFinite() && std::abs(joint.axis.norm() - 1.0) < 1e-6, "a joint is not finite");
    require(joint.limits.lower <= joint.limits.upper, "limits turned round");
    require(joint.limits.velocity.value_or(1.0) > 0.0 && joint.limits.effort.value_or(1.0) > 0.0, "not unknown");
    require(joint.dof == kNone || joint.dof < robot.dofs.size(), "a degree of freedom that is not there");
    require(std::isfinite(joint.factor) && std::isfinite(joint.offset), "a follower is not finite");
  }
}

void judgeShapes(const RobotModel& robot) {
  for (const Link& link : robot.links) {
    for (const auto* shapes : {&link.visuals, &link.collisions}) {
      for (const PlacedShape& placed : *shapes) {
        require(placed.shape < robot.shapes.size(), "a shape that is not there");
        require(placed.origin.matrix().allFinite(), "a place that is not finite");
      }
    }
  }
}

void move(const RobotModel& robot, double value) {
  const auto count = static_cast<Eigen::Index>(robot.dofs.size());
  const JointValues values = withinLimits(robot, JointValues::Constant(count, value));
  require(values.allFinite(), "a value is not finite");
  for (const Pose& pose : linkPoses(robot, values)) require(pose.matrix().allFinite(), "a pose is not finite");
  if (count > 50) return;
  require(pulled(robot, values, {toolLink(robot), Vec3::UnitX(), Vec3(100, 200, 300)}, 5).allFinite(), "pulled away");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto read = readUrdf({reinterpret_cast<const char*>(data), size});
  if (!read) return 0;
  judgeTree(read->robot);
  judgeJoints(read->robot);
  judgeShapes(read->robot);
  require(read->damage.size() <= 1000, "too much listed");
  constexpr double kValues[] = {0.0, 1.0, -1e3, 1e9};
  move(read->robot, kValues[size % std::size(kValues)]);
  for (const Shape& shape : read->robot.shapes) {
    if (const auto* mesh = std::get_if<MeshShape>(&shape)) (void)locateMesh(mesh->file, "/nowhere");
  }
  return 0;
}
