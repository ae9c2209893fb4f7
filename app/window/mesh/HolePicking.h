// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Inspection.h"
#include "viewport/CameraState.h"

#include <optional>

namespace handwheel {

// The loop that one looks through at a place on the screen, so that a hole is picked by pointing into it, not only at
// its rim. onSight: any point on the line of sight. hit: where that line meets the surface, if it does; a loop must be
// nearer to the viewer. The smallest such loop, or -1. O(all loops).
int loopAround(const Inspection& inspection, const CameraState& camera, const Vec3& onSight,
               const std::optional<Vec3>& hit);

}  // namespace handwheel
