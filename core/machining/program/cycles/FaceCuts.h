// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"
#include "machining/program/cycles/RoughAndFinish.h"

namespace handwheel {

// The material that a part has beyond the face of its target.
struct EndStock {
  double height = 0.0;  // mm above the face; 0: nothing
  double hole = 0.0;    // mm, radius of the narrowest bore in it; 0: none

  // base: mm, z of the part's lower end in the coordinates of the target.
  static EndStock of(const TurnedProfile& part, double base, double upperEnd);
};

// Returns the path of the tip that faces the end of a bar down to z = 0. Passes from outside to the axis, or to the
// hole: none is deeper than the roughing depth, nor than 1.5 times the nose, the only known part of the tool; the last
// one, of the finishing tool, removes the allowance for finishing, a nose radius at most. It begins and ends beside the
// bar, in front of its end. No material above the face: no moves. Errors: Refused, if there are too many passes.
Result<std::vector<ToolMove>> faceCuts(const EndStock& end, double barRadius, const CycleSettings& settings);

}  // namespace handwheel
