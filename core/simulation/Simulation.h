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

// The input of a simulation from one tick of the device tip.
struct SimulationInput {
  TipState tip;
  Vec3 proxy = Vec3::Zero();  // mm, position at which contact holds the tip
  std::uint32_t gesture = 0;  // number of the active gesture; 0: the hand only moves
  bool isEnd = false;         // true: end of the gesture, without a position
  double pressure = 1.0;      // 0 to 1: pressure of a pen, or of the hand by its force; 1: not known
};

inline constexpr std::size_t kWaitingInputs = 4096;  // 4 s at 1 kHz

// The queues of inputs of a simulation: those of the device from the servo thread, those of the mouse from the
// window's. Neither waits; inputs that do not fit are dropped.
//
// The button alone does not tell whether the hand acts: the window may have dropped the gesture while the button stays
// held, or not have begun one. So the window tells the servo thread which gesture the device takes part in.
class SimulationInputs {
 public:
  // capacity: capacity of each of the two queues, rounded up to a power of two.
  explicit SimulationInputs(std::size_t capacity) : m_ofDevice(capacity), m_ofWindow(capacity) {}

  // Servo thread. Returns the gesture in which the hand acts in this tick; to be called once a tick. It acts from the
  // first tick with button 0 on, until a tick without it or one that restarts the tip.
  std::uint32_t gestureAt(const TipState& tip) noexcept;
  bool push(const SimulationInput& input) noexcept { return m_ofDevice.push(input); }  // servo thread
  // Window thread.
  bool pushFromWindow(const SimulationInput& input) noexcept { return m_ofWindow.push(input); }
  // Sets the gesture in which the device takes part, another number each time; 0: none.
  void setDeviceGesture(std::uint32_t gesture) noexcept { m_announced.store(gesture, std::memory_order_release); }

  // Called on the thread of the simulation, or the one that owns it while it does not run.
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

// The data exchanged between the servo loop and a simulation. Neither waits. Patch: the material near the hand.
template <class Patch>
struct SimulationChannel {
  std::shared_ptr<SimulationInputs> inputs = std::make_shared<SimulationInputs>(kWaitingInputs);  // from the servo loop
  TripleBuffer<Patch> patch;                                                                      // to the servo loop
  std::uint32_t simulations = 0;  // number of simulations made for the channel so far, on the thread that makes them
};

// The state of a simulation at one moment: immutable, shared between threads. Kinds derive theirs.
struct SimulationState {
  virtual ~SimulationState() = default;
};

// Base class of simulations that run while the hand works. They move or remove material: a part on a lathe, clay, rigid
// bodies. Time advances in steps of fixed length. Any one thread at a time.
class Simulation {
 public:
  virtual ~Simulation() = default;

  // Advances by dt (s). inputs: the ticks since the previous step, in order; those with a gesture all have the same
  // one. The state is a function of the sequence of these calls alone, bit for bit: no clock, no random numbers, no
  // other thread.
  virtual void step(double dt, std::span<const SimulationInput> inputs) = 0;

  // Returns the present state; the same object until something changes.
  virtual std::shared_ptr<const SimulationState> state() const = 0;
};

}  // namespace handwheel
