// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/TrainedForceModel.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kMostForce = 1e7;  // N; no lathe reaches it, but powers of hostile models do

}  // namespace

TrainedForceModel::TrainedForceModel(ForceNetwork network, const PowerLaw& powerLaw, Origin origin,
                                     const CuttingEdge& edge, const ThrustSettings& thrust)
    : m_network(std::move(network)),
      m_powerLaw(powerLaw),
      m_origin(std::move(origin)),
      m_edge(edge),
      m_thrust(thrust) {}

bool TrainedForceModel::covers(const CutConditions& cut) const noexcept {
  const ForceNetwork::Inputs inputs{cut.depth, cut.feed, cut.speed};
  for (std::size_t i = 0; i < ForceNetwork::kInputs; ++i)
    if (!(inputs[i] >= m_network.least[i] && inputs[i] <= m_network.largest[i])) return false;
  return true;
}

CutForces TrainedForceModel::at(const CutConditions& given) const noexcept {
  const CutConditions cut = bounded(given);
  if (cut.depth == 0.0) return {};
  ForceNetwork::Inputs inputs{cut.depth, cut.feed, cut.speed};
  double outside = 0.0;  // largest distance from the range, relative to the width of the rim
  for (std::size_t i = 0; i < ForceNetwork::kInputs; ++i) {
    const double nearest = std::clamp(inputs[i], m_network.least[i], m_network.largest[i]);
    const double rim = kRim * (m_network.largest[i] - m_network.least[i]);
    if (nearest != inputs[i]) outside = std::max(outside, rim > 0.0 ? std::abs(inputs[i] - nearest) / rim : 1.0);
    inputs[i] = nearest;
  }
  const double law = m_powerLaw.at(cut);
  double force = law;
  if (outside < 1.0) {
    const CutConditions border{inputs[0], inputs[1], inputs[2]};
    // On the rim the network's value at the border is continued in proportion to the power law.
    const double onward = outside > 0.0 ? law / m_powerLaw.at(border) : 1.0;
    force = (1.0 - outside) * m_network.at(border) * onward + outside * law;
  }
  // Written so that NaN becomes 0.
  force = force > 0.0 ? std::min(force, kMostForce) : 0.0;
  return withThrust(force, cut, m_edge, m_thrust);
}

}  // namespace handwheel
