// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "haptics/recording/Recording.h"

#include <iosfwd>

namespace handwheel {

// Writes a recording as comma-separated values, one line per tick after a header line. Columns: time, tip, proxy and
// force in the scene, contact, computing time; then buttons, the force sent in the frame of the device, the bits of the
// safety chain, the number of the tick, the orientation of the tip as a quaternion, the torques felt and sent, and
// events. mm, N, N·mm, s, us; numbers have the shortest form that reads back the same, independent of the locale.
// Errors: Cancelled, WriteFailed.
Status writeCsv(const Recording& recording, std::ostream& out, Progress progress = {});

}  // namespace handwheel
