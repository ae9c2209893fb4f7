// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/posts/PostProcessor.h"
#include "tools/cell/path/PathCheck.h"

#include <filesystem>

namespace handwheel {

// An exported robot program, and its error when it is read back.
struct WrittenProgram {
  PostCheck check;
  std::size_t exactStops = 0;              // stoppedBlends()
  std::vector<SmallerBlend> smaller = {};  // smallerBlends()
  // The robot, if it is a built-in one and the controller is known to move those of another maker; otherwise empty.
  std::string otherRobot = {};
  std::string frame = {};  // CellPlans::workFrame, if waypoints of the program are in it
};

// Treatment of a free path that is out of date (OutdatedReasons).
enum class OutdatedPath { Refuse, Write };

// Location of the data of a program's frame: two modules of one RAPID task must not both have them. Other languages
// have them in each program.
enum class FrameData { InProgram, AtController };

// Returns the frame that the waypoints of a program are written in (CellPlans::workFrame), relative to the base of the
// robot of the scene. Errors: those of poseOfFrame(); FrameMoves if that robot moves it.
Result<Pose> programFrame(const CellScene& scene, const CellPlans& plans);

// Writes a certified path as a program, its waypoints in CellPlans::workFrame, with remarks about everything that is
// not proven or no longer holds. A motion that the controller cannot do is an error before anything is written; so is a
// text that does not read back as the path (1e-3 mm, 1e-3°). Errors: PathCollides, LineUnreachable, PathOutdated,
// PathBaseMoved, PathToolChanged, PathTargetMoved, PathWaypointChanged, FrameMissing, FrameStray, FrameMoves, those of
// PostProcessor::refusals() and of writing.
Result<WrittenProgram> writeProgram(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                                    const CheckedPath& checked, const PostProcessor& post,
                                    const std::filesystem::path& output, OutdatedPath outdated = OutdatedPath::Refuse,
                                    FrameData frameData = FrameData::InProgram);

// Returns the post for the controller of a robot, by its maker; one for any controller if the maker is unknown.
const PostProcessor& usualPost(const RobotArm& arm);

// A path that was read from a program, and the frames of its waypoints (framesOf()).
struct ProgramPath {
  RobotPath path;
  std::vector<NamedFrame> frames = {};
  // The lines with poses whose configuration the program leaves to the robot, in order.
  std::vector<std::size_t> openConfigurations = {};
  // Tool centre point, in the frame of the flange, of the first waypoint whose tool is not that of the cell; nothing:
  // all have that tool, or name none. The arm still reaches the waypoints, but straight lines are those of the cell's
  // tool.
  std::optional<Pose> otherTool = {};
};

// Reads a program in the language of a controller as a path: poses are reached by the joint values nearest to those of
// the preceding waypoint. RAPID may name frames of the cell that this robot does not move without having their data.
// Speeds are those of the program; if it gives a joint motion the speed of the tool, the share is chosen to give that
// speed on average. The path keeps the clearance that the head of the program states (keptClearance()). Errors: those
// of PostProcessor::read(); PoseUnreachable {motion, line}, BaseUnknown of a description without the base of its
// controller, Cancelled.
Result<ProgramPath> pathFromProgram(const CellScene& scene, const RobotCellSnapshot& cell, const PostProcessor& post,
                                    std::string_view text, Progress progress = {});

// Reads a path from a file: a program, by its ending, or a path file (PathFile.h). The path is of the robot that the
// cell plans for. Errors: also those of readFileHead() and readPath(), all with the file.
Result<ProgramPath> pathFromFile(const CellScene& scene, const RobotCellSnapshot& cell,
                                 const std::filesystem::path& file, Progress progress = {});

}  // namespace handwheel
