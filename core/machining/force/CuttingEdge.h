// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/CuttingForceModel.h"

#include <optional>

namespace handwheel {

enum class ToolMaterial { Carbide, HighSpeedSteel };

// The edge of a turning tool as the force laws see it. Angles in radian; values that are not given are those of the
// table of each law. Angles are those of ISO 3002.
struct CuttingEdge {
  ToolMaterial material = ToolMaterial::Carbide;
  std::optional<double> approach;     // κ, between edge and feed, in (0, π)
  std::optional<double> rake;         // γ, rake angle of the face
  std::optional<double> inclination;  // λ, inclination of the edge
  std::optional<double> noseRadius;   // mm, >= 0
  bool operator==(const CuttingEdge&) const = default;
};
inline constexpr double kUsualApproach = 1.5707963267948966;  // radian; 90°
inline constexpr double kUsualNoseRadius = 0.8;               // mm

// The method by which the feed and radial forces are found from the cutting force.
enum class ThrustLaw {
  Depth,     // direction from depth, feed and nose; magnitude a share of the cutting force
  Constant,  // feed and radial force are fixed shares of the cutting force: Ff = μ·Fc (He 2008, 3-6)
  Table,     // separate laws, if the table has some; else Depth
};

// The settings of thrust. The share is the mean of the ratios of two measured sets (0.81 for depths below 1 mm, 0.57 up
// to 1.25 mm); measured ratios Ff/Fc go from 0.12 to 0.95 as the depth grows, which no constant reproduces.
struct ThrustSettings {
  ThrustLaw law = ThrustLaw::Depth;
  double share = 0.7;        // for Depth
  double feedRatio = 0.4;    // μ, for Constant
  double radialRatio = 0.4;  // for Constant
  bool operator==(const ThrustSettings&) const = default;
};

// Returns the angle between the feed and the chord of the part of the edge that cuts, in [0, π); the chip flows
// perpendicular to it. The chord goes from the mark of the turn before, half a feed behind the tip, along the nose and
// the straight edge up to the depth of cut (Colwell, "Predicting the Angle of Chip Flow for Single-Point Cutting
// Tools", Trans. ASME 76, 1954). 0 for a cut of no depth; any thread, no allocation.
double chordAngle(const CutConditions& cut, const CuttingEdge& edge) noexcept;

// Returns the three forces from the cutting force, N, by Depth or by Constant; Table is as Depth here.
CutForces withThrust(double cutting, const CutConditions& cut, const CuttingEdge& edge,
                     const ThrustSettings& settings) noexcept;

}  // namespace handwheel
