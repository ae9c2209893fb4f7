// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"
#include "base/TripleBuffer.h"
#include "haptics/device/ServoClock.h"
#include "simulation/Simulation.h"

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace handwheel {

// Runs simulations with a fixed time step on its own thread. The loop mediates between the servo loop and the window.
// Inputs come through lock-free ring buffers and states go out through a triple buffer, so that the servo loop and the
// window do not wait; only exchanging the simulation waits for a step in progress.
//
// The clock of the simulation slows down when a step takes longer than its time or the machine stalls: late steps are
// not made up for in a burst. The next step then gets all inputs that have arrived. The service counts the lost time
// and the dropped inputs.
//
// Unless stated otherwise, functions must be called on the thread that owns the loop. This is the window thread.
class SimulationLoop {
 public:
  static constexpr double kLeastRate = 30.0, kLargestRate = 1000.0;  // steps a second

  // rate: the number of steps a second, clamped to the limits. inputs: the inputs, which may outlive the loop and be
  // reused by the next loop. The clock and the service must outlive the loop; the service counts steps and their CPU
  // time.
  SimulationLoop(std::unique_ptr<Simulation> simulation, double rate, std::shared_ptr<SimulationInputs> inputs,
                 ServoClock& clock, Service& service);
  ~SimulationLoop() { stop(); }
  SimulationLoop(const SimulationLoop&) = delete;
  SimulationLoop& operator=(const SimulationLoop&) = delete;

  void start();
  // Ends the thread after a last step with the inputs that have arrived.
  void stop();
  bool isRunning() const { return m_thread.joinable(); }
  // Runs steps on the calling thread, for tests and the command line.
  void runSteps(std::uint64_t count);

  // Sets the number of the present gesture. Inputs of other gestures only move the hand.
  void setGesture(std::uint32_t gesture) { m_gesture.store(gesture, std::memory_order_relaxed); }
  // Takes the simulation out, after a last step with the inputs that have arrived. No simulation runs until replace()
  // is called. Throws the exception of a step.
  std::unique_ptr<Simulation> take();
  // Runs another simulation from the next step on. state() returns its state at once.
  void replace(std::unique_ptr<Simulation> simulation);
  // Calls a function on the simulation between two steps. Throws the exception of a step.
  void look(const std::function<void(Simulation&)>& at);
  // Rethrows the exception of a step on the loop's thread, if there is one. Such an exception ends the simulation.
  void rethrow() const;

  // Returns the state after the last finished step; never null.
  std::shared_ptr<const SimulationState> state() { return m_states.read(); }

  double dt() const { return m_dt; }                                               // s
  std::uint64_t steps() const { return m_steps.load(std::memory_order_relaxed); }  // may be called on any thread

 private:
  std::unique_lock<std::mutex> own();
  void run();
  void attemptStep();
  void step();

  const double m_dt;
  ServoClock& m_clock;
  Service& m_service;
  const std::shared_ptr<SimulationInputs> m_inputs;
  std::mutex m_mutex;                        // guards the members up to m_failure
  std::unique_ptr<Simulation> m_simulation;  // null: none runs
  TripleBuffer<std::shared_ptr<const SimulationState>> m_states;
  std::vector<SimulationInput> m_arrived;
  std::uint64_t m_dropped;               // inputs counted as dropped
  std::exception_ptr m_failure;          // exception of a step on the loop's thread
  std::atomic<bool> m_hasFailed{false};  // m_failure can be read
  std::atomic<bool> m_isWanted{false};   // the owner wants the mutex
  std::atomic<std::uint32_t> m_gesture{0};
  std::atomic<std::uint64_t> m_steps{0};
  std::atomic<bool> m_isStopping{false};
  std::thread m_thread;
};

}  // namespace handwheel
