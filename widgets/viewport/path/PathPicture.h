// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/path/PathLayer.h"

#include <span>

namespace handwheel {

// A point of the way of a tool, as it is to be drawn.
struct PathPoint {
  Vec3 at;                                     // mm
  std::size_t leg = 0;                         // that goes through it or ends there
  PathLine::Look look = PathLine::Look::Feed;  // of the piece from the point before
};

// A path with its direction and its places: lines, of travel as dashes; an arrow in the middle of each leg; a dot at
// the beginning and where each leg ends. Where legs are short some go without. Lines of one look follow each other.
// Points that are not finite are left out. O(points · log points).
std::vector<PathLine> pathPicture(std::span<const PathPoint> points);

}  // namespace handwheel
