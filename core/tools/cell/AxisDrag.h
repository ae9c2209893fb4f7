// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/Sight.h"

#include <optional>

namespace handwheel {

// Directions of rays are of unit length here.

// An axis, and a point that one holds and that goes with it.
struct HeldPoint {
  Vec3 centre = Vec3::Zero();  // on the axis; mm
  Vec3 axis = Vec3::UnitZ();   // of unit length
  Vec3 point = Vec3::Zero();   // where it was taken hold of; mm

  double lever() const { return (point - centre).cross(axis).norm(); }  // mm
};

// How far a turn about the axis takes the point under the ray, in rad; of all whole turns the one nearest to the turn
// so far. Where the point's circle is seen from above, the point goes the way of the ray around the axis; where it is
// seen from the side, as near to the ray as it gets without passing the far side. None when the ray does not tell: it
// runs through the axis, or meets the circle's plane behind the viewer. lever() must not be 0.
std::optional<double> turnUnder(const HeldPoint& held, const Sight& sight, double soFar);

// How far a slide along the axis takes the point nearest to the ray, in mm; none when they are parallel.
std::optional<double> slideUnder(const HeldPoint& held, const Ray& ray);

// Where the ray passes the point: in the plane through it that faces the ray by which it was taken hold of. None when
// the ray runs along that plane.
std::optional<Vec3> placeUnder(const Vec3& point, const Vec3& facing, const Ray& ray);

}  // namespace handwheel
