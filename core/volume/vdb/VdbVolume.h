// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

// A volume as it is exchanged with the process for VDB files. It is a line of its voxel and origin (mm), whether it was
// a fog, and how many grids there are beside it; then its regions (VolumeSerialization.h), in the byte order of this
// machine.
struct VdbVolume {
  SparseVolume volume;
  bool isFog = false;
  std::size_t otherGrids = 0;
};

std::string bytesOf(const VdbVolume& volume);
// None where they make no sense. Memory: at most 64 times the bytes.
std::optional<VdbVolume> vdbVolumeIn(std::string_view bytes);

}  // namespace handwheel
