// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellFrames.h"
#include "robot/posts/PostProcessor.h"

namespace handwheel {

// The frames that motions of a program are in. They are carried by nothing, and each is there once. base: of the robot,
// in the frame of the root. Without the base itself, frames without names, and those that are no poses. A name
// that no frame of a cell can have (isBodyName()) becomes an identifier.
std::vector<NamedFrame> framesOf(const std::vector<ParsedMotion>& motions, const Pose& base);

// What became of such frames in a cell, by their names there.
struct TakenFrames {
  std::vector<std::string> made;
  std::vector<std::string> used;     // that were there
  std::vector<std::string> leftOut;  // as there are too many
};

// Adds frames of a program to a plan. One that is there at the same pose (to 0.001 mm and 0.001°) is used, whatever
// carries it, where it has the name, or one that programs call so; at another pose a new one with a number is made.
// cell: where the frames are.
TakenFrames takeFrames(const std::vector<NamedFrame>& read, const CellPlacement& cell, CellPlans& plans);

}  // namespace handwheel
