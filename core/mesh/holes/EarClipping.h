// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/holes/HoleContext.h"
#include "mesh/holes/Obstacles.h"

#include <optional>

namespace handwheel {

// The weights in the cost of an ear. Each term is about 0 for the best ear and 1 for a bad ear.
struct EarWeights {
  double length = 1.0;  // weight of the new edge's length relative to the mean edge of the loop
  double angles = 1.0;  // weight of the largest angle's difference from 60°
  double normal = 1.0;  // weight of the bend against the faces that the ear joins
  // Weight of the loop's normal in the decision on the outward direction of an ear, relative to the faces that the ear
  // joins. The loop's normal is best over a flat cut, and meaningless over a loop that winds through space.
  double lid = 2.0;
};

// Triangulates a hole by ear clipping, the best ear first (He 2008, section 4.1.5). The ears are kept in a heap: O(n
// log n) plus one obstacle query for each examined ear. An ear that would intersect the surface or double an edge is
// skipped. Returns nothing if the loop cannot be closed because no ear is left to clip.
std::optional<Patch> clipEars(const HoleContext& hole, const Obstacles& obstacles, const EarWeights& weights,
                              Progress progress = {});

}  // namespace handwheel
