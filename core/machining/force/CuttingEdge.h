// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/CuttingForceModel.h"

#include <optional>

namespace handwheel {

enum class ToolMaterial { Carbide, HighSpeedSteel };

// The edge of a turning tool, as the force laws need it. Angles are defined by ISO 3002 and are in rad. If a value is
// not given, each law uses the value of its table.
struct CuttingEdge {
  ToolMaterial material = ToolMaterial::Carbide;
  std::optional<double> approach;     // κ, angle between edge and feed, in (0, π)
  std::optional<double> rake;         // γ, rake angle of the face
  std::optional<double> inclination;  // λ, inclination of the edge
  std::optional<double> noseRadius;   // mm, >= 0
  bool operator==(const CuttingEdge&) const = default;
};
inline constexpr double kUsualApproach = 1.5707963267948966;  // rad; 90°
inline constexpr double kUsualNoseRadius = 0.8;               // mm

// The method by which the feed and radial forces are found from the cutting force.
enum class ThrustLaw {
  Depth,     // direction from depth, feed and nose; magnitude as a fraction of the cutting force
  Constant,  // feed and radial force as fixed fractions of the cutting force, Ff = μ·Fc (He 2008, eq. 3-6)
  Table,     // separate laws of the table; Depth if the table has none
};

// The settings of the feed and radial forces. The default of `share` is the mean of the ratios of two measured sets
// (0.81 for depths below 1 mm, 0.57 for depths up to 1.25 mm). Measured ratios Ff/Fc rise from 0.12 to 0.95 as the
// depth grows, which no constant reproduces.
struct ThrustSettings {
  ThrustLaw law = ThrustLaw::Depth;
  double share = 0.7;        // fraction of the cutting force, for Depth
  double feedRatio = 0.4;    // μ, for Constant
  double radialRatio = 0.4;  // fraction of the cutting force, for Constant
  bool operator==(const ThrustSettings&) const = default;
};

// Returns the angle between the feed and the chord of the part of the edge that cuts, in [0, π); the chip flows
// perpendicular to it. The chord goes from the mark that the previous turn left half a feed behind the tip, along the
// nose and the straight edge, up to the depth of cut (Colwell, "Predicting the Angle of Chip Flow for Single-Point
// Cutting Tools", Trans. ASME 76, 1954). The angle is 0 for a cut of no depth. May be called on any thread; allocates
// nothing.
double chordAngle(const CutConditions& cut, const CuttingEdge& edge) noexcept;

// Returns the three forces (N) that follow from the cutting force by ThrustLaw::Depth or Constant. Table is treated as
// Depth.
CutForces withThrust(double cutting, const CutConditions& cut, const CuttingEdge& edge,
                     const ThrustSettings& settings) noexcept;

}  // namespace handwheel
