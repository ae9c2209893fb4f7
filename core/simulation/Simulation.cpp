// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/Simulation.h"

namespace handwheel {

void replay(Simulation& simulation, const SimulationLog& log) {
  std::span<const SimulationInput> inputs(log.inputs);
  for (const std::uint32_t count : log.countPerStep) {
    simulation.step(log.dt, inputs.first(count));
    inputs = inputs.subspan(count);
  }
}

}  // namespace handwheel
