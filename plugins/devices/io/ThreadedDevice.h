// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/TripleBuffer.h"
#include "io/Session.h"

#include <atomic>
#include <memory>
#include <thread>

namespace handwheel {

// Device that runs its session on a thread of its own. The session may therefore wait, allocate and parse; the servo
// thread only exchanges the newest reading and force with it, without locks. The cost is a delay of about one exchange,
// which the session states in its capabilities. Readings are always finite, and no force outlives a servo loop that has
// stopped.
class ThreadedDevice final : public Device {
 public:
  explicit ThreadedDevice(std::unique_ptr<Session> session);
  ~ThreadedDevice() override;

  DeviceCapabilities capabilities() const override { return m_session->capabilities(); }
  Status open(Progress progress) override;
  void close() noexcept override;
  DeviceState read() noexcept override;
  void write(const DeviceForce& force) noexcept override;

 private:
  void run() noexcept;
  DeviceForce forceNow() noexcept;

  std::unique_ptr<Session> m_session;
  TripleBuffer<DeviceState> m_states;
  TripleBuffer<DeviceForce> m_forces;
  std::atomic<std::int64_t> m_writtenAt{0};  // ns of the steady clock
  std::atomic<bool> m_stop{false};
  std::atomic<bool> m_open{false};
  std::thread m_thread;
};

}  // namespace handwheel
