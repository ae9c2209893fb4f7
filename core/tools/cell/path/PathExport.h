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
  // The robot, if it comes with the program and the controller is known to move those of another maker; else empty.
  std::string otherRobot = {};
  std::string frame = {};  // CellPlans::workFrame, if places of the program are in it
};

// What becomes of a path that is free, but does not lead any more to what it was planned for (OutdatedReasons).
enum class OutdatedPath { Refuse, Write };

// Where the data of a program's frame are: two modules of one RAPID task must not both have them. Other languages have
// them in each program.
enum class FrameData { InProgram, AtController };

// The frame that the places of a program are written in (CellPlans::workFrame), in the base of the robot that the scene
// is for. Errors: those of poseOfFrame(); FrameMoves where that robot moves it.
Result<Pose> programFrame(const CellScene& scene, const CellPlans& plans);

// Writes a certified path as a program, its places in CellPlans::workFrame, with remarks of what was not proven or does
// not hold any more. What the controller cannot do is an error before anything is written; so is a text that does not
// read back as the path (1e-3 mm, 1e-3°). Errors: PathCollides, LineUnreachable, PathOutdated, PathBaseMoved,
// PathToolChanged, PathTargetMoved, PathPlaceChanged, FrameMissing, FrameStray, FrameMoves, those of
// PostProcessor::refusals() and of writing.
Result<WrittenProgram> writeProgram(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                                    const CheckedPath& checked, const PostProcessor& post,
                                    const std::filesystem::path& output, OutdatedPath outdated = OutdatedPath::Refuse,
                                    FrameData frameData = FrameData::InProgram);

// The post for the controller of a robot, by its maker; one for any controller where that is not known.
const PostProcessor& usualPost(const RobotArm& arm);

// A path that was read from a program, and the frames that its places are in there (framesOf()).
struct ProgramPath {
  RobotPath path;
  std::vector<NamedFrame> frames = {};
  // The lines with poses in whatever way the arm comes to them from where it is (ParsedMotion::isWayOpen), in order.
  std::vector<std::size_t> openWays = {};
  // The tool's centre point in the flange of the first place whose tool is not that of the cell; none: all have it, or
  // do not say. The arm comes to the places all the same, but straight lines are those of the cell's tool.
  std::optional<Pose> otherTool = {};
};

// A program in the language of a controller as a path: poses are reached by the joint values that are nearest to those
// of the place before. RAPID may name frames of the cell that this robot does not move without having their data.
// Speeds are those of the program; where it gives a joint motion the speed of the tool, the share is that with which
// the tool comes to it on average. The path keeps the clearance that the head of the program tells (keptClearance()).
// Errors: those of PostProcessor::read(); PoseUnreachable {motion, line}, BaseUnknown of a description without the base
// of its controller, Cancelled.
Result<ProgramPath> pathFromProgram(const CellScene& scene, const RobotCellSnapshot& cell, const PostProcessor& post,
                                    std::string_view text, Progress progress = {});

// The same from a file: a program, by its ending, or a path file (PathFile.h). The path is of the robot that the cell
// plans for. Errors: those of readFileHead() and readPath(), too, all about the file.
Result<ProgramPath> pathFromFile(const CellScene& scene, const RobotCellSnapshot& cell,
                                 const std::filesystem::path& file, Progress progress = {});

}  // namespace handwheel
