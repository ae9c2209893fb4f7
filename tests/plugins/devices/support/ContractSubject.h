// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

#include <functional>
#include <memory>
#include <optional>

namespace handwheel {

// A device under the contract, with the hand on its plug. It stands on an emulated device that is there and well.
struct ContractSubject {
  std::function<std::unique_ptr<Device>()> make;
  std::function<void()> unplug;
  std::function<void()> corrupt;  // from now on it answers nonsense
  std::function<std::optional<Vec3>()>
      motorForce;  // N, what its motors hold; nothing before the first command. Null: no motors
};

}  // namespace handwheel
