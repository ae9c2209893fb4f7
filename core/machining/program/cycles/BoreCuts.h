// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheTool.h"
#include "machining/program/cycles/RoughAndFinish.h"

#include <optional>

namespace handwheel {

// The tools that make a bore. bar: null if the drill alone makes it.
struct BoreTools {
  std::shared_ptr<const LatheTool> drill, bar;
};

// Returns tools for the bore of a target that is open at its upper end: the drill of this diameter (mm) and the
// stiffest boring bar that fits into its hole. The bore goes through the target, or ends in a flat bottom or in the
// cone of a drill of 118°. Errors: Refused, if there are none, the drill is too large or the bore ends otherwise.
Result<BoreTools> boreTools(const TargetProfile& target, double drill, const LatheTools& tools);

// Returns the diameter of the largest drill for the bore of a target; 0: it has none that can be made so.
double drillFor(const TargetProfile& target, const LatheTools& tools);

// Returns the reason why there is no drill for it: the error of boreTools() for the smallest one,
// ProgramError::Refused.
std::optional<Error> whyNoDrill(const TargetProfile& target, const LatheTools& tools);

// Returns the paths of the tips that make the bore: a hole along the axis, levels outward from it, once along the wall
// with the allowance, and along the wall itself. Over a flat bottom the drill stays 0.3 mm above it, and the remains of
// its point are faced from the axis outward; a bottom of 118° is made by the drill. The upper end of the target is z =
// 0. below: mm of the bar under the target into which the tools continue. Errors: Refused.
Result<std::vector<ToolMove>> drillAndBore(const TargetProfile& target, const BoreTools& tools,
                                           const CycleSettings& settings, double below);

}  // namespace handwheel
