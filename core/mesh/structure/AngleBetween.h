// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <cmath>

namespace handwheel {

// Returns the angle between two vectors, 0…π (radian). The result is accurate to the last digits, also near 0 and π.
// Vectors may have any length; the result is 0 if one of them is zero.
inline double angleBetween(const Vec3& a, const Vec3& b) {
  const Vec3 u = a.stableNormalized(), v = b.stableNormalized();
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace handwheel
