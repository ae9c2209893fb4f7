// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "machining/TurnedSurface.h"
#include "machining/finish/SurfaceFinish.h"

#include <memory>

namespace handwheel {

// Name of the group of displayed parts that show a stock, cut or not. The view updates a group as a whole.
inline constexpr const char* kStockGroup = "stock";

// Name of the group of displayed parts that show a piece that was parted off. The piece stays at its position and is
// drawn faintly.
inline constexpr const char* kPartedGroup = "parted off";

// Returns a turned part as displayed parts, one for each block of triangles; unchanged blocks are reused. base: z of
// the lower end, mm.
DisplayModel displayOf(const TurnedSurface& surface, double base);

// Shows the finish of the outside in a model from displayOf(). Blocks are brighter and glossier the smoother they are,
// according to the mean of the logarithms of Ra. Blocks of unknown finish are unchanged. Every eighth sample is used,
// which takes some tenths of a millisecond.
void showFinish(DisplayModel& model, const TurnedProfile& profile, const SurfaceFinish& finish);

// The block of triangles in which a part is parted, and its two pieces.
struct PartedBlock {
  std::shared_ptr<const TriangleSoup> whole, held, parted;
  double z = 0.0;  // mm, end of the held piece
};

// Moves the pieces that the chuck no longer holds to their own group. Returns the block that was split. If it is passed
// to the next call for the same part, it is split again only if it has changed. O(samples).
PartedBlock showPartedOff(DisplayModel& model, const TurnedProfile& profile, PartedBlock before = {});

}  // namespace handwheel
