// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/TripleBuffer.h"
#include "io/Clock.h"
#include "io/Session.h"

#include <HD/hd.h>
#include <atomic>
#include <memory>
#include <string>

namespace handwheel::openhaptics {

// A session with a 3D Systems device through the HD API of OpenHaptics. The API calls back a thousand times a second,
// on a thread of its own. No other class uses the manufacturer's functions. Their frame is the one of this program: x
// to the right, y up, z towards the user; their units are mm, N and N·mm. Only one session may be open at a time.
class HdSession final : public Session {
 public:
  // name: the device's name in the manufacturer's set-up; "default": the manufacturer's choice.
  HdSession(std::string name, std::shared_ptr<Clock> clock) : m_name(std::move(name)), m_clock(std::move(clock)) {}
  ~HdSession() override { close(); }

  DeviceCapabilities capabilities() const override { return m_capabilities; }
  Status open(Progress progress) override;
  DeviceState exchange(const DeviceForce& force) noexcept override;
  void close() noexcept override;

 private:
  Error refusal(const HDErrorInfo& error) const;
  void askCapabilities();
  static HDCallbackCode HDCALLBACK tick(void* session) noexcept;
  void serve() noexcept;
  DeviceState read() noexcept;
  void write(const DeviceForce& force) noexcept;
  bool waitForTick(std::uint32_t before) noexcept;

  std::string m_name;
  std::shared_ptr<Clock> m_clock;
  DeviceCapabilities m_capabilities;
  Vec3 m_centre = Vec3::Zero();  // centre of its workspace, mm in the manufacturer's frame
  HHD m_device = HD_INVALID_HANDLE;
  HDSchedulerHandle m_callback = 0;
  HDenum m_calibrationStyle = 0;
  // Data that the thread of the API shares with the thread that calls exchange().
  struct TimedForce {
    DeviceForce force;
    double time = 0.0;  // s
  };
  TripleBuffer<DeviceState> m_states;
  TripleBuffer<TimedForce> m_forces;
  std::atomic<std::uint32_t> m_ticks{0};
  std::atomic<bool> m_canCalibrate{false};  // the device is where its calibration can be updated
  // Data that only the thread that calls exchange() uses.
  double m_lastTick = 0.0;
  DeviceState m_last;
};

}  // namespace handwheel::openhaptics
