// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/RobotModel.h"

#include <span>
#include <string>
#include <vector>

namespace handwheel {

// Functions for several robots in one model. Each robot consists of the links below its own base, and all bases are
// attached to the root of the model. Code that reads, writes, moves or shows a model therefore handles several robots.

// A robot in a model.
struct RobotArm {
  std::string name;              // unique among the robots of the model, not empty
  std::string title;             // the name in its description
  std::uint32_t base = kNone;    // link; the root of the model, or fixed to the root by one joint
  std::uint32_t flange = kNone;  // the link that carries its tool

  bool operator==(const RobotArm&) const = default;
};

// Returns the robot of a model with only one robot: all links, with toolLink() as the flange. The name of the robot is
// that in the library ("irb120"), or derived from the name of the model with the replacements of freeArmName().
RobotArm wholeArm(const RobotModel& robot);

// Returns the index of the robot to which each link belongs; kNone: no robot, as for the bare root that remains after
// the first robot was removed.
std::vector<std::uint32_t> armsOfLinks(const RobotModel& robot, std::span<const RobotArm> arms);
// Returns the index of the robot to which each degree of freedom belongs.
std::vector<std::uint32_t> armsOfDofs(const RobotModel& robot, std::span<const RobotArm> arms);

// Returns the pose of a robot's base in the frame of the root.
Pose basePose(const RobotModel& robot, const RobotArm& arm);

// Returns true if the shapes of a robot are those that tables give (robotOf()), which approximate it: no shape is a
// mesh. Other robots consist of the shapes that their authors described.
bool hasPlainShapes(const RobotModel& robot, std::span<const RobotArm> arms, std::size_t arm);

// Copies the visual shapes of a robot to its collision shapes if it has no collision shapes, and vice versa. Must be
// called before a robot with only one type of shapes is joined with another robot.
RobotModel withBothShapes(RobotModel robot);

// Joins two robots in one model. The links and joints of the second robot get the prefix "name_"; they are unique if
// the name comes from freeArmName(). The files of its meshes get the suffix "#name", because two descriptions may use
// the same file names. base: the pose of the second robot in the frame of the root.
RobotModel joined(const RobotModel& robot, const RobotModel& other, const std::string& name, const Pose& base);

// Removes a robot from a model; all other robots stay. If the base of the robot is the root, the root remains as a bare
// link.
RobotModel withoutArm(const RobotModel& robot, std::span<const RobotArm> arms, std::size_t arm);

// Moves a robot to another pose in the frame of the root. Its base must not be the root.
RobotModel withBaseAt(RobotModel robot, const RobotArm& arm, const Pose& base);

// Returns a name for another robot: the preferred name, if necessary with "_2", "_3", … appended. No robot has this
// name, and no link or joint has a name that begins with it and "_". ASCII characters other than letters, digits and
// "-" become "_".
std::string freeArmName(const RobotModel& robot, std::span<const RobotArm> arms, std::string_view preferred);

}  // namespace handwheel
