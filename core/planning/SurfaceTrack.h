// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <vector>

namespace handwheel {

// A point of a curve on a part, for a tool that works along it.
struct TrackPoint {
  Vec3 position;   // mm
  Vec3 direction;  // along the curve, of unit length
  Vec3 normal;     // away from the part, of unit length, at a right angle to the direction
};

// A curve on a part. It is straight between its points.
struct SurfaceTrack {
  std::vector<TrackPoint> points;  // empty: there is no curve
  bool isClosed = false;           // it ends at its beginning; that point is in it twice
  double length() const;           // mm
  SurfaceTrack reversed() const;
};

// Returns the distance of a point from the segment between two points (mm).
double distanceToSegment(const Vec3& position, const Vec3& a, const Vec3& b);

// Returns true if the curve zigzags, as edges of scanned surfaces do, which follow the sides of their triangles.
// O(points).
bool isJagged(const SurfaceTrack& track);

// Sets the directions of a curve's points from their positions, and makes their normals unit vectors at a right angle
// to these. Neighbours must not coincide.
void orient(SurfaceTrack& track);

// Returns the piece of a curve that begins at its point nearest to a position and continues for a length (mm), or to
// its end; a closed curve continues to its beginning. Empty if its length is 0. O(points).
SurfaceTrack pieceFrom(const SurfaceTrack& track, const Vec3& position, double length);

// Returns the same curve with fewer points: nowhere farther than `deviation` (mm) from it, its normals off by no more
// than `angle` (rad). Ends stay. (Douglas and Peucker 1973.) O(n log n) as a rule.
SurfaceTrack simplified(const SurfaceTrack& track, double deviation, double angle);

// Returns the shorter piece of a curve between two points on it. Empty if it does not connect them: its end is farther
// than `tolerance` (mm) from the second. O(points).
SurfaceTrack pieceBetween(const SurfaceTrack& track, const Vec3& from, const Vec3& to, double tolerance);

}  // namespace handwheel
