// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/ProximityQuery.h"

namespace handwheel {

// Parameters of the repulsive force on a held body near obstacles.
struct DistanceForceSettings {
  double reach = 10.0;         // mm: distance below which there is a force; the threshold of the query
  double tolerance = 1e-3;     // mm: largest error of the distances (setting proximity.tolerance)
  double stiffness = 0.5;      // N/mm
  double torqueShare = 1.0;    // fraction of the torque that is applied, 0…1; only 1 is conservative
  double deepest = 10.0;       // mm: deeper penetrations do not increase the force
  double largestForce = 20.0;  // N: limit of the total force; a larger force and its torque are scaled down
};

// A force and its torque about a reference point. Both are the gradient of the energy if the whole torque is applied
// and the largest force is not reached.
struct DistanceWrench {
  Vec3 force = Vec3::Zero();   // N
  Vec3 torque = Vec3::Zero();  // N·mm
  double energy = 0.0;         // N·mm
};

// Returns the force on the first bodies of the pairs. Each pair that is nearer than the reach contributes the stiffness
// times the difference between the reach and its distance, along the normal, at the closest point of the first body.
// (He 2008, eq. 3-13 and 3-14, with the sign that pushes the bodies apart, a normal of unit length, and the penetration
// depth added to the reach.) The force is continuous if the distances are, zero at distances beyond the reach, and
// never larger than its limit. Pairs that are not finite are ignored. Allocates nothing.
DistanceWrench distanceForce(std::span<const NearPair> near, const Vec3& reference,
                             const DistanceForceSettings& settings);

}  // namespace handwheel
