// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/volume/VolumeSnapshot.h"
#include "volume/SurfaceToVolume.h"

#include <memory>
#include <optional>

namespace handwheel {

struct MadeVolume {
  std::shared_ptr<const VolumeSnapshot> volume;
  SurfaceVolume surface;  // what became of the surface; its volume shares the blocks
};

// The content of a document of what a surface encloses. voxel: mm; none: the usual one. Errors: those of
// volumeOfSurface(), and VolumeErrors::TooLargeToSave.
Result<MadeVolume> makeVolume(const TriangleSoup& surface, std::optional<double> voxel, const std::string& source,
                              Progress progress);

}  // namespace handwheel
