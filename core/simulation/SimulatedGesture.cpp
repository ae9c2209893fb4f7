// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/SimulatedGesture.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace handwheel {

SimulatedGesture::SimulatedGesture(const SimulationServices& services, std::shared_ptr<SimulationInputs> inputs,
                                   double rate, Make make)
    : m_clock(services.clock),
      m_inputs(std::move(inputs)),
      m_make(std::move(make)),
      m_loop(m_make(), rate, m_inputs, services.clock, services.service) {
  m_loop.start();
}

void SimulatedGesture::begin(bool isOfDevice) {
  assert(!m_isOn);
  m_isOn = m_isFirst = true;
  m_isOfDevice = isOfDevice;
  m_loop.setGesture(++m_number);
  if (isOfDevice) m_inputs->setDeviceGesture(m_number);
}

void SimulatedGesture::feed(const Vec3& position, std::optional<double> time, double period, double pressure) {
  if (m_isFirst) m_time = time;
  if (m_time) m_time = std::max(*m_time, time.value_or(*m_time));  // one clock for all of a gesture
  SimulationInput input;
  input.tip.position = input.proxy = position;
  input.tip.buttons = 1u;
  input.tip.isRestart = std::exchange(m_isFirst, false);
  input.tip.time = m_time.value_or(static_cast<double>(m_clock.now()) / kNanoseconds);
  input.tip.period = period;
  input.gesture = m_number;
  input.pressure = pressure;
  m_inputs->pushFromWindow(input);
}

bool SimulatedGesture::close() {
  m_inputs->setDeviceGesture(0);
  SimulationInput input;
  input.gesture = m_number;
  input.isEnd = true;
  return m_inputs->pushFromWindow(input);
}

std::unique_ptr<Simulation> SimulatedGesture::end() {
  std::unique_ptr<Simulation> ended = m_loop.take();
  disarm();
  return ended;
}

void SimulatedGesture::restart() {
  disarm();
  m_loop.replace(m_make());
}

void SimulatedGesture::disarm() {
  m_isOn = false;
  m_inputs->setDeviceGesture(0);
  m_loop.setGesture(0);
}

}  // namespace handwheel
