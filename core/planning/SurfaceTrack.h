// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <vector>

namespace handwheel {

// A point of a curve on a part along which a tool works.
struct TrackPoint {
  Vec3 position;   // mm
  Vec3 direction;  // along the curve, of unit length
  Vec3 normal;     // outwards from the part, of unit length, at a right angle to the direction
};

// A curve on a part. It is straight between its points.
struct SurfaceTrack {
  std::vector<TrackPoint> points;  // empty: there is no curve
  bool isClosed = false;           // the curve ends at its beginning, and this point is in the list twice
  double length() const;           // mm
  SurfaceTrack reversed() const;
};

// Returns the distance of a point from the segment between two points (mm).
double distanceToSegment(const Vec3& position, const Vec3& a, const Vec3& b);

// Returns true if a curve zigzags. The edges of scanned surfaces often zigzag, because they follow the sides of
// triangles. O(points).
bool isJagged(const SurfaceTrack& track);

// Computes the directions of a curve's points from their positions, and makes their normals unit vectors at a right
// angle to the directions. Consecutive points must not coincide.
void orient(SurfaceTrack& track);

// Returns the piece of a curve that begins at its point nearest to a position and continues for a length (mm), or to
// the end of the curve; a closed curve continues past its beginning, at most once around. The piece is empty if its
// length is 0. O(points).
SurfaceTrack pieceFrom(const SurfaceTrack& track, const Vec3& position, double length);

// Returns a curve with fewer points (Douglas and Peucker 1973). It deviates from the original by at most `deviation`
// (mm), and its normals by at most `angle` (rad). Its ends stay the same. The cost is usually O(n log n).
SurfaceTrack simplified(const SurfaceTrack& track, double deviation, double angle);

// Returns the shorter piece of a curve between two of its points. The piece is empty if the curve does not come within
// `tolerance` (mm) of the second point. O(points).
SurfaceTrack pieceBetween(const SurfaceTrack& track, const Vec3& from, const Vec3& to, double tolerance);

}  // namespace handwheel
