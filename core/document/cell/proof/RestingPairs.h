// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Note.h"
#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// Returns the cell after pairs of links that touch at rest may touch (CellPlans::allowed). These are pairs of one robot
// with at most two joints in between, as of housings that are drawn too large, and pairs that touch at all joint
// values. notes: receives a note that names the new pairs, because proofs leave them out. It is called once for each
// robot, when its description is read.
std::shared_ptr<const RobotCellSnapshot> withRestingPairs(std::shared_ptr<const RobotCellSnapshot> cell,
                                                          std::vector<Note>& notes);

}  // namespace handwheel
