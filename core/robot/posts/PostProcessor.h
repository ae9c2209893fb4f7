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

// A motion read from a program. Its end is given by joint values, or by a pose of the tool's centre point.
struct ParsedMotion {
  ProgramMotion::Kind kind = ProgramMotion::Kind::Joint;
  std::optional<ArmValues> joints = {};  // rad; in the convention of the arm's model
  std::optional<Pose> pose = {};         // in the program's frame
  double blend = 0.0;                    // mm
  std::size_t line = 0;                  // from 1
  std::optional<double> speed = {};      // see ProgramMotion, above 0; none: the program does not say
  // The frame of its pose, in the base of the program that it is read for; none: the program does not define it.
  std::optional<Pose> frame = {};
  std::string frameName = {};  // name of that frame in the program; empty: none
  std::optional<double> toolSpeed =
      {};                 // mm/s: speed of the tool's centre point, in languages that give it for a joint motion
  std::string name = {};  // name of its waypoint in the program; empty: none
  // The configuration at the pose of a joint motion depends on the configuration before it.
  bool isConfigurationOpen = false;
  // Pose and frame are relative to the base of the controller (ControllerBaseFrame.h), which may be turned against the
  // program's.
  bool isInControllersBase = false;
  // The tool's centre point of the pose, in the flange; none: the program does not define it.
  std::optional<Pose> tool = {};
  // The configuration that the controller expects at the end of a line to a pose; none: any, or not given. For arms
  // with a spherical wrist.
  std::optional<RapidConfiguration> endsIn = {};
};

// Writes programs in the language of a controller, and reads them back. docs/posts.md explains new ones.
class PostProcessor {
 public:
  static constexpr std::size_t kMostMotions = 100'000;
  static constexpr std::size_t kLargestText = std::size_t{64} << 20;  // limit of a program that is read, bytes

  virtual ~PostProcessor() = default;

  virtual const char* id() const = 0;      // on the command line: "rapid"
  virtual const char* title() const = 0;   // language and maker: "ABB RAPID"
  virtual const char* ending() const = 0;  // extension of its files: ".mod"
  // The maker of the robots, as at the beginning of the titles of the library (robot/dh/DhTable.h). Empty: any.
  virtual const char* maker() const { return ""; }

  // Returns the parts of a program that this controller cannot do, before anything is written (PostErrors.h). Empty:
  // none.
  virtual std::vector<Error> refusals(const RobotProgram& program) const;
  // Returns the text of the program. refusals() must be empty.
  virtual std::string write(const RobotProgram& program) const = 0;
  // Reads the motions of a program in this language. A statement that is not understood and may move the robot is an
  // error with its line. frame: the program that it is read for. Errors: ElementMalformed, Unsupported, FileTooLarge.
  virtual Result<std::vector<ParsedMotion>> read(std::string_view text, const RobotProgram& frame) const = 0;
};

// Returns all posts in the order in which they are offered, those of plugins last.
std::span<const std::unique_ptr<PostProcessor>> posts();
// Sets the source of the posts of plugins. It is called once, when posts are first needed; set it before that. The
// first of two posts with the same id is kept.
void setPluginPosts(std::function<std::vector<std::unique_ptr<PostProcessor>>()> source);
const PostProcessor* postCalled(std::string_view id);           // null: there is none
const PostProcessor* postForEnding(std::string_view fileName);  // the post that reads files of this name; null: none

// The errors of a written program.
struct PostCheck {
  double distance = 0.0;  // the largest, mm
  double angle = 0.0;     // degrees
  std::size_t motions = 0;
  bool isInFrame = false;  // some motions are read in a frame of the program
};
// Reads a program back and compares it with the original: the ends of its motions (by forward kinematics), the frames,
// kinds, speeds and blends. A speed must be the wanted one as far as the language can express it, a blend never larger.
// Errors: those of PostProcessor::read(), CountMismatch {"motions", written, read}, MotionDiffers.
Result<PostCheck> checkWritten(const PostProcessor& post, const RobotProgram& program, std::string_view text);

}  // namespace handwheel
