// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

namespace handwheel {

// Kind of a snap feature.
enum class SnapKind : std::uint8_t { Point, Segment, Facet, Curve };

// Identifies a snap feature by kind and the id that it was added with.
struct SnapFeature {
  SnapKind kind = SnapKind::Point;
  std::uint32_t id = kNone;

  bool operator==(const SnapFeature&) const = default;
};

// A convex piece of a snap feature. It is a point, a segment, a triangle, or the joint of two segments of a curve. The
// nearest point of a convex set moves no faster than the tip, so the force of each piece is continuous; that of a whole
// curve is not, inside a bend.
//
// Where forces are summed, a curve counts once although its segments meet: by inclusion and exclusion, the force of the
// curve is the sum over its segments less that of its joints. Where the nearest point of a segment is a joint, the two
// cancel; so the segment is not counted there, but the joint is, with the number of segments it stands for.
struct SnapItem {
  enum class Shape : std::uint8_t { Point, Segment, Facet, Joint };

  std::array<Vec3, 3> points;  // points of the shape; for a joint, itself and its two neighbours. Unused ones repeat
  SnapFeature feature;
  Shape shape = Shape::Point;
  std::array<bool, 2> yields = {};  // a segment yields to the joint at its first, second end
  float weight = 1.0f;              // number of equal features that it represents
  float rounding = 0.0f;            // mm: rounding tolerance; a point within it of one of its points may be that point

  // Returns 0 for points, 1 for segments, curves and their joints, 2 for triangles.
  std::size_t dimension() const;
  Vec3 closestTo(const Vec3& p) const;
  // Returns the factor of its force in a sum at p: the weight; 0 for a segment that yields, -1 to 1 for a joint.
  double countAt(const Vec3& p) const;
};

}  // namespace handwheel
