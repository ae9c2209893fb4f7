// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// Clock of the device protocols. Tests use their own clocks. Times are in seconds from an arbitrary origin, and never
// decrease.
class Clock {
 public:
  virtual ~Clock() = default;
  virtual double now() noexcept = 0;
  virtual void sleep(double seconds) noexcept = 0;
};

// Clock that uses the steady clock of the system.
class SteadyClock final : public Clock {
 public:
  double now() noexcept override;
  void sleep(double seconds) noexcept override;
};

}  // namespace handwheel
