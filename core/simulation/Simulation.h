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

// The input of a simulation: one sample of the device tip or the mouse.
struct SimulationInput {
  TipState tip;
  Vec3 proxy = Vec3::Zero();  // mm, position at which contact holds the tip
  std::uint32_t gesture = 0;  // number of the active gesture; 0: the hand only moves
  bool isEnd = false;         // true: end of the gesture, without a position
  double pressure = 1.0;      // 0 to 1: pressure of a pen, or of the hand, from its force; 1: unknown
};

inline constexpr std::size_t kWaitingInputs = 4096;  // 4 s at 1 kHz

// The queues of the inputs of a simulation: those of the device come from the servo thread, those of the mouse from the
// window thread. Neither thread waits; inputs that do not fit are dropped.
//
// The button alone does not tell whether the hand acts: the window may have dropped the gesture while the button stays
// held, or not have begun one. So the window tells the servo thread which gesture the device takes part in.
class SimulationInputs {
 public:
  // capacity: capacity of each of the two queues, rounded up to a power of two.
  explicit SimulationInputs(std::size_t capacity) : m_ofDevice(capacity), m_ofWindow(capacity) {}

  // Returns the gesture in which the hand acts in this tick; 0: none. Must be called on the servo thread, once a tick.
  // The hand acts from the first tick in which button 0 is held, until the button is released or the tip restarts
  // (TipState::isRestart).
  std::uint32_t gestureAt(const TipState& tip) noexcept;
  bool push(const SimulationInput& input) noexcept { return m_ofDevice.push(input); }  // servo thread
  // Adds an input of the mouse, on the window thread; returns false if it was dropped.
  bool pushFromWindow(const SimulationInput& input) noexcept { return m_ofWindow.push(input); }
  // Sets the gesture in which the device takes part, on the window thread; 0: none. Each gesture needs a number of its
  // own.
  void setDeviceGesture(std::uint32_t gesture) noexcept { m_announced.store(gesture, std::memory_order_release); }

  // Takes the next input; returns false if there is none. Must be called on the thread of the simulation or, while it
  // does not run, on the one that owns it.
  bool pop(SimulationInput& input) noexcept { return m_ofDevice.pop(input) || m_ofWindow.pop(input); }

  std::size_t capacity() const { return m_ofDevice.capacity() + m_ofWindow.capacity(); }
  std::uint64_t dropped() const { return m_ofDevice.dropped() + m_ofWindow.dropped(); }  // any thread

 private:
  enum class Phase { Waiting, Acting, Over };

  SpscRing<SimulationInput> m_ofDevice;
  SpscRing<SimulationInput> m_ofWindow;
  std::atomic<std::uint32_t> m_announced{0};
  std::uint32_t m_gesture = 0;  // servo thread: the gesture that m_phase refers to
  Phase m_phase = Phase::Over;  // servo thread
};

// The data exchanged between the servo loop and a simulation. Neither of them waits for the other. Patch: the material
// near the hand.
template <class Patch>
struct SimulationChannel {
  std::shared_ptr<SimulationInputs> inputs = std::make_shared<SimulationInputs>(kWaitingInputs);  // from the servo loop
  TripleBuffer<Patch> patch;                                                                      // to the servo loop
  std::uint32_t simulations = 0;  // number of simulations made so far; used only by the thread that makes them
};

// The state of a simulation at one moment: immutable, shared between threads. Each kind of simulation derives a class
// of its own.
struct SimulationState {
  virtual ~SimulationState() = default;
};

// Base class of simulations that run while the hand works. They move or remove material: a part on a lathe, clay, rigid
// bodies. Time advances in steps of fixed length. A simulation may be used on any thread, but by one at a time.
class Simulation {
 public:
  virtual ~Simulation() = default;

  // Advances by dt (s). inputs: the ticks since the previous step, in order; those with a gesture all have the same
  // one. The state depends only on the sequence of these calls, bit for bit: not on a clock, random numbers or other
  // threads.
  virtual void step(double dt, std::span<const SimulationInput> inputs) = 0;

  // Returns the present state; the same object until something changes.
  virtual std::shared_ptr<const SimulationState> state() const = 0;
};

}  // namespace handwheel
