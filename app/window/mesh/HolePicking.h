// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/defects/DefectList.h"
#include "viewport/camera/CameraState.h"

#include <optional>

namespace handwheel {

// Finds the boundary loop that surrounds a screen position. It lets the user pick a hole by pointing into the hole, not
// only at the rim. onSight: any point on the pick ray. hit: the intersection of the ray with the surface, if there is
// one; a loop must be nearer to the viewer. Returns the smallest loop that surrounds the position, or -1 if there is
// none. O(all loops).
int loopAround(const DefectList& defectList, const CameraState& camera, const Vec3& onSight,
               const std::optional<Vec3>& hit);

}  // namespace handwheel
