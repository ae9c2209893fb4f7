// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"
#include "base/TripleBuffer.h"
#include "haptics/device/ServoClock.h"
#include "simulation/Simulation.h"

#include <atomic>
#include <thread>

namespace handwheel {

// Runs a simulation in steps of fixed length on its own thread, between the servo loop and the window. Inputs come
// through rings and states go out through a triple buffer, so neither side ever waits.
//
// The clock of the simulation slows down when a step takes longer than its time or the machine stalls: late steps are
// not made up for in a burst. The next step then gets all inputs that have arrived, so nothing that the hand did is
// lost, and lostTime() says by how much the simulation is behind.
//
// Unless stated otherwise, functions are called on the thread that owns it, the window's.
class SimulationLoop {
 public:
  static constexpr double kLeastRate = 30.0, kLargestRate = 1000.0;  // steps a second
  // Inputs that the log keeps, some 15 minutes at 1 kHz. What comes later is simulated, but not in the log.
  static constexpr std::size_t kMostLogged = 1'000'000;

  // rate: steps a second, kept within the limits above. inputs: may outlive the loop and be taken over by a next one.
  // The clock and the service outlive the loop; the service counts steps and their CPU time.
  SimulationLoop(std::unique_ptr<Simulation> simulation, double rate, std::shared_ptr<SimulationInputs> inputs,
                 ServoClock& clock, Service& service);
  ~SimulationLoop() { stop(); }
  SimulationLoop(const SimulationLoop&) = delete;
  SimulationLoop& operator=(const SimulationLoop&) = delete;

  void start();
  // Ends the thread after a last step with the inputs that have arrived.
  void stop();
  bool isRunning() const { return m_thread.joinable(); }
  // Runs steps on the calling thread instead: for tests and the command line.
  void runSteps(std::uint64_t count);

  // The state after the last finished step; never null.
  std::shared_ptr<const SimulationState> state() { return m_states.read(); }

  double dt() const { return m_dt; }  // s
  // Any thread.
  std::uint64_t steps() const { return m_steps.load(std::memory_order_relaxed); }
  double lostTime() const { return 1e-9 * static_cast<double>(m_lost.load(std::memory_order_relaxed)); }  // s

  // While the loop is stopped. The log has what was simulated since keepLog(), which is called before start().
  void keepLog() { m_isLogComplete = true; }
  const Simulation& simulation() const { return *m_simulation; }
  const SimulationLog& log() const { return m_log; }
  bool isLogComplete() const { return m_isLogComplete; }

 private:
  void run();
  void step();

  const std::unique_ptr<Simulation> m_simulation;
  const double m_dt;
  ServoClock& m_clock;
  Service& m_service;
  const std::shared_ptr<SimulationInputs> m_inputs;
  TripleBuffer<std::shared_ptr<const SimulationState>> m_states;
  std::vector<SimulationInput> m_arrived;
  SimulationLog m_log;
  bool m_isLogComplete = false;
  std::atomic<std::uint64_t> m_steps{0};
  std::atomic<std::int64_t> m_lost{0};  // ns
  std::atomic<bool> m_isStopping{false};
  std::thread m_thread;
};

}  // namespace handwheel
