// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/SimulationLoop.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

SimulationLoop::SimulationLoop(std::unique_ptr<Simulation> simulation, double rate,
                               std::shared_ptr<SimulationInputs> inputs, ServoClock& clock, Service& service)
    : m_simulation(std::move(simulation)),
      m_dt(1.0 / std::clamp(rate, kLeastRate, kLargestRate)),
      m_clock(clock),
      m_service(service),
      m_inputs(std::move(inputs)),
      m_states(m_simulation->state()) {
  m_arrived.reserve(m_inputs->capacity());
  m_log.dt = m_dt;
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

void SimulationLoop::run() {
  const auto period = static_cast<std::int64_t>(std::llround(m_dt * kNanoseconds));
  std::int64_t due = m_clock.now() + period;
  while (!m_isStopping) {
    m_clock.waitUntil(due);
    step();
    due += period;
    const std::int64_t now = m_clock.now();
    if (now > due) {  // slower from here on
      m_lost += now - due;
      due = now;
    }
  }
  step();
}

void SimulationLoop::step() {
  const ServiceTick tick(m_service);
  m_arrived.clear();
  for (SimulationInput input; m_arrived.size() < m_inputs->capacity() && m_inputs->pop(input);)
    m_arrived.push_back(input);
  m_simulation->step(m_dt, m_arrived);
  m_states.write(m_simulation->state());
  m_steps.fetch_add(1, std::memory_order_relaxed);
  if (!m_isLogComplete || m_log.inputs.size() + m_arrived.size() > kMostLogged) {
    m_isLogComplete = false;
    return;
  }
  m_log.inputs.insert(m_log.inputs.end(), m_arrived.begin(), m_arrived.end());
  m_log.countPerStep.push_back(static_cast<std::uint32_t>(m_arrived.size()));
}

}  // namespace handwheel
