// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/holes/HoleContext.h"
#include "mesh/holes/Obstacles.h"

#include <optional>

namespace handwheel {

// The weights in the cost of an ear. Each term is about 0 for the best and 1 for a bad ear.
struct EarWeights {
  double length = 1.0;  // weight of the new edge's length relative to the mean edge of the loop
  double angles = 1.0;  // weight of the largest angle's difference from 60°
  double normal = 1.0;  // weight of the bend against the faces that the ear joins
  // Weight of the loop's normal, relative to the faces an ear joins, for the outward direction. It is best over a flat
  // cut, and meaningless over a loop that winds through space.
  double lid = 2.0;
};

// Triangulates a hole by ear clipping, the best ear first (He 2008, section 4.1.5). With a heap: O(n log n) and one
// obstacle query per ear examined. An ear that would intersect the surface or double an edge is skipped. Returns
// nothing if no ear is left to clip.
std::optional<Patch> clipEars(const HoleContext& hole, const Obstacles& obstacles, const EarWeights& weights,
                              Progress progress = {});

}  // namespace handwheel
