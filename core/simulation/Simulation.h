// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/SpscRing.h"
#include "base/TripleBuffer.h"
#include "haptics/servo/ForceRenderer.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>

namespace handwheel {

// One tick of the device tip, as input of a simulation.
struct SimulationInput {
  TipState tip;
  Vec3 proxy = Vec3::Zero();  // mm: where the tip is held by what it touches
  std::uint32_t gesture = 0;  // number of the gesture in which the hand acts; 0: it only moves
  bool isEnd = false;         // nothing more of the gesture follows; it is no place
  double pressure = 1.0;      // 0 to 1: of a pen, or of the hand by its force; 1 where it is not known
};

inline constexpr std::size_t kWaitingInputs = 4096;  // 4 s at 1 kHz

// Inputs on their way to a simulation: those of the device from the servo thread, those of the mouse from the window's.
// Neither waits; what does not fit is dropped.
//
// The button alone does not tell whether the hand acts: the window may have dropped the gesture while the button stays
// held, or not have begun one. So the window tells the servo thread in which gesture the device takes part.
class SimulationInputs {
 public:
  // capacity: of each of the two ways, rounded up to a power of two.
  explicit SimulationInputs(std::size_t capacity) : m_ofDevice(capacity), m_ofWindow(capacity) {}

  // Servo thread. The gesture in which the hand acts in this tick; once a tick. It acts from the first tick with button
  // 0 on, and no more after a tick without it, or one to which the tip did not come by moving.
  std::uint32_t gestureAt(const TipState& tip) noexcept;
  bool push(const SimulationInput& input) noexcept { return m_ofDevice.push(input); }  // servo thread
  // Window thread.
  bool pushFromWindow(const SimulationInput& input) noexcept { return m_ofWindow.push(input); }
  // The gesture in which the device takes part from now on, another one each time; 0: none.
  void setDeviceGesture(std::uint32_t gesture) noexcept { m_announced.store(gesture, std::memory_order_release); }

  // The thread of the simulation, or that which owns it while it does not run.
  bool pop(SimulationInput& input) noexcept { return m_ofDevice.pop(input) || m_ofWindow.pop(input); }

  std::size_t capacity() const { return m_ofDevice.capacity() + m_ofWindow.capacity(); }
  std::uint64_t dropped() const { return m_ofDevice.dropped() + m_ofWindow.dropped(); }  // any thread

 private:
  enum class Phase { Waiting, Acting, Over };

  SpscRing<SimulationInput> m_ofDevice;
  SpscRing<SimulationInput> m_ofWindow;
  std::atomic<std::uint32_t> m_announced{0};
  std::uint32_t m_gesture = 0;  // servo thread: the one that m_phase is of
  Phase m_phase = Phase::Over;  // servo thread
};

// What the servo loop and a simulation exchange. Neither waits. Patch: what the hand feels, near it.
template <class Patch>
struct SimulationChannel {
  std::shared_ptr<SimulationInputs> inputs = std::make_shared<SimulationInputs>(kWaitingInputs);  // from the servo loop
  TripleBuffer<Patch> patch;                                                                      // to the servo loop
  std::uint32_t simulations = 0;  // that have been made for it, on the thread that makes them
};

// The state of a simulation at one moment: immutable, shared between threads. Kinds derive theirs.
struct SimulationState {
  virtual ~SimulationState() = default;
};

// Base class of simulations that run while the hand works. Of a part on a lathe, clay, rigid bodies: they move or lose
// material. It advances in steps of fixed length. Any one thread at a time.
class Simulation {
 public:
  virtual ~Simulation() = default;

  // Advances by dt (s). inputs: the ticks since the step before, in order; those with a gesture are of the same one.
  // The state is a function of the sequence of these calls alone, bit for bit: no clock, no random numbers, no other
  // thread.
  virtual void step(double dt, std::span<const SimulationInput> inputs) = 0;

  // The present state; the same object as long as nothing has changed.
  virtual std::shared_ptr<const SimulationState> state() const = 0;
};

}  // namespace handwheel
