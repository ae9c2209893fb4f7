// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/PickRay.h"

#include <optional>

namespace handwheel {

// Dragging along and about an axis. The directions of rays must have unit length.

// A point being dragged, and the axis that it moves about or along.
struct HeldPoint {
  Vec3 centre = Vec3::Zero();  // point on the axis; mm
  Vec3 axis = Vec3::UnitZ();   // unit length
  Vec3 point = Vec3::Zero();   // the grabbed point; mm

  double lever() const { return (point - centre).cross(axis).norm(); }  // distance of the point from the axis, mm
};

// Returns the rotation about the axis (rad) that moves the point under the ray. It is determined up to full turns, and
// the rotation nearest to `soFar` is returned. If the circle of the point is seen from above, the point follows the ray
// around the axis; if the circle is seen from the side, the point gets as near to the ray as possible without passing
// the far side. Returns nothing if the ray does not determine the rotation: it runs through the axis, or meets the
// circle's plane behind the viewer. lever() must not be 0.
std::optional<double> rotationUnder(const HeldPoint& held, const PickRay& pickRay, double soFar);

// Returns the translation along the axis (mm) that moves the point nearest to the ray. Returns nothing if axis and ray
// are parallel.
std::optional<double> translationUnder(const HeldPoint& held, const Ray& ray);

// Returns the intersection of the ray with the drag plane through the point. The plane is perpendicular to the
// direction `facing`, which may be that of the ray that grabbed the point. Returns nothing if the ray is parallel to
// the plane.
std::optional<Vec3> positionUnder(const Vec3& point, const Vec3& facing, const Ray& ray);

}  // namespace handwheel
