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
  std::uint64_t number = 0;  // 0: no mapping was set, and the identity applies
  WorkspaceMapping mapping;
};

// The scene that the servo loop renders. It is created on the window thread, and passed to the loop as a whole.
struct HapticScene {
  std::unique_ptr<ForceRenderer> renderer;  // null: no forces, only the tip
  // True if the model, tool or snapping changes, so that the force returns by the ramp. False for an edit under the
  // tip.
  bool isDiscontinuous = true;
  // The mapping for which the stiffnesses of the scene were computed. The loop applies it no later than the scene. It
  // is set by ServoLoop.
  NumberedMapping mapping = {};
  // Sequence number of the scene in its loop, from 1. It is set by ServoLoop.
  std::uint64_t number = 0;
};

}  // namespace handwheel
