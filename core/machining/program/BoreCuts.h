// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheTool.h"
#include "machining/program/RoughAndFinish.h"

namespace handwheel {

// With what a hole through a part is made.
struct BoreTools {
  std::shared_ptr<const LatheTool> drill, bar;
};

// Tools for the bore of a target, which goes through it: the drill of this diameter (mm) and the stiffest boring bar
// that fits into its hole. Errors: Refused, where there are none, the drill is too large or the bore does not go
// through.
Result<BoreTools> boreTools(const TargetProfile& target, double drill, const LatheTools& tools);

// The diameter of the largest drill for the bore of a target; 0: it has none that can be made so.
double drillFor(const TargetProfile& target, const LatheTools& tools);

// The paths of the tips that make the bore: a hole along the axis, levels outward from it, once along the wall with the
// allowance, and along the wall itself. The upper end of the target is z = 0. below: mm of the bar under the target,
// into which the tools go on. Errors: Refused.
Result<std::vector<ToolMove>> drillAndBore(const TargetProfile& target, const BoreTools& tools,
                                           const CycleSettings& settings, double below);

}  // namespace handwheel
