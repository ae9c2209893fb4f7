// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/SerialArm.h"

#include <optional>
#include <string>
#include <vector>

namespace handwheel {

// A line of a program that is not interpreted and goes with a waypoint.
struct ProgramLine {
  static constexpr std::size_t kMost = 10'000;  // limit for the lines between two motions
  // Axes: values of external axes, which are the same at all waypoints, as positions of the language have them.
  enum class Kind { Statement, Comment, Declaration, Axes };
  Kind kind = Kind::Statement;
  std::string text;      // without its separator; of a comment without its sign
  std::size_t line = 0;  // line of the program that it was read from, from 1
  bool mayGrip = false;  // true if a tool may grip or release something by it

  bool operator==(const ProgramLine&) const = default;
};

// A motion of a program, from the end of the previous one.
struct ProgramMotion {
  enum class Kind {
    Joint,   // all joints move together, straight in joint space
    Linear,  // the tool's centre point moves along a straight line, and its rotation along the shortest turn
  };
  static constexpr double kLargestCorner = 100.0;  // percent
  static constexpr double kLongest = 1e5;          // s
  Kind kind = Kind::Joint;
  ArmValues joints;     // joint values at the end of the motion; rad, mm; within the limits
  double speed = 0.25;  // mm/s for a line, otherwise a fraction of the largest joint speeds, 0…1
  double blend = 0.0;   // mm: allowed distance from the end of the motion; 0: an exact stop
  std::string name;     // name of its waypoint; may be empty
  // Percent of the rounding at the end of the motion, as CNT of Fanuc, whose path no length describes; 0: none.
  double corner = 0.0;
  double seconds = 0.0;                 // s: duration that the program demands; 0: the speed decides
  std::vector<ProgramLine> lines = {};  // lines between this motion and the next one
};

// A frame of a cell that programs may refer to.
struct ProgramFrame {
  std::string name;  // the name in the cell
  Pose pose;         // pose in the base of the robot
};

// A program for a controller, independent of its language.
struct RobotProgram {
  std::string name;   // UTF-8
  std::string robot;  // the name of the model
  // The arm from the base to the flange, in the convention of the controller. Its tip is the flange.
  SerialArm arm{{}, Pose::Identity()};
  Pose tool = Pose::Identity();               // the tool's centre point in the flange
  Pose frame = Pose::Identity();              // frame of the written poses, in the base
  std::string frameName = {};                 // name of that frame in the cell; empty: the frame is none of the cell
  std::vector<std::string> otherFrames = {};  // names of the other frames of the cell
  std::vector<std::string> otherPaths = {};   // names of the other paths of the cell
  // True if the program declares the frame. Otherwise the controller has to know it, if the language can refer to it.
  bool declaresFrame = true;
  // Lines of the program that the path was read from, before its first motion, and the language of these and of the
  // lines of motions (PostProcessor::id()); empty: there are none.
  std::vector<ProgramLine> head = {};
  std::string language = {};
  // Reading: the text of the controller's data files beside the program, and the joint values of the cell's
  // configuration "home" (rad).
  std::string data = {};
  std::optional<ArmValues> home = {};
  // The frames that programs may refer to without declaring them.
  std::vector<ProgramFrame> knownFrames = {};
  double toolMass = 1.0;  // kg; an assumption, which programs state
  // True if the base is that of the controller, as in the manufacturer's table. Otherwise a robot description may have
  // turned or raised the base, and only joint values have the same meaning in the cell and at the controller.
  bool isBaseOfController = false;
  // True if collisions were checked against simple shapes instead of the robot's own.
  bool hasPlainShapes = false;
  // mm: proven clearance of the motions, from the first waypoint on. None: nothing is proven.
  std::optional<double> clearance = {};
  // Unproven or outdated properties of the path. They are sentences in ASCII, which programs contain as comments.
  std::vector<std::string> remarks = {};
  std::vector<ProgramMotion> motions;

  // Returns the pose of the tool's centre point at the end of a motion, in the base.
  Pose tipOf(const ProgramMotion& motion) const { return arm.tipPose(motion.joints) * tool; }
};

}  // namespace handwheel
