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

// Returns the tools for the bore at the upper end of a target: the drill of this diameter (mm) and the stiffest boring
// bar that fits into its hole. The bore must go through the target, or end in a flat bottom or in the cone of a drill
// of 118°. Errors: Refused if there are no such tools, if the drill is too large, or if the bore ends otherwise.
Result<BoreTools> boreTools(const TargetProfile& target, double drill, const LatheTools& tools);

// Returns true if the target has a bore that is open at its upper end.
bool hasBore(const TargetProfile& target);

// Returns the diameters (mm) of the drills for the bore of a target, the largest first. The list is empty if there is
// no bore that the tools can make.
std::vector<double> drillsFor(const TargetProfile& target, const LatheTools& tools);

// Returns the diameter (mm) of the largest drill for the bore of a target. The diameter is 0 if there is no bore that
// the tools can make.
double drillFor(const TargetProfile& target, const LatheTools& tools);

// Returns the reason why drillFor() finds no drill, or nothing if it finds one. The reason is the error
// (ProgramError::Unmakeable) for the largest drill that fits into the bore, or for the smallest drill if none fits.
std::optional<Error> whyNoDrill(const TargetProfile& target, const LatheTools& tools);

// Returns the paths of the tips that make the bore. The drill makes a hole along the axis. The boring bar cuts levels
// outward from the hole, then follows the wall once with the allowance and once without. Above a flat bottom the drill
// stops at a distance of 0.3 mm, and the remains of its cone are faced from the axis outward. The drill itself makes a
// bottom of 118°. The upper end of the target is z = 0. below: the length of the bar under the target into which the
// tools continue, mm. Errors: Refused.
Result<std::vector<ToolMove>> drillAndBore(const TargetProfile& target, const BoreTools& tools,
                                           const CycleSettings& settings, double below);

}  // namespace handwheel
