// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

#include <functional>
#include <memory>
#include <optional>

namespace handwheel {

// A device under the contract, with functions that disturb it. It runs on an emulated device that is connected and in
// order.
struct ContractSubject {
  std::function<std::unique_ptr<Device>()> make;
  std::function<void()> unplug;
  std::function<void()> corrupt;  // makes it answer nonsense from now on
  std::function<std::optional<Vec3>()>
      motorForce;  // N, the force of its motors; nothing before the first command. Null: no motors
};

}  // namespace handwheel
