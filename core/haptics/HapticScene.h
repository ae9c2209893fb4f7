// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/ForceSource.h"
#include "haptics/WorkspaceMapping.h"

#include <cstdint>
#include <memory>

namespace handwheel {

// Where the device lies in the scene, from the change of this number on.
struct NumberedMapping {
  std::uint64_t number = 0;  // 0: none was set, the identity holds
  WorkspaceMapping mapping;
};

// What the servo loop feels: made on the window thread, handed over whole.
struct HapticScene {
  std::unique_ptr<ForceSource> source;  // null: nothing to feel, only a tip
  // Another model, tool or snap: the force comes back by the ramp. False for an edit under the tip.
  bool mayLeap = true;
  // What its stiffnesses were made for: the loop takes it up in the same tick, if it has not yet. Set by ServoLoop.
  NumberedMapping mapping = {};
};

}  // namespace handwheel
