// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "globe/simulation/GlobeForce.h"

namespace handwheel::test {

// A globe at one moment of the simulation.
struct DentState : SimulationState {
  explicit DentState(GlobeSurface s, bool changed = false) : surface(std::move(s)), isChanged(changed) {}
  GlobeSurface surface;
  bool isChanged;  // true if the surface was changed since the simulation began
};

// Simulates dents in a globe. During a gesture, the surface near the tip yields until it reaches the tip.
class DentSimulation : public Simulation {
 public:
  static constexpr double kYield = 0.05;  // s, time in which the depth of the tip falls to 1/e

  // pose: the pose of the globe in the scene.
  DentSimulation(GlobeSurface surface, const Pose& pose, std::shared_ptr<DentChannel> channel);

  void step(double dt, std::span<const SimulationInput> inputs) override;
  std::shared_ptr<const SimulationState> state() const override { return m_state; }

 private:
  bool press(const TipState& tip);

  GlobeSurface m_surface;
  Pose m_sceneToGlobe;
  std::shared_ptr<DentChannel> m_channel;
  std::shared_ptr<const DentState> m_state;
};

}  // namespace handwheel::test
