// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/cycles/ContourSegment.h"

#include <optional>

namespace handwheel {

// The size of a chamfer or a rounding at a corner of a path.
struct CornerSize {
  bool isRound = false;
  double size = 0.0;  // radius of the rounding; distance of the ends of the chamfer from the corner
};

// Makes the piece between two segments that meet in a corner, and shortens both to it. A rounding is tangent to both.
// The ends of a chamfer have the same straight distance from the corner. Returns nothing if the segments do not form a
// corner, or are too short for the piece; they are unchanged then. The cost is constant.
std::optional<ContourSegment> cornerPiece(ContourSegment& before, ContourSegment& after, const CornerSize& corner);

}  // namespace handwheel
