// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

namespace handwheel {

enum class SnapKind : std::uint8_t { Point, Segment, Facet, Curve };

// Which feature it was: its kind and the number that it was added with.
struct SnapFeature {
  SnapKind kind = SnapKind::Point;
  std::uint32_t id = kNone;

  bool operator==(const SnapFeature&) const = default;
};

// A convex piece of a feature: a point, a segment, a triangle, or the joint of two segments of a curve. The nearest
// point of a convex set moves no faster than the hand, so the force of each piece is continuous; of a whole curve it is
// not, inside a bend.
//
// Where forces are summed, a curve counts once although its segments meet: by inclusion and exclusion, the force of the
// curve is the sum over its segments less that of its joints. Where the nearest point of a segment is a joint, the two
// cancel; so the segment yields there to the joint, which counts how many segments it stands for.
struct SnapItem {
  enum class Shape : std::uint8_t { Point, Segment, Facet, Joint };

  std::array<Vec3, 3>
      points;  // those that the shape needs; of a joint its place and its two neighbours. The rest repeat
  SnapFeature feature;
  Shape shape = Shape::Point;
  std::array<bool, 2> yields = {};  // a segment to a joint at its first, second end
  float weight = 1.0f;              // as many equal features as it stands for
  float rounding = 0.0f;            // mm: what is not further from a point of it than this may be the point itself

  // 0 of points, 1 of segments, curves and their joints, 2 of triangles.
  std::size_t dimension() const;
  Vec3 closestTo(const Vec3& p) const;
  // How many times its force counts in a sum at p: the weight; 0 of a segment that yields, -1 to 1 of a joint.
  double countAt(const Vec3& p) const;
};

}  // namespace handwheel
