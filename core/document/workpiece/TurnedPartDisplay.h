// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "machining/TurnedSurface.h"
#include "machining/finish/SurfaceFinish.h"

#include <memory>

namespace handwheel {

// The group of the parts that show a stock, cut or not. The view updates a group as a whole.
inline constexpr const char* kStockGroup = "stock";

// The group of the parts that show a piece that was parted off. It stays where it was, drawn faintly.
inline constexpr const char* kPartedGroup = "parted off";

// Returns a turned part as displayed parts, one for each block of triangles; unchanged blocks are reused. base: mm, z
// of the lower end.
DisplayModel displayOf(const TurnedSurface& surface, double base);

// Shows the finish of the outside in such a model: blocks are brighter and glossier the smoother they are, by the mean
// of the logarithms of Ra. Blocks of unknown finish are unchanged. Every eighth sample is used: some tenths of a
// millisecond.
void showFinish(DisplayModel& model, const TurnedProfile& profile, const SurfaceFinish& finish);

// The block of such a model in which a part is parted, split in two.
struct PartedBlock {
  std::shared_ptr<const TriangleSoup> whole, held, parted;
  double z = 0.0;  // mm, end of the held piece
};

// Moves the pieces that the chuck no longer holds to their own group. Returns the block that was split; passed to the
// next call for the same part, it is split again only if it has changed. O(samples).
PartedBlock showPartedOff(DisplayModel& model, const TurnedProfile& profile, PartedBlock before = {});

}  // namespace handwheel
