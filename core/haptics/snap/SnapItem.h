// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

namespace handwheel {

// Kind of a snap feature.
enum class SnapKind : std::uint8_t { Point, Segment, Facet, Curve };

// Identifies a snap feature by its kind and the id with which it was added.
struct SnapFeature {
  SnapKind kind = SnapKind::Point;
  std::uint32_t id = kNone;

  bool operator==(const SnapFeature&) const = default;
};

// A convex piece of a snap feature. It is a point, a segment, a triangle, or the joint of two segments of a curve. The
// nearest point of a convex set moves no faster than the tip, so the force of each piece is continuous. The force of a
// whole curve is not, inside a bend.
//
// When forces are summed, a curve counts once even though its segments meet: by inclusion and exclusion, the force of
// the curve is the sum over its segments minus the sum over its joints. If the nearest point of a segment is a joint,
// the forces of the segment and the joint cancel. The segment is then not counted; the joint is, with the number of
// segments that it represents.
struct SnapItem {
  enum class Shape : std::uint8_t { Point, Segment, Facet, Joint };

  // Points of the shape. Those of a joint are the joint and its two neighbours. Unused elements repeat a point.
  std::array<Vec3, 3> points;
  SnapFeature feature;
  Shape shape = Shape::Point;
  std::array<bool, 2> yields = {};  // for the first and the second end of a segment: it yields to the joint there
  float weight = 1.0f;              // number of equal features that it represents
  float rounding = 0.0f;            // mm; a nearest point within this distance of one of the points may be equal to it

  // Returns 0 for points, 1 for segments, curves and their joints, 2 for triangles.
  std::size_t dimension() const;
  Vec3 closestTo(const Vec3& p) const;
  // Returns the factor of the item's force in a sum at p. The factor is the weight; 0 for a segment that yields, -1 to
  // 1 for a joint.
  double countAt(const Vec3& p) const;
};

}  // namespace handwheel
