// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/SpscRing.h"
#include "haptics/servo/ForceRenderer.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace handwheel {

// One tick of the device tip, as input of a simulation.
struct SimulationInput {
  TipState tip;
  Vec3 proxy = Vec3::Zero();  // mm: where the tip is held by what it touches
};

// Inputs on their way to a simulation.
using SimulationInputs = SpscRing<SimulationInput>;
inline constexpr std::size_t kWaitingInputs = 4096;  // 4 s at 1 kHz

// The state of a simulation at one moment: immutable, shared between threads. Kinds derive theirs.
struct SimulationState {
  virtual ~SimulationState() = default;
};

// Base class of what moves or loses material while the hand works: a part on a lathe, clay, rigid bodies. It advances
// in steps of fixed length. Any one thread at a time.
class Simulation {
 public:
  virtual ~Simulation() = default;

  // Advances by dt (s). inputs: the ticks since the step before, in order. The state is a function of the sequence of
  // these calls alone, bit for bit: no clock, no random numbers, no other thread.
  virtual void step(double dt, std::span<const SimulationInput> inputs) = 0;

  // The present state; the same object as long as nothing has changed.
  virtual std::shared_ptr<const SimulationState> state() const = 0;
};

// What the steps of a simulation consumed: enough to do them again.
struct SimulationLog {
  double dt = 0.0;                          // s
  std::vector<SimulationInput> inputs;      // in order
  std::vector<std::uint32_t> countPerStep;  // inputs that each step consumed
};

// Repeats the steps of a log. A simulation in the state in which the recorded one began ends in the same state.
void replay(Simulation& simulation, const SimulationLog& log);

}  // namespace handwheel
