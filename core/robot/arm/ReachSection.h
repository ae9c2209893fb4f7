// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "robot/arm/SerialArm.h"

#include <vector>

namespace handwheel {

// Settings of the computation of an arm's workspace outline.
struct ReachSectionSettings {
  int cells = 64;            // of the grid, to a reach of the arm
  double tolerance = 1.0;    // mm that the outline is off along the lines of the grid
  std::uint32_t starts = 6;  // from which a place is tried before it counts as out of reach
};

// The places that the tool's centre point of an arm reaches within the joint limits, whichever way it is turned, in the
// plane through the z axis of the base and a direction across it: their outlines, closed lines in the frame of the
// base. Found by inverse kinematics from place to place, beginning where the arm stands, so pieces of the reach that
// do not hang together with it are not seen; nothing is asked about collisions. tool: of the centre point in the arm's
// tip. Empty once cancelled. Some tenths of a second.
std::vector<std::vector<Vec3>> reachSection(const SerialArm& arm, const Pose& tool, const ArmValues& start,
                                            const Vec3& direction, const ReachSectionSettings& settings = {},
                                            Progress progress = {});

}  // namespace handwheel
