// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/HoleContext.h"
#include "mesh/Obstacles.h"

#include <optional>

namespace handwheel {

// What makes an ear good; each term is about 0 for the best and 1 for a bad ear.
struct EarWeights {
  double length = 1.0;  // of the new edge, in mean edges of the loop
  double angles = 1.0;  // how far the largest angle is from 60°
  double normal = 1.0;  // how far the ear bends from the faces it joins
  // How much a lid over the whole loop says, beside the faces an ear joins, on which way is out. Over a flat cut it
  // says best; over a loop that winds through space it says nothing.
  double lid = 2.0;
};

// Triangulates a hole by cutting the best ear first (He 2008, section 4.3), with a heap: O(n log n) and one obstacle
// query per ear looked at. An ear that would cross the surface or double an edge is passed over. None when it gets
// stuck.
std::optional<Patch> cutEars(const HoleContext& hole, const Obstacles& obstacles, const EarWeights& weights,
                             Progress progress = {});

}  // namespace handwheel
