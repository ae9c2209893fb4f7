// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "robot/posts/RapidConfiguration.h"
#include "robot/program/RobotProgram.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace handwheel {

// A motion as it was read from a program. Its end is given by joint values, or by a pose of the tool's centre point.
struct ParsedMotion {
  ProgramMotion::Kind kind = ProgramMotion::Kind::Joint;
  std::optional<ArmValues> joints = {};  // rad; as the model of the arm counts
  std::optional<Pose> pose = {};         // in the program's frame
  double blend = 0.0;                    // mm
  std::size_t line = 0;                  // from 1
  std::optional<double> speed = {};      // as in ProgramMotion, above 0; none: the program does not say
  // That its place is given in, in the base of the program that it is read for; none: the program does not say.
  std::optional<Pose> frame = {};
  std::string frameName = {};            // of that frame, as the program calls it; empty: it does not
  std::optional<double> toolSpeed = {};  // mm/s: where a language gives a joint motion that of the tool's centre point
  std::string name = {};                 // of its place, as the program calls it; empty: it does not
  // In which way the arm comes to the pose of a joint motion depends on where the controller takes it from.
  bool isWayOpen = false;
  // Pose and frame count from the base of the controller (ControllerBaseFrame.h), which may be turned against the
  // program's.
  bool isInControllersBase = false;
  // The tool's centre point that it is of, in the flange; none: the program does not say.
  std::optional<Pose> tool = {};
  // In which the controller wants the arm at the end of a line to a pose; none: any, or it does not say. Of arms with a
  // spherical wrist.
  std::optional<RapidConfiguration> endsIn = {};
};

// Writes programs in the language of a controller, and reads them back. docs/posts.md tells how to write one.
class PostProcessor {
 public:
  static constexpr std::size_t kMostMotions = 100'000;
  static constexpr std::size_t kLargestText = std::size_t{64} << 20;  // bytes that are read

  virtual ~PostProcessor() = default;

  virtual const char* id() const = 0;      // on the command line: "rapid"
  virtual const char* title() const = 0;   // of its language and maker: "ABB RAPID"
  virtual const char* ending() const = 0;  // of its files: ".mod"
  // Whose robots its controllers move, as the titles of the library begin (robot/dh/DhTable.h). Empty: anybody's.
  virtual const char* maker() const { return ""; }

  // What this controller cannot do of a program, before anything is written (PostErrors.h). Empty: it can do all.
  virtual std::vector<Error> refusals(const RobotProgram& program) const;
  // The text of the program. refusals() must be empty.
  virtual std::string write(const RobotProgram& program) const = 0;
  // The motions of a program in this language; what is not understood of it and may move the robot is an error with its
  // line. arm: of the program that it is for. Errors: ElementMalformed, Unsupported, FileTooLarge.
  virtual Result<std::vector<ParsedMotion>> read(std::string_view text, const RobotProgram& frame) const = 0;
};

// All posts, those of plugins last, in the order in which they are offered.
std::span<const std::unique_ptr<PostProcessor>> posts();
// Where the posts of plugins come from. Asked once, when posts are first needed; set before that. Of two posts with one
// id the first is kept.
void setPluginPosts(std::function<std::vector<std::unique_ptr<PostProcessor>>()> source);
const PostProcessor* postCalled(std::string_view id);           // null: there is none
const PostProcessor* postForEnding(std::string_view fileName);  // that reads files of this name; null: none

// How far a written program is off.
struct PostCheck {
  double distance = 0.0;  // mm, the largest
  double angle = 0.0;     // degrees
  std::size_t motions = 0;
  bool isInFrame = false;  // some of them are read in a frame that the program has
};
// Reads a program back, computes where its motions end and compares these with the program (forward kinematics), and so
// the frames that they are in, their kinds, speeds and blends: a speed is the one wanted as far as the languages can
// say it, a blend never larger. Errors: those of PostProcessor::read(), CountMismatch {"motions", written, read},
// MotionDiffers.
Result<PostCheck> checkWritten(const PostProcessor& post, const RobotProgram& program, std::string_view text);

}  // namespace handwheel
