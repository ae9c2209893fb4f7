// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "machining/TurnedSurface.h"
#include "machining/finish/SurfaceFinish.h"

#include <memory>

namespace handwheel {

// The group of the parts that show a stock, cut or not. A change of the whole is never shown half done.
inline constexpr const char* kStockGroup = "stock";

// The group of those that show what was parted off: it stays where it was, and is drawn faintly.
inline constexpr const char* kPartedGroup = "parted off";

// A turned part as displayed parts, one for each block of triangles: what did not change is not built anew. base: mm, z
// of the lower end.
DisplayModel displayOf(const TurnedSurface& surface, double base);

// Shows the finish of the outside in such a model: of the blocks what is polished is light and gleams, what is rough is
// dull, by the mean of the logarithms of Ra. Blocks of which nothing is known look as they did. It takes every eighth
// sample: some tenths of a millisecond.
void showFinish(DisplayModel& model, const TurnedProfile& profile, const SurfaceFinish& finish);

// The block of such a model in which a part is parted, in two.
struct PartedBlock {
  std::shared_ptr<const TriangleSoup> whole, held, parted;
  double z = 0.0;  // mm, of the end of what is held
};

// Moves what is not held by the chuck any more to its own group. Returns the block that was cut for it: given to the
// next call for a part that goes on, it is only cut anew where it has changed. O(samples).
PartedBlock showPartedOff(DisplayModel& model, const TurnedProfile& profile, PartedBlock before = {});

}  // namespace handwheel
