// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/defects/DefectList.h"
#include "viewport/camera/CameraState.h"

#include <optional>

namespace handwheel {

// Finds the boundary loop that surrounds a screen position. With it, a hole is picked by pointing into it, not only at
// its rim. onSight: any point on the pick ray. hit: the intersection of the ray with the surface, if there is one; a
// loop must be nearer to the viewer. Returns the smallest such loop, or -1. O(all loops).
int loopAround(const DefectList& defectList, const CameraState& camera, const Vec3& onSight,
               const std::optional<Vec3>& hit);

}  // namespace handwheel
