// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <optional>

namespace handwheel {

// The largest absolute coordinate of the position of a body, mm.
inline constexpr double kFarthestBody = 1e7;

// Returns true if a pose is a rigid motion within kFarthestBody. It must be finite, orthonormal up to rounding, and not
// mirrored.
bool isRigid(const Pose& pose);

// Returns the same position with the nearest rotation (polar decomposition), for poses that were written in few digits.
// Returns nothing if the pose is too far from rigid: not finite, out of bounds, flat, mirrored, or scaled by more than
// a thousandth.
std::optional<Pose> nearestRigid(const Pose& pose);

// Returns roll, pitch and yaw of a pose: its rotation is Rz(yaw) Ry(pitch) Rx(roll), as in URDF; rad. Roll and yaw lie
// in -π…π, the pitch in -π/2…π/2. At the ends of the range of pitch only the sum or difference of roll and yaw is
// determined, and yaw is 0.
Vec3 rollPitchYaw(const Pose& pose);
// Returns the pose with this position and these angles (rad).
Pose poseOf(const Vec3& position, const Vec3& rollPitchYaw);

}  // namespace handwheel
