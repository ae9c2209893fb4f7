// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/SerialArm.h"

#include <optional>
#include <string>
#include <vector>

namespace handwheel {

// A motion of a program, from the previous end to these joint values.
struct ProgramMotion {
  enum class Kind {
    Joint,   // all joints together, straight in joint space
    Linear,  // the tool's centre point along a straight line, its rotation by the shortest turn
  };
  Kind kind = Kind::Joint;
  ArmValues joints;     // rad, mm; within the limits
  double speed = 0.25;  // share of the largest joint speeds, 0…1; for a line: mm/s
  double blend = 0.0;   // mm: allowed distance from its end; 0: an exact stop
  std::string name;     // name of its waypoint; may be empty
};

// A frame of a cell in programs.
struct ProgramFrame {
  std::string name;  // the name in the cell
  Pose pose;         // in the base of the robot
};

// A program for a controller, independent of its language.
struct RobotProgram {
  std::string name;   // UTF-8
  std::string robot;  // the name of the model
  // From the base to the flange, in the convention of the controller: its tip is the flange.
  SerialArm arm{{}, Pose::Identity()};
  Pose tool = Pose::Identity();               // the tool's centre point in the flange
  Pose frame = Pose::Identity();              // frame of the written poses, in the base
  std::string frameName = {};                 // name of that frame in the cell; empty: it is none of the cell
  std::vector<std::string> otherFrames = {};  // names of the other frames of the cell
  std::vector<std::string> otherPaths = {};   // names of its other paths
  // The program declares the frame. Otherwise the controller has it, if the language can refer to it.
  bool declaresFrame = true;
  // Frames that programs may refer to without declaring them.
  std::vector<ProgramFrame> knownFrames = {};
  double toolMass = 1.0;  // kg; an assumption, which programs state
  // The base is that of the controller, as in its maker's table. Otherwise a description may have turned or raised it,
  // and only joint values mean the same to both.
  bool isBaseOfController = false;
  // Collisions were checked against simple shapes instead of the robot's own.
  bool hasPlainShapes = false;
  // mm: proven clearance of its motions, from its first waypoint on. None: nothing is proven.
  std::optional<double> clearance = {};
  // Unproven or outdated properties of the path: sentences in ASCII, which programs have as comments.
  std::vector<std::string> remarks = {};
  std::vector<ProgramMotion> motions;

  Pose tipOf(const ProgramMotion& motion) const { return arm.tipPose(motion.joints) * tool; }  // in the base
};

}  // namespace handwheel
