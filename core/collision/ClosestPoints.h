// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/CollisionBody.h"

#include <optional>
#include <vector>

namespace handwheel {

// The closest points of two bodies in the world. Where they meet, or one is inside of the other, the distance is below
// 0, or 0 where they just touch: moved by so much along the normal, the first one leaves the second.
struct ClosestPoints {
  double distance = std::numeric_limits<double>::infinity();  // mm
  Vec3 first = Vec3::Zero(), second = Vec3::Zero();           // mm, on the surface of each
  Vec3 normal = Vec3::UnitZ();                                // of unit length, from the second to the first
};

// What was found of two pieces last time, for the next: where to begin, and which way they came from.
struct PairHint {
  std::uint32_t first = kNone, second = kNone;  // the closest triangles; 0 for a solid
  Vec3 normal = Vec3::Zero();                   // while they did not meet; zero: not known
};

// The closest points of two pieces where they are nearer than `enough`, else none: they are not. Poses: of their frames
// in the world. Any thread.
//
// Of what meets the depth is the smallest penetration for boxes, cylinders and spheres (by directions that are
// tried, so never too small; exact without cylinders). Of triangles it is the smallest, of some directions, by which
// those that cross come apart: a bound, as meshes may be open. tolerance: mm that the points of meshes may be further
// from each other than the closest ones.
std::optional<ClosestPoints> closestPoints(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b,
                                           const Pose& poseB, double enough, PairHint& hint, QueryCounts& counts,
                                           double tolerance = 0.0);

// Whether two pieces are nearer to each other than `than`: the value is then below it, and else a lower bound of their
// distance, which is known up to `upTo`, at least `than`. Quicker than the closest points: it stops at what tells.
double distanceBound(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB,
                     double than, double upTo, PairHint& hint, QueryCounts& counts);

// Whether two pieces meet, or one is inside of the other. Quicker than a bound.
bool areMeeting(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB, PairHint& hint,
                QueryCounts& counts);

// A place where two pieces touch, or nearly.
struct PieceContact {
  std::uint32_t first = kNone, second = kNone;  // triangles, by their numbers in the soups; kNone: a solid
  // Of these two alone: apart, they have a distance; where they meet, the distance is their smallest penetration,
  // of some that are tried, and the points are where they touch last on it.
  ClosestPoints points;
};

// Adds all pairs of a triangle or solid of the one piece and one of the other that are nearer to each other than the
// margin, or meet. Just touching is meeting, and with a margin of 0 only what meets is found. Triangles are surfaces:
// what lies within a closed mesh without meeting its surface has no contact. At most so many are added. margin: mm, at
// least 0.
void addContacts(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB, double margin,
                 std::size_t most, std::vector<PieceContact>& contacts, QueryCounts& counts);

}  // namespace handwheel
