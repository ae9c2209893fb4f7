// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "globe/simulation/DentSimulation.h"

#include <cmath>

namespace handwheel::test {

DentSimulation::DentSimulation(GlobeSurface surface, const Pose& pose, std::shared_ptr<DentChannel> channel)
    : m_surface(std::move(surface)),
      m_sceneToGlobe(pose.inverse()),
      m_channel(std::move(channel)),
      m_state(std::make_shared<const DentState>(m_surface)) {}

void DentSimulation::step(double, std::span<const SimulationInput> inputs) {
  bool isChanged = false;
  for (const SimulationInput& input : inputs) isChanged = (input.gesture != 0 && press(input.tip)) || isChanged;
  if (isChanged) m_state = std::make_shared<const DentState>(m_surface, true);
  if (!inputs.empty()) m_channel->patch.write(patchAround(m_surface, m_sceneToGlobe * inputs.back().tip.position));
}

bool DentSimulation::press(const TipState& tip) {
  if (!tip.position.allFinite()) return false;
  const Vec3 inside = m_sceneToGlobe * tip.position;
  const double depth = m_surface.heightTowards(inside) - inside.norm();
  if (!(depth > 0.0)) return false;
  const double share = -std::expm1(-tip.period / kYield) * depth / m_surface.radius();
  const Vec3 direction = inside.stableNormalized();
  for (std::size_t i = 0; i < kGlobePoints; ++i) {
    const double weight = globeWeight((globeDirections()[i] - direction).norm());
    if (weight > 0.0) m_surface.setDent(i, m_surface.dent(i) + share * weight);
  }
  return true;
}

}  // namespace handwheel::test
