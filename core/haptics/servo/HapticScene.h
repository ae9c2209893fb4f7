// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mapping/WorkspaceMapping.h"
#include "haptics/servo/ForceRenderer.h"

#include <cstdint>
#include <memory>

namespace handwheel {

// A workspace mapping with its sequence number.
struct NumberedMapping {
  std::uint64_t number = 0;  // 0: none was set, the identity applies
  WorkspaceMapping mapping;
};

// The scene that the servo loop renders. Created on the window thread, and handed over as a whole.
struct HapticScene {
  std::unique_ptr<ForceRenderer> renderer;  // null: no forces, only a tip
  // True for another model, tool or snap: the force returns by the ramp. False for an edit under the tip.
  bool isDiscontinuous = true;
  // The mapping that its stiffnesses were computed for. The loop applies it in the same tick, if it has not yet. Set by
  // ServoLoop.
  NumberedMapping mapping = {};
  // Sequence number of the scene in its loop, from 1. Set by ServoLoop.
  std::uint64_t number = 0;
};

}  // namespace handwheel
