// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/cycles/ContourCuts.h"
#include "machining/target/TargetProfile.h"

namespace handwheel {

// The bore of a target that is open at the upper end, z = 0.
struct BoreWall {
  enum class Bottom { Through, Flat, Drilled };

  CutContour wall;  // from the upper end downwards, without the bottom; r is the radius
  Bottom bottom = Bottom::Through;
  double depth = 0.0;  // mm, depth on the axis of a flat bottom, or of the point of the drill

  double leastRadius() const;  // mm, least radius of the wall; for a drilled bottom, at the start of its cone
};

// Ratio of the radius of a drill of 118° to the height of its point, tan 59°
inline constexpr double kDrillPointSlope = 1.664279;

// Returns the wall of the bore of a target. Throws ProgramRefusal if there is no such bore, if it has an undercut, or
// if its bottom is neither flat nor a cone of 118°.
BoreWall boreWallOf(const TargetProfile& target);

// Returns the wall down to a height, with a step inward to a radius at that height. This part can be bored while the
// cone that the drill left is below it. Throws ProgramRefusal if the height cuts an arc.
CutContour wallDownTo(const CutContour& wall, double z, double radius);

}  // namespace handwheel
