// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/posts/PostProcessor.h"

namespace handwheel {

// Base class of the posts of controllers that move arms with six revolute joints.
class ControllerPost : public PostProcessor {
 public:
  std::vector<Error> refusals(const RobotProgram& program) const override;
  // Returns the largest speed of a line, mm/s. At a larger one the controller stops the program with an error, or uses
  // another speed than the verified one.
  virtual double fastestLine() const = 0;
};

// Writes ABB RAPID: a module with a procedure named after the path. It has MoveAbsJ for joint motions and MoveL for
// lines, with quaternions, mm and degrees. If the base is not the controller's, the controller computes the ends of
// lines from joint values, by CalcRobT.
class RapidPost : public ControllerPost {
 public:
  const char* id() const override { return "rapid"; }
  const char* title() const override { return "ABB RAPID"; }
  const char* ending() const override { return ".mod"; }
  const char* maker() const override { return "ABB"; }
  double fastestLine() const override { return 7'000.0; }  // v7000 is the fastest predefined speed
  std::vector<Error> refusals(const RobotProgram& program) const override;
  std::string write(const RobotProgram& program) const override;
  Result<std::vector<ParsedMotion>> read(std::string_view text, const RobotProgram& frame) const override;
};

// Writes KUKA KRL: PTP to joint values and LIN to X, Y, Z, A, B, C. Blending of PTP motions is in percent in KRL, not
// in mm, so these motions stop exactly.
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

// Writes Fanuc LS: J to joint values and L to X, Y, Z, W, P, R. The third joint value follows this maker's convention:
// the second one is subtracted from it. Poses are in the world frame, which lies at the height of axis 2, or in a frame
// of the cell, which the program sets as user frame 9. The path of a CNT motion is not defined, so all motions stop
// exactly (FINE).
class FanucPost : public ControllerPost {
 public:
  const char* id() const override { return "fanuc"; }
  const char* title() const override { return "Fanuc LS"; }
  const char* ending() const override { return ".ls"; }
  const char* maker() const override { return "Fanuc"; }
  bool hasCorners() const override { return true; }
  double fastestLine() const override { return 2'000.0; }  // limit of linear instructions
  std::string write(const RobotProgram& program) const override;
  Result<std::vector<ParsedMotion>> read(std::string_view text, const RobotProgram& frame) const override;
};

// Writes URScript: movej and movel to joint values, in metres and radians. ROS turns the base of these robots by 180°
// against the controller's, which affects poses but not joint values. If a frame of the cell is used and the base is
// the controller's, the targets of lines are pose_trans(frame, pose).
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

// Return posts that write tables of joint values and poses for other programs. They support any arm.
std::unique_ptr<PostProcessor> makeCsvPost();
std::unique_ptr<PostProcessor> makeJsonPost();

}  // namespace handwheel
