// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/ForceSource.h"

#include <memory>

namespace handwheel {

// What the servo loop feels: made on the window thread, handed over whole.
struct HapticScene {
  std::unique_ptr<ForceSource> source;  // null: nothing to feel, only a tip
  // Another model, tool or snap: the force comes back by the ramp. False for an edit under the tip.
  bool mayLeap = true;
};

}  // namespace handwheel
