// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "HdStandIn.h"
#include "guard/GuardedSubject.h"
#include "openhaptics/Driver.h"
#include "openhaptics/HdSession.h"

namespace handwheel {

// Returns the complete chain of an OpenHaptics device for tests. The chain consists of the plugin's session, a host,
// the bridge's session, and the stand-in for the manufacturer's library.
inline ContractSubject hdSubject() {
  HdStandIn& device = HdStandIn::only();
  device.reset();
  const auto host = std::make_shared<HostedSession>([] {
    return std::make_unique<openhaptics::HdSession>(openhaptics::kDefaultDevice, std::make_shared<SteadyClock>());
  });
  ContractSubject subject;
  subject.unplug = [host, &device] {
    {
      const std::lock_guard lock(device.mutex);
      device.isPlugged = false;
    }
    host->stop();  // the manufacturer's library does not recover when the device is unplugged: the process ends
  };
  subject.corrupt = [&device] {
    const std::lock_guard lock(device.mutex);
    device.saysNonsense = true;
  };
  subject.motorForce = [&device]() -> std::optional<Vec3> {
    const std::lock_guard lock(device.mutex);
    return device.force;
  };
  return guardedSubject(host, openhaptics::touchCapabilities(), subject);
}

}  // namespace handwheel
