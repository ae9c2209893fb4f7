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

inline constexpr std::size_t kWaitingInputs = 4096;  // 4 s at 1 kHz

// Inputs on their way to a simulation: those of the device from the servo thread, those of the mouse from the window's.
// Neither waits; what does not fit is dropped.
class SimulationInputs {
 public:
  // capacity: of each of the two ways, rounded up to a power of two.
  explicit SimulationInputs(std::size_t capacity) : m_ofDevice(capacity), m_ofWindow(capacity) {}

  bool push(const SimulationInput& input) noexcept { return m_ofDevice.push(input); }  // servo thread
  bool pushFromWindow(const SimulationInput& input) noexcept { return m_ofWindow.push(input); }
  // The thread of the simulation, or that which owns it while it does not run.
  bool pop(SimulationInput& input) noexcept { return m_ofDevice.pop(input) || m_ofWindow.pop(input); }

  std::size_t capacity() const { return m_ofDevice.capacity() + m_ofWindow.capacity(); }

 private:
  SpscRing<SimulationInput> m_ofDevice;
  SpscRing<SimulationInput> m_ofWindow;
};

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
