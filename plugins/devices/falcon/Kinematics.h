// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <array>
#include <optional>

namespace handwheel::falcon {

// The delta mechanism of the Falcon after Stamper (PhD 97-4, University of Maryland, 1997). Metres and radians, in the
// mechanism's own frame: the origin in the plane of the motors, z towards the user. Angles are those of the three arms.
using Angles = std::array<double, 3>;
using Counts = std::array<int, 3>;  // of the encoders, from where homing puts zero

Angles anglesOf(const Counts& counts);

// The angles that reach a point; nothing when it is out of reach.
std::optional<Angles> inverse(const Vec3& point);

// Row i is the gradient of arm i's angle, rad/m. At a point in reach.
Eigen::Matrix3d jacobian(const Vec3& point);

// The point that the angles reach, by Newton's method from a guess to 1e-12 rad; nothing when it does not come near, as
// it may for angles that the mechanism cannot take.
std::optional<Vec3> forward(const Angles& angles, const Vec3& guess);

inline const Vec3 kHome{0.0, 0.0, 0.12};      // m, a guess from which every reachable point is found
inline const Vec3 kCentre{0.0, 0.0, 0.1346};  // m, where the encoders are zero; the origin of what the servo loop sees

// Torques (N·m) of the motors' arms that push with this force (N): J^-T F, by virtual work.
Vec3 torques(const Vec3& force, const Vec3& point);

inline constexpr int kMostTorque = 4096;           // counts
inline constexpr double kCountsPerTorque = -10e3;  // per N·m, as libnifalcon has it; not calibrated

// In counts. Where one is over the most, all three shrink together, so that the direction of the force stays. Zero for
// torques that are not finite.
Counts torqueCounts(const Vec3& torque);

}  // namespace handwheel::falcon
