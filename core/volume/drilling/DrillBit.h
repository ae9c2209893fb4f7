// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

namespace handwheel {

enum class DrillShape {
  Ball,   // a ball on a shank that does not cut
  Burr,   // the same shape as Ball, under its trade name
  Twist,  // a cylinder with a conical tip
  Saw,    // a disc across the spindle
};

// The cutting head of a drill bit. Only the head removes material.
struct DrillBit {
  DrillShape shape = DrillShape::Ball;
  double diameter = 6.0;       // mm
  double pointAngle = 2.0595;  // rad, point angle of a twist drill: 118°
  double length = 60.0;        // mm, length of the cylinder of a twist drill
  double width = 1.0;          // mm, thickness of the disc of a saw

  static constexpr double kLeastDiameter = 0.05, kLargestDiameter = 200.0;  // mm
  static constexpr double kLeastWidth = 0.01;                               // mm

  double radius() const { return 0.5 * diameter; }
  // Returns the distance from the centre to the foremost point, mm. The centre of a twist drill is where its cone
  // reaches the full diameter.
  double reach() const;
  // Returns the distance from the centre to the cutting edge, mm: reach(), or the radius of a saw.
  double edge() const { return shape == DrillShape::Saw ? radius() : reach(); }
  // Returns the depth of a point inside the head, mm. Outside, the result is the negative distance. from: the vector
  // from the centre to the point; axis: unit vector towards the shank.
  double signedDepth(const Vec3& from, const Vec3& axis) const;
};

}  // namespace handwheel
