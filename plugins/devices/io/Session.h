// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

namespace handwheel {

// Interface of the protocol of one device, from connecting to disconnecting. Its functions must be called by one thread
// at a time. A session has no threads itself, so that a test can run it step by step on a transport and a clock of its
// own.
class Session {
 public:
  virtual ~Session() = default;
  virtual DeviceCapabilities capabilities() const = 0;
  virtual Status open(Progress progress) = 0;
  // Sends a force and returns the latest reading. Waits up to 20 ms for the device, normally until its next reading,
  // and so paces the calling thread. If no reading arrives, returns the previous one again with the same number; each
  // new reading of a device with motors has a different number. The status Absent means that the device is gone
  // permanently.
  virtual DeviceState exchange(const DeviceForce& force) noexcept = 0;
  // Sends zero force, if the device is still there, and disconnects.
  virtual void close() noexcept = 0;
};

}  // namespace handwheel
