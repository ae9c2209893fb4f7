// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/Clock.h"
#include "io/Session.h"
#include "spacemouse/HidTransport.h"
#include "spacemouse/Reports.h"

#include <functional>
#include <memory>

namespace handwheel::spacemouse {

// The time (s) without a report after which a displaced cap counts as released. A held cap sends a report every 16 ms,
// so after this time the report of its release must have been lost. In shorter gaps, which a disturbed radio link
// causes, the cap keeps its displacement.
inline constexpr double kHeld = 1.0;

// A session with a SpaceMouse through its HID reports. The lamp of the device is on while the session is open.
class HidSession final : public Session {
 public:
  using Connect = std::function<Result<std::unique_ptr<HidTransport>>()>;
  HidSession(Connect connect, std::shared_ptr<Clock> clock, int buttons)
      : m_connect(std::move(connect)), m_clock(std::move(clock)), m_buttons(buttons) {}

  DeviceCapabilities capabilities() const override { return capabilitiesWith(m_buttons); }
  Status open(Progress progress) override;
  DeviceState exchange(const DeviceForce& force) noexcept override;
  void close() noexcept override;

 private:
  void readReports() noexcept;
  void light(bool on) noexcept;

  Connect m_connect;
  std::shared_ptr<Clock> m_clock;
  int m_buttons;
  std::unique_ptr<HidTransport> m_transport;  // null: not open, or gone
  Reports m_reports;
  double m_lastMotion = 0.0;
};

}  // namespace handwheel::spacemouse
