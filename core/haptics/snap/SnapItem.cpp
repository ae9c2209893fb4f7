// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/snap/SnapItem.h"

#include "proximity/ClosestPoint.h"

namespace handwheel {
namespace {

// Returns true if the end is the point nearest to p on a segment from it to `other`. Segments and joints must agree to
// the last bit: hence one function, called and not inlined.
[[gnu::noinline]] bool isBeyond(const Vec3& p, const Vec3& end, const Vec3& other) {
  return (p - end).dot(other - end) <= 0.0;
}

}  // namespace

std::size_t SnapItem::dimension() const {
  switch (shape) {
    case Shape::Point:
      return 0;
    case Shape::Segment:
    case Shape::Joint:
      return 1;
    case Shape::Facet:
      return 2;
  }
  return 0;
}

Vec3 SnapItem::closestTo(const Vec3& p) const {
  const auto& [a, b, c] = points;
  switch (shape) {
    case Shape::Point:
    case Shape::Joint:
      return a;
    case Shape::Segment:
      return closestOnSegment(p, a, b);
    case Shape::Facet:
      return closestOnTriangle(p, a, b, c);
  }
  return a;
}

double SnapItem::countAt(const Vec3& p) const {
  const auto& [a, b, c] = points;
  if (shape == Shape::Joint) return weight * static_cast<double>(isBeyond(p, a, b) + isBeyond(p, a, c) - 1);
  if ((yields[0] && isBeyond(p, a, b)) || (yields[1] && isBeyond(p, b, a))) return 0.0;
  return weight;
}

}  // namespace handwheel
