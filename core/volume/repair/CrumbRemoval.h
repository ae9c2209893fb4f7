// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "volume/SparseVolume.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace handwheel {

struct ClosedSurfaceInVoxels;

// Removes the crumbs of a volume, and returns their number. Crumbs are left where the rim of an open surface is folded
// or ragged: parts with less than a hundredth of the largest part's voxels, that no closed shell of the surface bounds,
// and that are not the main part of an open shell with a hundredth of the surface's area or more. own: the number of
// triangles that do not close a boundary. points: points in voxels where rows enter or leave the inside, each with its
// triangle; those on crumbs are removed. The volume is unchanged if cancelled.
std::size_t removeCrumbs(SparseVolume& volume, const ClosedSurfaceInVoxels& surface, std::size_t own,
                         std::vector<std::pair<Vec3, std::uint32_t>>& points, const Progress& progress);

}  // namespace handwheel
