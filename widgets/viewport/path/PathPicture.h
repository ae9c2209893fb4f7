// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/path/PathLayer.h"

#include <span>

namespace handwheel {

// A point of the path of a tool, for drawing.
struct PathPoint {
  Vec3 at;                                     // mm
  std::size_t leg = 0;                         // leg through this point, or ending at it
  PathLine::Look look = PathLine::Look::Feed;  // look of the piece from the previous point
};

// Returns the lines that draw a path with its direction and its waypoints. Travel is drawn as dashes; an arrow is in
// the middle of each leg; a dot at the beginning and at the end of each leg. Short legs may have none. Lines of one
// look follow each other. Points that are not finite are left out. O(points · log points).
std::vector<PathLine> pathPicture(std::span<const PathPoint> points);

}  // namespace handwheel
