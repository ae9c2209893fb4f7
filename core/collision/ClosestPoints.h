// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/CollisionBody.h"

#include <optional>
#include <vector>

namespace handwheel {

// The closest points of two bodies in the world. If the bodies just touch, the distance is 0. If they intersect, or one
// is inside the other, the distance is below 0; moving the first body by the absolute distance along the normal then
// separates the bodies.
struct ClosestPoints {
  double distance = std::numeric_limits<double>::infinity();  // mm
  Vec3 first = Vec3::Zero(), second = Vec3::Zero();           // mm, on the surface of each body
  Vec3 normal = Vec3::UnitZ();                                // unit length, from the second to the first
};

// The last result for two pieces, from which the next query starts.
struct PairHint {
  std::uint32_t first = kNone, second = kNone;  // indices of the closest triangles; 0 for a solid
  Vec3 normal = Vec3::Zero();                   // normal when the pieces last did not intersect; zero: unknown
};

// Returns the closest points of two pieces if their distance is less than `enough`; otherwise nothing. poseA, poseB:
// the poses of the pieces in the world. tolerance: between meshes the distance may exceed the smallest one by this
// number of mm. May be called on any thread.
//
// For boxes, cylinders and spheres that intersect, the depth is the smallest penetration over a set of directions; it
// is never too small, and exact without cylinders. For meshes it is the smallest penetration, over some directions,
// that separates the triangles that intersect; this is a bound, as meshes may be open.
std::optional<ClosestPoints> closestPoints(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b,
                                           const Pose& poseB, double enough, PairHint& hint, QueryCounts& counts,
                                           double tolerance = 0.0);

// Returns a value below `than` if the distance of two pieces is below `than`; otherwise a lower bound of their
// distance, which is at most `upTo`. upTo: mm, at least `than`. Faster than closestPoints(), because the search stops
// once the answer is known.
double distanceBound(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB,
                     double than, double upTo, PairHint& hint, QueryCounts& counts);

// Returns true if two pieces intersect or touch, or one is inside the other. Faster than distanceBound().
bool areMeeting(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB, PairHint& hint,
                QueryCounts& counts);

// A contact of two pieces that intersect, touch or nearly touch.
struct PieceContact {
  std::uint32_t first = kNone, second = kNone;  // indices of the triangles in the soups; kNone: a solid
  // Closest points of these two triangles or solids alone. If they intersect, the distance is minus their smallest
  // penetration over a set of directions, and the points are those at which they touch last when they are moved apart
  // in this direction.
  ClosestPoints points;
};

// Adds all pairs of a triangle or solid of one piece and one of the other that intersect, touch, or are nearer to each
// other than the margin. Adds at most `most` contacts. A shape inside a closed mesh that does not touch its surface has
// no contact, because triangles count as surfaces. margin: mm, at least 0; 0: only pairs that intersect or touch.
void addContacts(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB, double margin,
                 std::size_t most, std::vector<PieceContact>& contacts, QueryCounts& counts);

}  // namespace handwheel
