// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "haptics/Recording.h"

#include <iosfwd>

namespace handwheel {

// Writes a recording as comma-separated values with a line of names, one line for each tick: time, tip, proxy and force
// in the scene, contact, cost; then buttons, the force sent in the frame of the device, the bits of the safety chain,
// the number of the tick, the orientation of the tip as a quaternion, the torques felt and sent, and what happened. mm,
// N, N·mm, s, us; numbers as short as they read back the same, whatever the
// locale. Errors: Cancelled, WriteFailed.
Status writeCsv(const Recording& recording, std::ostream& out, Progress progress = {});

}  // namespace handwheel
