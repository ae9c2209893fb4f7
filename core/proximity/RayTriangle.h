// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <optional>

namespace handwheel {

// A watertight ray-triangle intersection test, prepared for many triangles. A ray through an edge or corner that
// triangles share hits at least one of them (Woop, Benthin and Wald, "Watertight ray/triangle intersection", JCGT
// 2013).
class RayTriangleTest {
 public:
  // The direction must be finite and not zero.
  RayTriangleTest(const Vec3& origin, const Vec3& direction);

  // Returns the distance as a multiple of the direction's length, >= 0. A triangle seen exactly edge-on is not hit.
  std::optional<double> hit(const Vec3& a, const Vec3& b, const Vec3& c) const;

 private:
  Vec3 sheared(const Vec3& p) const;

  Vec3 m_origin;
  std::array<int, 3> m_axes;  // the last is the axis of the direction's largest component
  Vec3 m_shear;
};

}  // namespace handwheel
