// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/VolumeMaking.h"

#include "base/NumberText.h"
#include "process/SystemMemory.h"
#include "volume/VolumeErrors.h"

namespace handwheel {
namespace {

// The triangles of its display, and what making it takes for a while, as shares of the volume; measured.
constexpr double kDisplay = 4.0, kWhileMaking = 1.5;

}  // namespace

Result<MadeVolume> makeVolume(const TriangleSoup& surface, std::optional<double> voxel, const std::string& source,
                              Progress progress) {
  const double edge = voxel.value_or(usualVoxel(surface));
  const double bytes = predictedVolumeBytes(surface, edge) * (1.0 + kDisplay + kWhileMaking);
  const auto left = static_cast<double>(systemMemory());
  if (bytes > left)
    return Error{
        VolumeErrors::TooLarge, {roundedText(edge), roundedText(bytes / 1e6, 3), roundedText(left / 1e6, 3)}, {}, {}};
  Result<SurfaceVolume> made = volumeOfSurface(surface, edge, progress.part(0.0, 0.7));
  if (!made) return made.error();
  auto snapshot = std::make_shared<VolumeSnapshot>();
  snapshot->volume = made->volume;
  snapshot->surface = VolumeSurface(made->volume, progress.part(0.7, 1.0));
  snapshot->source = source;
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return MadeVolume{std::move(snapshot), std::move(*made)};
}

}  // namespace handwheel
