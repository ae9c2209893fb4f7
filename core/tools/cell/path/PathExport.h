// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/posts/PostProcessor.h"
#include "tools/cell/path/PathCheck.h"

#include <filesystem>

namespace handwheel {

// An exported robot program, and the errors found when it was read back.
struct WrittenProgram {
  PostCheck check;
  std::size_t exactStops = 0;              // The result of stoppedBlends()
  std::size_t stopsOfLanguage = 0;         // Proven blends that became exact stops, as the language has none there
  std::vector<SmallerBlend> smaller = {};  // The result of smallerBlends() for the blends in the program
  double seconds = 0.0;                    // Estimated duration of the program, with its own blends
  // The name of the robot if it is a built-in one and the controller is known to move robots of another manufacturer;
  // otherwise empty.
  std::string otherRobot = {};
  std::string frame = {};  // CellPlans::workFrame, if waypoints of the program are in this frame
};

// Treatment of a free path that is out of date (OutdatedReasons).
enum class OutdatedPath { Refuse, Write };

// Location of the data of a program's frame. Two modules of one RAPID task must not both contain the data; programs in
// other languages always do.
enum class FrameData { InProgram, AtController };

// Returns the frame that the waypoints of a program are written in (CellPlans::workFrame), relative to the base of the
// scene's robot. Errors: the errors of poseOfFrame(); FrameMoves if this robot moves the frame.
Result<Pose> programFrame(const CellScene& scene, const CellPlans& plans);

// Returns the first reason why no path of the scene's robot can be written in a language: other joints, such as a rail,
// than its controller moves.
Status canBeWritten(const CellScene& scene, const PostProcessor& post);

// Choices about a program that is written.
struct WriteChoices {
  OutdatedPath outdated = OutdatedPath::Refuse;
  FrameData frameData = FrameData::InProgram;
  std::vector<std::size_t> leftOut = {};  // The result of linesLeftOut(): the head of the program names them
};

// Writes a certified path as a program, with its waypoints in CellPlans::workFrame, and with remarks about everything
// that is not proven or not valid any more. Motions that the controller cannot execute are errors before anything is
// written. Errors: CheckFailed if the text does not read back as the path (1e-3 mm, 1e-3°); PathCollides,
// LineUnreachable, PathOutdated, PathBaseMoved, PathToolChanged, PathTargetMoved, PathFrameMoved, PathWaypointChanged,
// FrameMissing, FrameStray, FrameMoves, the errors of PostProcessor::refusals(), checkWritten() and of writing.
Result<WrittenProgram> writeProgram(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                                    const CheckedPath& checked, const PostProcessor& post,
                                    const std::filesystem::path& output, const WriteChoices& choices = {});

// Returns the post for the controller of a robot, chosen by the manufacturer; a post for any controller if the
// manufacturer is unknown.
const PostProcessor& usualPost(const RobotArm& arm);

// A path that was read from a program, and the frames of its waypoints (framesOf()).
struct ProgramPath {
  RobotPath path;
  std::vector<NamedFrame> frames = {};
  // The numbers of the lines with poses whose configuration the program leaves to the robot, in rising order.
  std::vector<std::size_t> openConfigurations = {};
  // Tool centre point, in the frame of the flange, of the first waypoint with another tool than the cell's; nothing:
  // all waypoints have the tool of the cell, or none. The arm still reaches the waypoints, but straight lines are those
  // of the cell's tool.
  std::optional<Pose> otherTool = {};
  // True if all waypoints with a tool have that one.
  bool isOnlyTool = true;
  // The numbers of the lines of which something is read and not kept (ParsedMotion::leftOut).
  std::vector<std::size_t> leftOut = {};
  std::vector<std::size_t> frameOf = {};  // For each waypoint its index in frames; beyond these: it is in none
};

// Reads a program in the language of a controller as a path. Poses become the joint values nearest to those of the
// preceding waypoint. A RAPID program may name frames of the cell without containing their data, if this robot does not
// move them. Speeds are those of the program; if it specifies the speed of the tool for a joint motion, the path has
// the fraction that results in this speed on average. The path keeps the clearance that the head of the program states
// (keptClearance()). Errors: the errors of PostProcessor::refusals() and PostProcessor::read(); PoseUnreachable
// {motion}, ConfigurationDiffers {configuration}, BaseUnknown if the description of the robot does not contain the base
// of its controller, ElementMalformed, ValueOutOfRange, Cancelled.
// data: the text of the controller's data files beside the program (RobotProgram::data).
Result<ProgramPath> pathFromProgram(const CellScene& scene, const RobotCellSnapshot& cell, const PostProcessor& post,
                                    std::string_view text, Progress progress = {}, std::string data = {});

// Reads a path from a file: a program, recognised by its extension, or a path file (PathFile.h). The path belongs to
// the robot that the cell plans for. With a program for KUKA robots the files of data beside it are read: that of its
// name, and $config.dat. Errors: the errors of pathFromProgram(), readFileHead() and readPath(), with the
// file as subject.
Result<ProgramPath> pathFromFile(const CellScene& scene, const RobotCellSnapshot& cell,
                                 const std::filesystem::path& file, Progress progress = {});

}  // namespace handwheel
