// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/SerialArm.h"

#include <optional>
#include <string>
#include <vector>

namespace handwheel {

// A motion of a program: from where the one before ended to these joint values.
struct ProgramMotion {
  enum class Kind {
    Joint,   // all joints together, straight in joint space
    Linear,  // the tool's centre point along a straight line, its turn by the shortest way
  };
  Kind kind = Kind::Joint;
  ArmValues joints;     // rad, mm; within the limits
  double speed = 0.25;  // of the joints: a share of their largest, 0…1; of a line: mm/s
  double blend = 0.0;   // mm that the motion may leave its end by; 0: an exact stop
  std::string name;     // of the place that it ends at; may be empty
};

// A frame of a cell as programs are in it.
struct ProgramFrame {
  std::string name;  // as the cell has it
  Pose pose;         // in the base of the robot
};

// What a controller is to do, before it is written in its language.
struct RobotProgram {
  std::string name;   // UTF-8
  std::string robot;  // the name of the model
  // From the base to the flange, as the controller counts: its tip is the flange.
  SerialArm arm{{}, Pose::Identity()};
  Pose tool = Pose::Identity();               // of the tool's centre point in the flange
  Pose frame = Pose::Identity();              // that the places are written in, in the base
  std::string frameName = {};                 // of that frame, as the cell has it; empty: it is none of the cell
  std::vector<std::string> otherFrames = {};  // the names of the others that the cell has
  std::vector<std::string> otherPaths = {};   // and of its other paths
  // The program has the data of the frame. Else they are at the controller, if the language can name them there.
  bool declaresFrame = true;
  // What programs that are read may name without having its data.
  std::vector<ProgramFrame> knownFrames = {};
  double toolMass = 1.0;  // kg; an assumption, which programs say they make
  // The base is the one that the controller counts from, as in its maker's table. Else a description may have turned or
  // raised it, and only joint values mean the same to both.
  bool isBaseOfController = false;
  // Collisions were checked against plain shapes in place of the robot's own.
  bool hasPlainShapes = false;
  // mm that its motions are proven to keep, from its first place on. None: nothing is proven of it.
  std::optional<double> clearance = {};
  // What was not proven of the path, or does not hold any more: sentences in ASCII, which programs have as comments.
  std::vector<std::string> remarks = {};
  std::vector<ProgramMotion> motions;

  Pose tipOf(const ProgramMotion& motion) const { return arm.tipPose(motion.joints) * tool; }  // in the base
};

}  // namespace handwheel
