// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellFrames.h"
#include "robot/posts/PostProcessor.h"

namespace handwheel {

// Returns the frames of the motions of a program. They have no carrier, and each occurs once. base: of the robot, in
// the frame of the root. Without the base itself, frames without names, and invalid poses. A name that no frame of a
// cell can have (isBodyName()) becomes an identifier.
std::vector<NamedFrame> framesOf(const std::vector<ParsedMotion>& motions, const Pose& base);

// The frames of a program in a cell, by their names in the cell.
struct TakenFrames {
  std::vector<std::string> made;
  std::vector<std::string> used;     // Frames that already existed
  std::vector<std::string> leftOut;  // Frames beyond the limit of a cell
};

// Adds frames of a program to the plans. An existing frame at the same pose (to 0.001 mm and 0.001°) is used, whatever
// carries it, if it has the same name, also in the spelling of programs; at another pose a new one with a number is
// made. cell: the data for the poses of frames.
TakenFrames takeFrames(const std::vector<NamedFrame>& read, const CellPlacement& cell, CellPlans& plans);

}  // namespace handwheel
