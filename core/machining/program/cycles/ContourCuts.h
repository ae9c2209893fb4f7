// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/cycles/RoughAndFinish.h"

namespace handwheel {

// A surface to be cut, from its upper end to its lower end. The upper end is at z = 0; r grows out of the material.
using CutContour = std::vector<ProfileSegment>;

// Returns the path of a tip that removes the material between a contour and the radius of the bar (mm). The nose of the
// tool is towards the axis and the chuck. The path consists of levels inward, one pass along the contour with the
// allowance, and one along the contour itself. It begins and ends beside the bar, in front of its end. Throws
// ProgramRefusal if the contour cannot be cut.
std::vector<ToolMove> contourCuts(CutContour contour, double barRadius, const CycleSettings& settings);

}  // namespace handwheel
