// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/Simulation.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace handwheel::test {

// The inputs of the steps of a simulation, so that the steps can be repeated.
struct SimulationLog {
  double dt = 0.0;                          // s
  std::vector<SimulationInput> inputs;      // in the order of use
  std::vector<std::uint32_t> countPerStep;  // inputs that each step consumed
};

// Repeats the steps of a log. A simulation that starts in the same state as the recorded one ends in the same state,
// too.
inline void replay(Simulation& simulation, const SimulationLog& log) {
  std::span<const SimulationInput> inputs(log.inputs);
  for (const std::uint32_t count : log.countPerStep) {
    simulation.step(log.dt, inputs.first(count));
    inputs = inputs.subspan(count);
  }
}

// A simulation that logs its steps. The log must not be read while a loop runs the simulation.
class LoggedSimulation : public Simulation {
 public:
  explicit LoggedSimulation(std::unique_ptr<Simulation> logged) : m_logged(std::move(logged)) {}

  void step(double dt, std::span<const SimulationInput> inputs) override {
    m_log.dt = dt;
    m_log.inputs.insert(m_log.inputs.end(), inputs.begin(), inputs.end());
    m_log.countPerStep.push_back(static_cast<std::uint32_t>(inputs.size()));
    m_logged->step(dt, inputs);
  }
  std::shared_ptr<const SimulationState> state() const override { return m_logged->state(); }

  const Simulation& logged() const { return *m_logged; }
  const SimulationLog& log() const { return m_log; }

 private:
  std::unique_ptr<Simulation> m_logged;
  SimulationLog m_log;
};

}  // namespace handwheel::test
