// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/CuttingEdge.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

double chordAngle(const CutConditions& cut, const CuttingEdge& edge) noexcept {
  const double approach = edge.approach.value_or(kUsualApproach), radius = edge.noseRadius.value_or(kUsualNoseRadius);
  // The nose ends at its tangent point with the straight edge.
  const double noseDepth = radius * (1.0 - std::cos(approach));
  const double along =
      cut.depth < noseDepth
          ? radius * std::sqrt(std::max(0.0, 1.0 - (1.0 - cut.depth / radius) * (1.0 - cut.depth / radius)))
          : radius * std::sin(approach) + (cut.depth - noseDepth) * std::cos(approach) / std::sin(approach);
  return std::atan2(cut.depth, along + 0.5 * cut.feed);
}

CutForces withThrust(double cutting, const CutConditions& cut, const CuttingEdge& edge,
                     const ThrustSettings& settings) noexcept {
  if (settings.law == ThrustLaw::Constant)
    return {cutting, settings.feedRatio * cutting, settings.radialRatio * cutting};
  const double angle = chordAngle(cut, edge), thrust = settings.share * cutting;
  // An edge that leans back, like that of a parting tool, would pull the tool in: such pulls are not rendered.
  return {cutting, thrust * std::sin(angle), thrust * std::max(0.0, std::cos(angle))};
}

}  // namespace handwheel
