// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ThreadedDevice.h"

#include <pthread.h>
#include <sched.h>
#include <chrono>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::int64_t kForceLife = 50'000'000;  // ns after the last write; a servo loop that is well writes each ms
constexpr int kDevicePriority = 10;              // SCHED_FIFO priority, low among real-time threads

std::int64_t nanoseconds() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

bool isFinite(const DeviceState& state) {
  return state.position.allFinite() && state.velocity.allFinite() && state.orientation.coeffs().allFinite() &&
         std::isfinite(state.gripper);
}

bool isFinite(const DeviceForce& force) {
  return force.force.allFinite() && force.torque.allFinite() && std::isfinite(force.gripper);
}

// A device with motors is served in time if the system allows it. Otherwise the servo loop measures the cost.
void askForPriority() {
  sched_param parameters{};
  parameters.sched_priority = kDevicePriority;
  (void)::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &parameters);
}

}  // namespace

ThreadedDevice::ThreadedDevice(std::unique_ptr<Session> session) : m_session(std::move(session)) {}

ThreadedDevice::~ThreadedDevice() {
  close();
}

Status ThreadedDevice::open(Progress progress) {
  close();
  const Status opened = m_session->open(progress);
  if (!opened) {
    m_session->close();
    return opened;
  }
  DeviceState starting;
  starting.status = DeviceStatus::Starting;
  m_states.write(starting);
  m_forces.write({});
  m_stop = false;
  m_open = true;
  m_thread = std::thread([this] { run(); });
  return Done{};
}

void ThreadedDevice::close() noexcept {
  m_open = false;
  m_stop = true;
  if (m_thread.joinable()) m_thread.join();
}

DeviceState ThreadedDevice::read() noexcept {
  return m_open.load(std::memory_order_relaxed) ? m_states.read() : DeviceState();
}

void ThreadedDevice::write(const DeviceForce& force) noexcept {
  m_forces.write(isFinite(force) ? force : DeviceForce());
  m_writtenAt.store(nanoseconds(), std::memory_order_release);
}

DeviceForce ThreadedDevice::forceNow() noexcept {
  const DeviceForce& newest = m_forces.read();
  return nanoseconds() - m_writtenAt.load(std::memory_order_acquire) > kForceLife ? DeviceForce() : newest;
}

void ThreadedDevice::run() noexcept {
  if (m_session->capabilities().outputs > 0) askForPriority();
  DeviceState last;
  while (!m_stop.load(std::memory_order_relaxed)) {
    DeviceState state = m_session->exchange(forceNow());
    if (!isFinite(state)) {  // it keeps its last position, and its controller sees the fault
      state = last;
      state.velocity.setZero();
      state.status = DeviceStatus::Failed;
    }
    m_states.write(state);
    if (state.status == DeviceStatus::Absent) break;
    last = state;
  }
  m_session->close();
}

}  // namespace handwheel
