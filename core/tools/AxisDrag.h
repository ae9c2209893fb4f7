// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/PickRay.h"

#include <optional>

namespace handwheel {

// Dragging along and about an axis. Directions of rays must have unit length here.

// A point being dragged, and the axis that it moves about or along.
struct HeldPoint {
  Vec3 centre = Vec3::Zero();  // on the axis; mm
  Vec3 axis = Vec3::UnitZ();   // unit length
  Vec3 point = Vec3::Zero();   // the grabbed point; mm

  double lever() const { return (point - centre).cross(axis).norm(); }  // mm
};

// Returns the rotation about the axis (rad) that moves the point under the ray. It is determined up to full turns; the
// one nearest to `soFar` is returned. If the circle of the point is seen from above, the point follows the ray around
// the axis; if it is seen from the side, the point gets as near to the ray as possible without passing the far side.
// None if the ray does not determine it: it runs through the axis, or meets the circle's plane behind the viewer.
// lever() must not be 0.
std::optional<double> rotationUnder(const HeldPoint& held, const PickRay& pickRay, double soFar);

// Returns the translation along the axis (mm) that moves the point nearest to the ray. None if axis and ray are
// parallel.
std::optional<double> translationUnder(const HeldPoint& held, const Ray& ray);

// Returns the intersection of the ray with the drag plane through the point. The plane is perpendicular to the ray by
// which the point was grabbed. None if the ray is parallel to it.
std::optional<Vec3> positionUnder(const Vec3& point, const Vec3& facing, const Ray& ray);

}  // namespace handwheel
