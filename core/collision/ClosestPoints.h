// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/CollisionBody.h"

#include <optional>
#include <vector>

namespace handwheel {

// The closest points of two bodies in the world. If they meet, or one is inside the other, the distance is below 0, or
// 0 if they just touch: moved by so much along the normal, the first one leaves the second.
struct ClosestPoints {
  double distance = std::numeric_limits<double>::infinity();  // mm
  Vec3 first = Vec3::Zero(), second = Vec3::Zero();           // mm, on the surface of each
  Vec3 normal = Vec3::UnitZ();                                // unit length, from the second to the first
};

// The last result for two pieces, at which the next query starts.
struct PairHint {
  std::uint32_t first = kNone, second = kNone;  // closest triangles; 0 for a solid
  Vec3 normal = Vec3::Zero();                   // normal at the last time that they did not meet; zero: unknown
};

// Returns the closest points of two pieces if these are nearer than `enough`, or nothing. Poses: of their frames in the
// world. Any thread.
//
// For pieces that meet the depth is the smallest penetration for boxes, cylinders and spheres (over the directions that
// are tried, so never too small; exact without cylinders). For triangles it is the smallest penetration over some
// directions that separates those that cross: a bound, as meshes may be open. tolerance: the distance may exceed the
// smallest one by this many mm between meshes.
std::optional<ClosestPoints> closestPoints(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b,
                                           const Pose& poseB, double enough, PairHint& hint, QueryCounts& counts,
                                           double tolerance = 0.0);

// Returns a value below `than` if two pieces are nearer to each other than that, otherwise a lower bound of their
// distance. The bound is determined up to `upTo`, at least `than`. Faster than the closest points: it stops once the
// answer is clear.
double distanceBound(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB,
                     double than, double upTo, PairHint& hint, QueryCounts& counts);

// Returns true if two pieces meet, or one is inside the other. Faster than a bound.
bool areMeeting(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB, PairHint& hint,
                QueryCounts& counts);

// A contact of two pieces, which touch or nearly touch.
struct PieceContact {
  std::uint32_t first = kNone, second = kNone;  // triangles, by their indices in the soups; kNone: a solid
  // Closest points of these two alone: their distance, or if they meet, their smallest penetration over the directions
  // that are tried, and the points of their last touch in that direction.
  ClosestPoints points;
};

// Adds all pairs of a triangle or solid of one piece and one of the other that are nearer to each other than the
// margin, or meet. Just touching is meeting, and with a margin of 0 only pairs that meet are found. Triangles are
// surfaces: a shape within a closed mesh that does not meet its surface has no contact. Adds at most `most` contacts.
// margin: mm, at least 0.
void addContacts(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB, double margin,
                 std::size_t most, std::vector<PieceContact>& contacts, QueryCounts& counts);

}  // namespace handwheel
