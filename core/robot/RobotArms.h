// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/RobotModel.h"

#include <span>
#include <string>
#include <vector>

namespace handwheel {

// Several robots in one model. Each is the links below a base of its own, and all hang on the root of the model, so
// that whatever reads, writes, moves and shows one model does so with several robots.

// A robot in a model.
struct RobotArm {
  std::string name;              // unique among those of the model, not empty
  std::string title;             // what its description calls it
  std::uint32_t base = kNone;    // link; the root of the model, or fixed to that by one joint
  std::uint32_t flange = kNone;  // the link that carries its tool

  bool operator==(const RobotArm&) const = default;
};

// The robot of a model that has one: all of it, up to its toolLink(). Its name is that in the library ("irb120"), or
// made of that of the model as in freeArmName().
RobotArm wholeArm(const RobotModel& robot);

// Of each link: the number of the robot that it belongs to; kNone: to none, as the bare root that remains where the
// first robot was removed.
std::vector<std::uint32_t> armsOfLinks(const RobotModel& robot, std::span<const RobotArm> arms);
// The same of each degree of freedom.
std::vector<std::uint32_t> armsOfDofs(const RobotModel& robot, std::span<const RobotArm> arms);

// Where a robot stands in the frame of the root.
Pose basePose(const RobotModel& robot, const RobotArm& arm);

// Whether no shape of a robot is a mesh, as those that robotOf() draws: plain ones stand in for the robot's own.
bool hasPlainShapes(const RobotModel& robot, std::span<const RobotArm> arms, std::size_t arm);

// A robot with the shapes that it collides with where its description has none but those that it shows, and the other
// way round: beside another robot they are no longer all that there are.
RobotModel withBothShapes(RobotModel robot);

// Both robots in one model; the other one stands at this pose in the frame of the root. Its links and joints are called
// "NAME_" and what they were; NAME must be one of those that freeArmName() gives, for that makes them unique. Files of
// its meshes get the mark "#NAME": those of two descriptions may have one name.
RobotModel joined(const RobotModel& robot, const RobotModel& other, const std::string& name, const Pose& base);

// The model without one of its robots, with all others where they are. Of the one on the root its bare link remains.
RobotModel withoutArm(const RobotModel& robot, std::span<const RobotArm> arms, std::size_t arm);

// The model with a robot moved to another pose. It must not be the one on the root.
RobotModel withBaseAt(RobotModel robot, const RobotArm& arm, const Pose& base);

// A name for another robot: the preferred one, or that with "_2", "_3", …, so that neither a robot has it nor a link or
// joint begins with it and "_". What is no letter, digit or "-" becomes "_".
std::string freeArmName(const RobotModel& robot, std::span<const RobotArm> arms, std::string_view preferred);

}  // namespace handwheel
