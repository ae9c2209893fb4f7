// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellFrames.h"
#include "tools/cell/path/PathExport.h"

namespace handwheel {

// Returns the frames of the motions of a program, each once. No body or link carries them. The base itself, frames
// without names and invalid poses are left out. A name that no frame of a cell can have (isBodyName()) is replaced by
// an identifier. base: the pose of the robot's base in the frame of the root.
std::vector<NamedFrame> framesOf(const std::vector<ParsedMotion>& motions, const Pose& base);

// Returns the index of the frame of a motion in the result of framesOf(); their number if the motion is in none.
std::size_t frameNumber(const std::vector<NamedFrame>& frames, const ParsedMotion& motion, const Pose& base);

// The names of the frames that takeFrames() handled.
struct TakenFrames {
  std::vector<std::string> made;
  std::vector<std::string> used;     // Frames that already existed
  std::vector<std::string> leftOut;  // Frames beyond the limit of a cell
  std::vector<std::string> names;    // The name in the cell of each frame; empty if it was left out
};

// Adds the frames of a program to the plans. If the cell has a frame with the same name at the same pose (to 0.001 mm
// and 0.001°), that frame is used instead, whatever carries it. The name may also be spelled as in programs. If the
// pose differs, a new frame with a number in its name is made. cell: the data from which the poses of frames in the
// cell follow.
TakenFrames takeFrames(const std::vector<NamedFrame>& read, const CellPlacement& cell, CellPlans& plans);

// Adds the path of a program and its frames to the plans. Waypoints keep the frames that they were read in, so that the
// path is outdated when these move.
TakenFrames takeProgram(ProgramPath read, const CellRobot& robot, const CellPlacement& cell, CellPlans& plans);

}  // namespace handwheel
