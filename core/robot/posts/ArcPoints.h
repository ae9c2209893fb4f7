// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "robot/RobotModel.h"

#include <optional>
#include <vector>

namespace handwheel {

// A circular motion of a tool as short straight lines.
struct ArcPoints {
  std::vector<Pose> poses;  // after the start of the arc; the last one is its end
  double angle = 0.0;       // rad, of the whole arc
  double chord = 0.0;       // mm, the length of each line
  double turn = 0.0;        // rad, twice the angle between the orientations at the start and in the middle
};

// Divides the arc from a pose through a place to another pose into lines that deviate from it by at most `deviation`
// (mm). The orientation relative to the direction of the path changes uniformly, by the shortest rotation. Returns
// nothing if the three places are nearly in a line, or two of them nearly at the same place.
std::optional<ArcPoints> pointsOfArc(const Pose& from, const Vec3& through, const Pose& to, double deviation);

}  // namespace handwheel
