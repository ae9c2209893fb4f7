// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

// A volume as it is exchanged with the process for VDB files. bytesOf() writes a line with the voxel and the origin
// (mm), a flag for fog volumes, and the number of other grids. The regions of the volume follow (VolumeSerialization.h)
// in the byte order of this machine.
struct VdbVolume {
  SparseVolume volume;
  bool isFog = false;
  std::size_t otherGrids = 0;
};

std::string bytesOf(const VdbVolume& volume);
// Parses the bytes that bytesOf() returns. Returns nothing if the bytes are malformed. Takes at most 64 times the
// memory of the bytes.
std::optional<VdbVolume> vdbVolumeIn(std::string_view bytes);

}  // namespace handwheel
