// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/servo/ServoLoop.h"

#include <cassert>
#include <cmath>

namespace handwheel {

ServoLoop::ServoLoop(std::unique_ptr<Device> device, const ServoSettings& settings, ServoClock& clock, Service& service)
    : m_device(std::move(device)),
      m_clock(clock),
      m_service(service),
      m_channel(std::make_unique<ServoChannel>(settings.samples)),
      m_tick(std::make_unique<ServoTick>(*m_device, settings, clock, *m_channel)),
      m_priority(settings.priority),
      m_period(std::llround(m_tick->nominalPeriod() * kNanoseconds)),
      m_due(clock.now()) {}

ServoLoop::~ServoLoop() {
  stop();
  m_device->close();
}

void ServoLoop::start() {
  assert(!isRunning());
  m_isStopping.store(false, std::memory_order_relaxed);
  m_thread = std::thread([this] { run(); });
}

void ServoLoop::stop() {
  if (!isRunning()) return;
  m_isStopping.store(true, std::memory_order_relaxed);
  m_thread.join();
  m_realTime.store(RealTimeState::NotRunning, std::memory_order_relaxed);
}

void ServoLoop::setSettings(const ServoSettings& settings) {
  assert(!isRunning());
  auto tick = std::make_unique<ServoTick>(*m_device, settings, m_clock, *m_channel);
  tick->resumeFrom(*m_tick);
  m_tick = std::move(tick);
  m_priority = settings.priority;
  m_period = std::llround(m_tick->nominalPeriod() * kNanoseconds);
}

void ServoLoop::runTicks(std::uint64_t count) {
  assert(!isRunning());
  for (std::uint64_t i = 0; i < count; ++i) cycle();
}

void ServoLoop::run() {
  m_realTime.store(makeThreadRealTime(m_priority), std::memory_order_relaxed);
  m_due = m_clock.now() + m_period;
  while (!m_isStopping.load(std::memory_order_relaxed)) cycle();
  rest();
}

void ServoLoop::cycle() noexcept {
  m_clock.waitUntil(m_due);
  const std::int64_t now = m_clock.now();
  m_tick->measure().addLateness(static_cast<double>(now - m_due) / kNanoseconds);
  m_tick->run(now);
  const std::int64_t end = m_clock.now();
  m_service.countTick(end > now ? static_cast<std::uint64_t>(end - now) : 0);
  m_due = dueAfter(m_due, end);
}

std::int64_t ServoLoop::dueAfter(std::int64_t due, std::int64_t now) {
  const std::int64_t next = due + m_period;
  if (next > now + 2 * m_period) return now + m_period;  // the clock has gone back
  if (next > now) return next;
  const std::int64_t missed = (now - next) / m_period + 1;
  m_missed.fetch_add(static_cast<std::uint64_t>(missed), std::memory_order_relaxed);
  return next + missed * m_period;
}

void ServoLoop::rest() noexcept {
  m_device->write({});
  m_tick->pause();
}

}  // namespace handwheel
