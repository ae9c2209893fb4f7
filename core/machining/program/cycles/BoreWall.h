// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/cycles/ContourCuts.h"
#include "machining/target/TargetProfile.h"

namespace handwheel {

// The bore of a target that is open at the upper end, z = 0.
struct BoreWall {
  enum class Bottom { Through, Flat, Drilled };

  CutContour wall;  // from the upper end down, without the bottom; r is the radius
  Bottom bottom = Bottom::Through;
  double depth = 0.0;  // mm, depth of a bottom on the axis: of the flat, or of the point of the drill

  double leastRadius() const;  // mm, least radius of the wall; for a drilled bottom, that at the begin of its cone
};

// tan 59°: a drill of 118° is this much wider, on the radius, than its point is high.
inline constexpr double kDrillPointSlope = 1.664279;

// Returns the wall. Throws ProgramRefusal: there is no such bore, it has an undercut, or its bottom is neither flat nor
// a cone of 118°.
BoreWall boreWallOf(const TargetProfile& target);

// Returns the wall down to a height only, with a step inward to a radius there: the part that can be bored while the
// rest of a drill's point is below. Throws ProgramRefusal: an arc is cut there.
CutContour wallDownTo(const CutContour& wall, double z, double radius);

}  // namespace handwheel
