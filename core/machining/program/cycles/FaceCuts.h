// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"
#include "machining/program/cycles/RoughAndFinish.h"

namespace handwheel {

// The material that a part has beyond the face of its target.
struct EndStock {
  double height = 0.0;  // mm above the face; 0: no material
  double hole = 0.0;    // mm, radius of the narrowest bore in the material; 0: no bore

  // Finds the material of a part. base: the z of the part's lower end in the coordinates of the target, mm. upperEnd:
  // the z of the face.
  static EndStock of(const TurnedProfile& part, double base, double upperEnd);
};

// Returns the path of the tip that faces the end of a bar down to z = 0. Its passes go from the outside to the axis, or
// to the hole. No pass is deeper than the roughing depth, or than 1.5 times the radius of the nose, which is the only
// known part of the tool. The last pass, with the finishing tool, removes the allowance for finishing, at most a nose
// radius. The path begins and ends beside the bar, in front of its end. It is empty if there is no material above the
// face. Errors: Refused if there are too many passes.
Result<std::vector<ToolMove>> faceCuts(const EndStock& end, double barRadius, const CycleSettings& settings);

}  // namespace handwheel
