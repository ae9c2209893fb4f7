// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/drilling/DrillSimulation.h"

#include <memory>

namespace handwheel::test {

// Input and state of a drilling simulation in tests.
inline std::shared_ptr<const DrillState> stateOf(const DrillSimulation& simulation) {
  return std::static_pointer_cast<const DrillState>(simulation.state());
}

inline SimulationInput handAt(const Vec3& position, double time, std::uint32_t gesture) {
  SimulationInput input;
  input.tip.position = input.proxy = position;
  input.tip.time = time;
  input.gesture = gesture;
  return input;
}

}  // namespace handwheel::test
