// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/ProximityQuery.h"

namespace handwheel {

// Parameters of the repulsive force on a held body near obstacles.
struct DistanceForceSettings {
  double reach = 10.0;         // mm: from this distance on; the threshold of the query
  double tolerance = 1e-3;     // mm that a distance may be too large by: the setting proximity.tolerance
  double stiffness = 0.5;      // N/mm
  double torqueShare = 1.0;    // 0 to 1, of the torque; only 1 is conservative
  double deepest = 10.0;       // mm: what is deeper in each other pushes no harder
  double largestForce = 20.0;  // N: of all together; what is beyond is scaled down with its torque
};

// A force and its torque about a reference point. The energy is what both are the gradient of, as long as the whole
// torque is asked for and the largest force is not reached.
struct DistanceWrench {
  Vec3 force = Vec3::Zero();   // N
  Vec3 torque = Vec3::Zero();  // N·mm
  double energy = 0.0;         // N·mm
};

// The force on the first bodies of the pairs: for each pair nearer than the reach, stiffness times what it is nearer
// by, along the normal, at the closest point (He 2008, eq. 3-13 and 3-14, with the sign that pushes apart, a normal of
// unit length, and the depth of what meets added to the reach). Continuous where the distances are; zero from the reach
// on; never larger than its limit. Pairs that are no numbers do not count. Allocates nothing.
DistanceWrench distanceForce(std::span<const NearPair> near, const Vec3& reference,
                             const DistanceForceSettings& settings);

}  // namespace handwheel
