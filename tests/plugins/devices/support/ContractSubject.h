// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

#include <functional>
#include <memory>
#include <optional>

namespace handwheel {

// A device for the contract tests, with functions that disturb it. It communicates with an emulated device that is
// initially connected and in order.
struct ContractSubject {
  std::function<std::unique_ptr<Device>()> make;
  std::function<void()> unplug;
  std::function<void()> corrupt;  // makes the device send invalid answers from now on
  std::function<std::optional<Vec3>()>
      motorForce;  // returns the force of its motors, N, or nothing before the first command; null: no motors
};

}  // namespace handwheel
