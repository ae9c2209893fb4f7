// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/posts/PostProcessor.h"

namespace handwheel {

// Base class of the posts of controllers that move arms with six revolute joints.
class ControllerPost : public PostProcessor {
 public:
  std::vector<Error> refusals(const RobotProgram& program) const override;
  // Returns the largest speed, mm/s. A larger one stops a program with an error, or differs from the verified one.
  virtual double fastestLine() const = 0;
};

// ABB: a module with a procedure of the path's name, MoveAbsJ for joint motions and MoveL for lines. Quaternions, mm,
// degrees. If the base is not the controller's, lines end at the results of CalcRobT for joint values.
class RapidPost : public ControllerPost {
 public:
  const char* id() const override { return "rapid"; }
  const char* title() const override { return "ABB RAPID"; }
  const char* ending() const override { return ".mod"; }
  const char* maker() const override { return "ABB"; }
  double fastestLine() const override { return 7'000.0; }  // v7000 is the fastest predefined speed
  std::string write(const RobotProgram& program) const override;
  Result<std::vector<ParsedMotion>> read(std::string_view text, const RobotProgram& frame) const override;
};

// KUKA: PTP by joints, LIN by X, Y, Z, A, B, C. The blending of PTP motions is in percent in KRL, not in mm: those stop
// exactly.
class KrlPost : public ControllerPost {
 public:
  const char* id() const override { return "krl"; }
  const char* title() const override { return "KUKA KRL"; }
  const char* ending() const override { return ".src"; }
  const char* maker() const override { return "KUKA"; }
  double fastestLine() const override { return 3'000.0; }  // $VEL_MA.CP as delivered
  std::string write(const RobotProgram& program) const override;
  Result<std::vector<ParsedMotion>> read(std::string_view text, const RobotProgram& frame) const override;
};

// Fanuc: J by joints, with the third in this maker's convention (minus the second), L by X, Y, Z, W, P, R in the world
// frame, which lies at the height of axis 2, or in a frame of the cell, which the program sets as user frame 9. The
// path of CNT is not defined: all motions stop exactly (FINE).
class FanucPost : public ControllerPost {
 public:
  const char* id() const override { return "fanuc"; }
  const char* title() const override { return "Fanuc LS"; }
  const char* ending() const override { return ".ls"; }
  const char* maker() const override { return "Fanuc"; }
  double fastestLine() const override { return 2'000.0; }  // limit of linear instructions
  std::string write(const RobotProgram& program) const override;
  Result<std::vector<ParsedMotion>> read(std::string_view text, const RobotProgram& frame) const override;
};

// Universal Robots: movej and movel by joints; metres and radians. ROS turns the base of these robots by 180° against
// the controller's, which affects poses but not joint values. In a frame of the cell, and if the base is the
// controller's, lines are pose_trans(frame, pose).
class UrScriptPost : public ControllerPost {
 public:
  const char* id() const override { return "urscript"; }
  const char* title() const override { return "URScript"; }
  const char* ending() const override { return ".script"; }
  const char* maker() const override { return "Universal Robots"; }
  double fastestLine() const override { return 5'000.0; }  // limit of the safety settings
  std::string write(const RobotProgram& program) const override;
  Result<std::vector<ParsedMotion>> read(std::string_view text, const RobotProgram& frame) const override;
};

// Returns posts for tables of joints and poses for other programs, for any arm.
std::unique_ptr<PostProcessor> makeCsvPost();
std::unique_ptr<PostProcessor> makeJsonPost();

}  // namespace handwheel
