// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <cstddef>

namespace handwheel {

// The parts of a volume: voxels inside that hang together over their faces.
struct VolumeParts {
  std::vector<std::size_t> voxels;  // of each, the largest first
};
// O(voxels of the blocks with samples + full blocks).
VolumeParts partsOf(const SparseVolume& volume);

// Takes away all parts but the largest ones; the surface of those stays where it is. Returns the parts before.
VolumeParts keepLargest(SparseVolume& volume, std::size_t parts);

}  // namespace handwheel
