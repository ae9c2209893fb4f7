// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/VolumeToImage.h"

#include "base/NumberText.h"
#include "process/SystemMemory.h"
#include "volume/VolumeErrors.h"

#include <limits>

namespace handwheel {

Result<ImageVolume> distancesOf(const SparseVolume& volume) {
  constexpr int kFar = std::numeric_limits<int>::max() / 16;
  VoxelIndex low = VoxelIndex::Constant(kFar), high = VoxelIndex::Constant(-kFar);
  volume.forEach([&](const VoxelIndex& at, const SparseVolume::Content&) {
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  });
  if (volume.isEmpty()) low = high = VoxelIndex::Zero();
  const Eigen::Vector3d sizes = (VolumeBlock::kSize * (high - low + VoxelIndex::Ones())).cast<double>();
  const double bytes = sizes.prod() * sizeof(float), left = static_cast<double>(systemMemory()) / 3.0;
  if (bytes > left)
    return Error{VolumeErrors::TooLarge,
                 {roundedText(volume.voxel()), roundedText(bytes / 1e6, 3), roundedText(left / 1e6, 3)},
                 {},
                 {}};
  const VoxelIndex first = VolumeBlock::kSize * low, size = sizes.cast<int>();
  ImageGrid grid{{size.x(), size.y(), size.z()}, volume.centre(first), volume.voxel() * Eigen::Matrix3d::Identity()};
  if (const Status checked = checkGrid(grid); !checked) return checked.error();
  const double unit = -volume.voxel() / VolumeBlock::kUnit;
  std::vector<float> distances(grid.count(), static_cast<float>(unit * VolumeBlock::kEmpty));
  volume.forEach([&](const VoxelIndex& at, const SparseVolume::Content& content) {
    const VoxelIndex corner = VolumeBlock::kSize * (at - low);
    for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
      const VoxelIndex voxel = corner + VoxelIndex(i & 7, i >> 3 & 7, i >> 6);
      const std::int16_t depth = content.block ? content.block->depths[static_cast<std::size_t>(i)]
                                               : (content.isFull ? VolumeBlock::kFull : VolumeBlock::kEmpty);
      const std::size_t row = static_cast<std::size_t>(voxel.z()) * static_cast<std::size_t>(size.y()) +
                              static_cast<std::size_t>(voxel.y());
      distances[row * static_cast<std::size_t>(size.x()) + static_cast<std::size_t>(voxel.x())] =
          static_cast<float>(unit * depth);
    }
  });
  return ImageVolume(grid, std::move(distances));
}

}  // namespace handwheel
