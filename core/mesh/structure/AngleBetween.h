// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <cmath>

namespace handwheel {

// The angle between two vectors, 0…π (radian). Exact to the last digits also near its ends. Vectors of any length; 0
// where one is zero.
inline double angleBetween(const Vec3& a, const Vec3& b) {
  const Vec3 u = a.stableNormalized(), v = b.stableNormalized();
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace handwheel
