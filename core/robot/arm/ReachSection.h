// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "robot/arm/SerialArm.h"

#include <vector>

namespace handwheel {

// Settings of the computation of an arm's workspace outline.
struct ReachSectionSettings {
  int cells = 64;            // number of grid cells per reach of the arm
  double tolerance = 1.0;    // mm: error of the outline along the lines of the grid
  std::uint32_t starts = 6;  // number of starts before a position counts as out of reach
};

// Returns the outlines of the positions that the tool's centre point reaches within the joint limits, in any
// orientation. The section lies in the plane through the z axis of the base and a direction perpendicular to it; the
// outlines are closed lines in the frame of the base. They are found by inverse kinematics from position to position,
// beginning at the present one, so separate pieces of the reach are missed. Collisions are ignored. tool: tool centre
// point in the frame of the arm's tip. The result is empty after a cancellation. The computation takes some tenths of a
// second.
std::vector<std::vector<Vec3>> reachSection(const SerialArm& arm, const Pose& tool, const ArmValues& start,
                                            const Vec3& direction, const ReachSectionSettings& settings = {},
                                            Progress progress = {});

}  // namespace handwheel
