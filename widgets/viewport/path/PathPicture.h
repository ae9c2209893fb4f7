// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/path/PathLayer.h"

#include <span>

namespace handwheel {

// A point of the path of a tool, for drawing. A leg is the part of a path from one waypoint to the next.
struct PathPoint {
  Vec3 at;                                     // mm
  std::size_t leg = 0;                         // number of the leg that contains the point or ends at it
  PathLine::Look look = PathLine::Look::Feed;  // look of the piece from the previous point
};

// Returns the lines that draw a path with its direction and its waypoints. Pieces of Look::Travel are drawn as dashes.
// An arrow is in the middle of each leg, and a dot at its beginning and at its end; they are left out where legs are
// short. The lines are sorted by look. Points that are not finite are left out. O(points · log points).
std::vector<PathLine> pathPicture(std::span<const PathPoint> points);

}  // namespace handwheel
