// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <vector>

namespace handwheel {

// A point of a curve on a part, for a tool that works along it.
struct TrackPoint {
  Vec3 place;      // mm
  Vec3 direction;  // along the curve, of unit length
  Vec3 normal;     // away from the part, of unit length, at a right angle to the direction
};

// A curve on a part. Straight between its points.
struct SurfaceTrack {
  std::vector<TrackPoint> points;  // empty: there is none
  bool isClosed = false;           // it ends where it begins; that point is in it twice
  double length() const;           // mm
  SurfaceTrack reversed() const;
};

// How far a place is from the segment between two points (mm).
double distanceToSegment(const Vec3& place, const Vec3& a, const Vec3& b);

// Whether the curve turns to one side and at once to the other again and again, as edges of scanned surfaces do, which
// go along the sides of their triangles. O(points).
bool isJagged(const SurfaceTrack& track);

// Sets the directions of a curve's points from their places, and makes their normals unit vectors at a right angle to
// these. Neighbours must be apart.
void orient(SurfaceTrack& track);

// The piece of a curve that begins at its point nearest to a place and goes on for a length (mm), or to its end; a
// closed one comes round to where it began. Empty where its length is 0. O(points).
SurfaceTrack pieceFrom(const SurfaceTrack& track, const Vec3& place, double length);

// The same curve with fewer points: nowhere farther than `deviation` (mm) from it, its normals off by no more than
// `angle` (rad). Ends stay. (Douglas and Peucker 1973.) O(n log n) as a rule.
SurfaceTrack simplified(const SurfaceTrack& track, double deviation, double angle);

// The shorter piece of a curve between two places on it. Empty where it does not lead from one to the other: where its
// end is farther than `tolerance` (mm) from the second. O(points).
SurfaceTrack pieceBetween(const SurfaceTrack& track, const Vec3& from, const Vec3& to, double tolerance);

}  // namespace handwheel
