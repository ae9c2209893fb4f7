// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

namespace handwheel {

enum class DrillShape {
  Ball,   // a ball on a shank that does not cut
  Burr,   // the same, by whose name it is bought
  Twist,  // a cylinder with a cone before it
  Saw,    // a disc across the spindle
};

// The cutting head of a drill bit. What is behind the head removes nothing.
struct DrillBit {
  DrillShape shape = DrillShape::Ball;
  double diameter = 6.0;       // mm
  double pointAngle = 2.0595;  // rad, of the cone of a twist drill: 118°
  double length = 60.0;        // mm, of the cylinder of a twist drill
  double width = 1.0;          // mm, of the disc of a saw

  static constexpr double kLeastDiameter = 0.05, kLargestDiameter = 200.0;  // mm
  static constexpr double kLeastWidth = 0.01;                               // mm

  double radius() const { return 0.5 * diameter; }
  // From the centre to the foremost point, mm. The centre of a twist drill is where its cone has the full diameter.
  double reach() const;
  // From the centre to where it meets material: the same, but of a saw its radius, across the axis.
  double edge() const { return shape == DrillShape::Saw ? radius() : reach(); }
  // How deep a place is inside the head, mm; outside, the negative distance. from: from the centre; axis: to the shank,
  // of length 1.
  double signedDepth(const Vec3& from, const Vec3& axis) const;
};

}  // namespace handwheel
