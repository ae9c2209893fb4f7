// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/DistanceForce.h"

namespace handwheel {

// The repulsive force on objects that a hand holds near others (distanceForce()). The held objects move as one rigid
// body. Results of distance queries are reused for the next pose.
class HeldForce {
 public:
  // query: the distances of the held objects, its first bodies, from the others. held: the number of held objects.
  HeldForce(ProximityQuery query, std::uint32_t held, const DistanceForceSettings& settings);

  // Ignores from now on the pairs that intersect or touch without a displacement, such as a foot on a floor.
  void leaveOutTouching();

  struct Felt {
    DistanceWrench wrench;  // on the held objects
    // Distance to the nearest object, mm; infinity: no object is within the reach.
    double distance = std::numeric_limits<double>::infinity();
  };
  // Returns the force and torque about a reference point after a displacement from the initial poses. The result is
  // zero if one of them is not finite.
  Felt at(const Pose& displacement, const Vec3& reference);

 private:
  ProximityQuery m_query;
  std::uint32_t m_held;
  DistanceForceSettings m_settings;
  std::vector<BodyPair> m_leftOut;
  std::vector<NearPair> m_near;
};

}  // namespace handwheel
