// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "nurbs/ProfileCurve.h"

namespace handwheel {

// The cylindrical bar stock of a turned part. Its axis is z, and it extends from z = position to z = position + length.
struct StockCylinder {
  double diameter = 50.0;  // mm
  double length = 100.0;   // mm
  double position = 0.0;   // mm, z of the lower end

  static constexpr double kLeastSize = 1e-6, kLargestSize = 1e6;  // limits of diameter and length
  static constexpr double kFurthest = 1e7;                        // limit of the position, positive or negative

  // Returns true if all values are within the limits. Returns false for NaN.
  bool isSound() const;

  double volume() const;  // mm³
  double area() const;    // mm², lateral surface and both ends
  Box bounds() const;

  // Returns the profile of the bar, which is the straight line of the lateral surface. The flat ends are at the two
  // ends of the line. The stock must be sound (isSound()).
  ProfileCurve profile() const;

  bool operator==(const StockCylinder&) const = default;
};

}  // namespace handwheel
