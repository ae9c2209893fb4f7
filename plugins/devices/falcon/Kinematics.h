// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <array>
#include <optional>

namespace handwheel::falcon {

// Kinematics of the Falcon's delta mechanism after Stamper (PhD 97-4, University of Maryland, 1997). Lengths are in m;
// angles are those of the three arms, in radians. The frame is the mechanism's own: its origin is in the plane of the
// motors, and z points towards the user.
using Angles = std::array<double, 3>;
using Counts = std::array<int, 3>;  // counts of the encoders, relative to their zero after homing

// Converts encoder counts to angles.
Angles anglesOf(const Counts& counts);

// Inverse kinematics: returns the angles for a point; nothing when it is out of reach.
std::optional<Angles> inverse(const Vec3& point);

// Returns the Jacobian at a reachable point. Row i is the gradient of arm i's angle, rad/m.
Eigen::Matrix3d jacobian(const Vec3& point);

// Forward kinematics: returns the point for angles. Newton's method goes on from a guess until the angles agree to
// 1e-12 rad. Returns nothing if it does not converge, which may happen for angles that the mechanism cannot take.
std::optional<Vec3> forward(const Angles& angles, const Vec3& guess);

inline const Vec3 kHome{0.0, 0.0, 0.12};  // m, a guess from which every reachable point is found
// m, the point where the encoders are zero; the origin of the servo loop's coordinates
inline const Vec3 kCentre{0.0, 0.0, 0.1346};

// Returns the torques (N·m) on the arms that exert a force (N). They are J^-T F, by the principle of virtual work.
Vec3 torques(const Vec3& force, const Vec3& point);

inline constexpr int kMostTorque = 4096;           // counts
inline constexpr double kCountsPerTorque = -10e3;  // per N·m, as libnifalcon has it; not calibrated

// Converts torques to counts. If one exceeds kMostTorque, all three are scaled down together, so that the force keeps
// its direction. The counts are zero for torques that are not finite.
Counts torqueCounts(const Vec3& torque);

}  // namespace handwheel::falcon
