// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/SimulationLoop.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

SimulationLoop::SimulationLoop(std::unique_ptr<Simulation> simulation, double rate,
                               std::shared_ptr<SimulationInputs> inputs, ServoClock& clock, Service& service)
    : m_dt(1.0 / std::clamp(rate, kLeastRate, kLargestRate)),
      m_clock(clock),
      m_service(service),
      m_inputs(std::move(inputs)),
      m_simulation(std::move(simulation)),
      m_states(m_simulation->state()),
      m_dropped(m_inputs->dropped()) {
  m_arrived.reserve(m_inputs->capacity());
}

void SimulationLoop::start() {
  if (isRunning()) return;
  m_isStopping = false;
  m_thread = std::thread([this] { run(); });
}

void SimulationLoop::stop() {
  if (!isRunning()) return;
  m_isStopping = true;
  m_thread.join();
}

void SimulationLoop::runSteps(std::uint64_t count) {
  for (std::uint64_t i = 0; i < count; ++i) step();
}

// A mutex is not fair: a loop whose steps are late would take it again and again.
std::unique_lock<std::mutex> SimulationLoop::own() {
  m_isWanted = true;
  std::unique_lock lock(m_mutex);
  m_isWanted = false;
  return lock;
}

std::unique_ptr<Simulation> SimulationLoop::take() {
  const std::unique_lock lock = own();
  rethrow();  // also an exception thrown while this waited
  step();
  return std::move(m_simulation);
}

void SimulationLoop::replace(std::unique_ptr<Simulation> simulation) {
  const std::unique_lock lock = own();
  m_simulation.swap(simulation);
  m_hasFailed = false;
  m_states.write(m_simulation->state());
}

void SimulationLoop::look(const std::function<void(Simulation&)>& at) {
  const std::unique_lock lock = own();
  rethrow();
  at(*m_simulation);
}

void SimulationLoop::rethrow() const {
  if (m_hasFailed) std::rethrow_exception(m_failure);
}

void SimulationLoop::run() {
  const auto period = static_cast<std::int64_t>(std::llround(m_dt * kNanoseconds));
  std::int64_t due = m_clock.now() + period;
  while (!m_isStopping) {
    m_clock.waitUntil(due);
    if (!m_isWanted) attemptStep();
    due += period;
    const std::int64_t now = m_clock.now();
    if (now > due) {  // slower from here on
      m_service.countLost(static_cast<std::uint64_t>(now - due));
      due = now;
    }
  }
  attemptStep();
}

void SimulationLoop::attemptStep() {
  const std::lock_guard lock(m_mutex);
  try {
    step();
  } catch (...) {
    m_failure = std::current_exception();
    m_simulation.reset();
    m_hasFailed = true;
  }
}

void SimulationLoop::step() {
  const ServiceTick tick(m_service);
  m_arrived.clear();
  for (SimulationInput input; m_arrived.size() < m_inputs->capacity() && m_inputs->pop(input);) {
    // Read after the input: a gesture that the window begins during the step is known when its inputs arrive.
    if (input.gesture != m_gesture.load(std::memory_order_relaxed)) input.gesture = 0;
    m_arrived.push_back(input);
  }
  const std::uint64_t dropped = m_inputs->dropped();
  m_service.countDropped(dropped - std::exchange(m_dropped, dropped));
  m_steps.fetch_add(1, std::memory_order_relaxed);
  if (!m_simulation) return;
  m_simulation->step(m_dt, m_arrived);
  m_states.write(m_simulation->state());
}

}  // namespace handwheel
