// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/RobotModel.h"

#include <span>
#include <string>
#include <vector>

namespace handwheel {

// Several robots in one model. Each consists of the links below a base of its own, and all are attached to the root of
// the model. So everything that reads, writes, moves and shows a model handles several robots.

// A robot in a model.
struct RobotArm {
  std::string name;              // unique among those of the model, not empty
  std::string title;             // the name in its description
  std::uint32_t base = kNone;    // link; the root of the model, or fixed to that by one joint
  std::uint32_t flange = kNone;  // the link that carries its tool

  bool operator==(const RobotArm&) const = default;
};

// Returns the robot of a model that has one: all of it, up to its toolLink(). Its name is that in the library
// ("irb120"), or derived from that of the model as in freeArmName().
RobotArm wholeArm(const RobotModel& robot);

// Returns the index of the robot that each link belongs to; kNone: to none, as the bare root that remains after the
// first robot was removed.
std::vector<std::uint32_t> armsOfLinks(const RobotModel& robot, std::span<const RobotArm> arms);
// Returns the same for each degree of freedom.
std::vector<std::uint32_t> armsOfDofs(const RobotModel& robot, std::span<const RobotArm> arms);

// Returns the pose of a robot's base in the frame of the root.
Pose basePose(const RobotModel& robot, const RobotArm& arm);

// Returns true if no shape of a robot is a mesh, as in the result of robotOf(): simple shapes approximate the robot.
bool hasPlainShapes(const RobotModel& robot, std::span<const RobotArm> arms, std::size_t arm);

// Copies the visual shapes of a robot to its collision shapes if it has none, and vice versa. Beside another robot they
// are no longer the only shapes in the model.
RobotModel withBothShapes(RobotModel robot);

// Joins two robots in one model; the second one stands at this pose in the frame of the root. Its links and joints get
// the prefix "NAME_"; NAME must come from freeArmName(), which makes them unique. Files of its meshes get the suffix
// "#NAME": those of two descriptions may have the same name.
RobotModel joined(const RobotModel& robot, const RobotModel& other, const std::string& name, const Pose& base);

// Removes a robot from a model; all others stay. The bare link of a robot on the root remains.
RobotModel withoutArm(const RobotModel& robot, std::span<const RobotArm> arms, std::size_t arm);

// Moves a robot to another pose. It must not be the one on the root.
RobotModel withBaseAt(RobotModel robot, const RobotArm& arm, const Pose& base);

// Returns a name for another robot: the preferred one, or that with "_2", "_3", …, so that no robot has it and no link
// or joint begins with it and "_". Characters other than letters, digits and "-" become "_".
std::string freeArmName(const RobotModel& robot, std::span<const RobotArm> arms, std::string_view preferred);

}  // namespace handwheel
