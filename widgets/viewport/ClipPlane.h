// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <utility>

namespace handwheel {

// A clipping plane of the view. Objects on the side of its normal are neither drawn nor picked.
struct ClipPlane {
  Vec3 normal = Vec3::UnitZ();  // unit length
  double offset = 0.0;          // distance of the plane from the origin of the model along the normal; mm
  bool on = false;

  bool isClippedAway(const Vec3& p) const { return on && normal.dot(p) > offset; }
  // Returns the same plane with the other side clipped.
  ClipPlane flipped() const { return {-normal, -offset, on}; }

  bool operator==(const ClipPlane&) const = default;
};

// Returns the offsets between which a plane with this normal meets the box.
inline std::pair<double, double> clipOffsets(const Box& box, const Vec3& normal) {
  const double middle = normal.dot(box.center());
  const double reach = normal.cwiseAbs().dot(box.sizes()) / 2.0;
  return {middle - reach, middle + reach};
}

}  // namespace handwheel
