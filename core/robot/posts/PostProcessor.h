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

// A motion that was read from a program. It ends at joint values, or at a pose of the tool's centre point.
struct ParsedMotion {
  ProgramMotion::Kind kind = ProgramMotion::Kind::Joint;
  std::optional<ArmValues> joints = {};  // rad; in the convention of the arm's model
  std::optional<Pose> pose = {};         // pose in the program's frame
  double blend = 0.0;                    // mm: largest distance from the end of the motion; 0: an exact stop
  std::size_t line = 0;                  // line of the program, from 1
  std::optional<double> speed = {};      // ProgramMotion::speed, above 0; none: the program does not specify it
  // The frame of the pose, in the base of the program that is passed to PostProcessor::read(); none: the program does
  // not define it.
  std::optional<Pose> frame = {};
  std::string frameName = {};  // name of that frame in the program; empty: none
  std::optional<double> toolSpeed =
      {};                 // mm/s: speed of the tool's centre point, in languages that give it for a joint motion
  std::string name = {};  // name of its waypoint in the program; empty: none
  // True if the configuration at the pose of a joint motion depends on the preceding configuration.
  bool isConfigurationOpen = false;
  // True if pose and frame are relative to the base of the controller (ControllerBaseFrame.h), which may be turned
  // against the base of the program.
  bool isInControllersBase = false;
  // The tool's centre point of the pose, in the flange; none: the program does not define it.
  std::optional<Pose> tool = {};
  // True if the program gives a pose, which joint values replace here, as they are in the configuration that it gives.
  bool isAtPose = false;
  // The configuration that the controller expects at the end of a line to a pose, for arms with a spherical wrist;
  // none: any, or not specified.
  std::optional<RapidConfiguration> endsIn = {};
  double corner = 0.0;                   // see ProgramMotion
  double seconds = 0.0;                  // see ProgramMotion
  std::vector<ProgramLine> before = {};  // lines before the first motion; empty for the others
  std::vector<ProgramLine> lines = {};   // see ProgramMotion
  // The numbers of the lines of the program with something that is read and not kept, such as handlers of errors; in
  // rising order. Empty for all motions but the first.
  std::vector<std::size_t> leftOut = {};
};

// Writes programs in the language of a controller, and reads them back. docs/posts.md explains how to add a post.
class PostProcessor {
 public:
  static constexpr std::size_t kMostMotions = 100'000;
  static constexpr std::size_t kLargestText = std::size_t{64} << 20;  // largest size of a program that is read, bytes

  virtual ~PostProcessor() = default;

  virtual const char* id() const = 0;      // name on the command line: "rapid"
  virtual const char* title() const = 0;   // language and manufacturer: "ABB RAPID"
  virtual const char* ending() const = 0;  // extension of the files: ".mod"
  // Returns the manufacturer of the robots, as at the beginning of the titles of the library (robot/dh/DhTable.h);
  // empty for a language of any robot.
  virtual const char* maker() const { return ""; }

  // Returns true if motions can end with ProgramMotion::corner.
  virtual bool hasCorners() const { return false; }

  // Returns the reasons why this controller cannot execute a program (PostErrors.h); empty if it can.
  virtual std::vector<Error> refusals(const RobotProgram& program) const;
  // Returns the text of the program. refusals() must be empty for it.
  virtual std::string write(const RobotProgram& program) const = 0;
  // Reads the motions of a program in this language. frame: the program whose arm, tool and frames the text refers to.
  // Errors: ElementMalformed, Unsupported, FileTooLarge; StatementUnread, with its line, for a statement that is not
  // understood and may move the robot.
  virtual Result<std::vector<ParsedMotion>> read(std::string_view text, const RobotProgram& frame) const = 0;
};

// Returns all posts in the order in which they are offered, those of plugins last.
std::span<const std::unique_ptr<PostProcessor>> posts();
// Sets the source of the posts of plugins. The source is called once, when posts are first needed, and must be set
// before. Of two posts with the same id only the first is kept.
void setPluginPosts(std::function<std::vector<std::unique_ptr<PostProcessor>>()> source);
const PostProcessor* postCalled(std::string_view id);           // null: there is none
const PostProcessor* postForEnding(std::string_view fileName);  // null: no post reads files with this name

// The differences between a written program and its path.
struct PostCheck {
  double distance = 0.0;  // largest position error, mm
  double angle = 0.0;     // largest orientation error, degrees
  std::size_t motions = 0;
  bool isInFrame = false;  // true if the program defines frames of some motions
};
// Reads a program back and compares it with the original: the ends of its motions (by forward kinematics), the frames,
// kinds, speeds and blends, and the lines that are kept, if they are of its language. A speed must be equal as far as
// the language can express it, and a blend must not be larger. Errors: the errors of PostProcessor::read(),
// CountMismatch {"motions", written, read}, MotionDiffers.
Result<PostCheck> checkWritten(const PostProcessor& post, const RobotProgram& program, std::string_view text);

}  // namespace handwheel
