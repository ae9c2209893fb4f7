// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/VolumeMaking.h"

#include "base/NumberText.h"
#include "document/Container.h"
#include "volume/VolumeErrors.h"

namespace handwheel {
Result<MadeVolume> makeVolume(const TriangleSoup& surface, std::optional<double> voxel, const std::string& source,
                              Progress progress) {
  const double edge = voxel.value_or(usualVoxel(surface));
  Result<SurfaceVolume> made = volumeOfSurface(surface, edge, progress.part(0.0, 0.7));
  if (!made) return made.error();
  constexpr double kMost = 0.95 * static_cast<double>(kLargestContainer);
  if (const auto bytes = static_cast<double>(made->volume.bytes()); bytes > kMost)
    return Error{VolumeErrors::TooLargeToSave,
                 {roundedText(edge), roundedText(bytes / 1e6, 3), roundedText(kMost / 1e6, 3)},
                 {},
                 {}};
  auto snapshot = std::make_shared<VolumeSnapshot>();
  snapshot->volume = made->volume;
  snapshot->surface = VolumeSurface(made->volume, progress.part(0.7, 1.0));
  snapshot->source = source;
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return MadeVolume{std::move(snapshot), std::move(*made)};
}

}  // namespace handwheel
