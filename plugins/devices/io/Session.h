// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Device.h"

namespace handwheel {

// The protocol of one device, from connecting to leaving it. One thread at a time; it knows no threads itself, so that
// a test can drive it step by step on a transport and a clock of its own.
class Session {
 public:
  virtual ~Session() = default;
  virtual DeviceCapabilities capabilities() const = 0;
  virtual Status open(Progress progress) = 0;
  // Sends a force and returns the latest reading. Waits for the device 20 ms at most, and as long as it takes for the
  // next reading when all is well: this is what paces the thread that calls it. Where none came, the last once more
  // with the same number: of a device with motors each new one has another. Absent: the device is gone for good.
  virtual DeviceState exchange(const DeviceForce& force) noexcept = 0;
  // Sends zero force, if there is still somebody to send it to, and leaves the device.
  virtual void close() noexcept = 0;
};

}  // namespace handwheel
