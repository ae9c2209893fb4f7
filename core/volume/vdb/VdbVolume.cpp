// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/vdb/VdbVolume.h"

#include "base/NumberText.h"
#include "volume/VolumeSerialization.h"
#include "volume/image/ImageHeader.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

std::string bytesOf(const VdbVolume& volume) {
  const Vec3& origin = volume.volume.origin();
  std::string bytes = shortestText(volume.volume.voxel());
  for (const double figure :
       {origin.x(), origin.y(), origin.z(), volume.isFog ? 1.0 : 0.0, static_cast<double>(volume.otherGrids)})
    bytes += " " + shortestText(figure);
  bytes += "\n";
  std::vector<std::int16_t> numbers;
  for (const VoxelIndex& region : regionsOf(volume.volume)) {
    numbers.clear();
    appendRegion(volume.volume, region, numbers);
    bytes.append(reinterpret_cast<const char*>(numbers.data()), 2 * numbers.size());
  }
  return bytes;
}

std::optional<VdbVolume> vdbVolumeIn(std::string_view bytes) {
  constexpr std::size_t kLongestLine = 256;
  const std::size_t end = bytes.substr(0, kLongestLine).find('\n');
  if (end == std::string_view::npos) return {};
  const auto figures = imageHeader::numbersOf(bytes.substr(0, end), 6);
  if (!figures) return {};
  const auto& f = *figures;
  if (!(f[0] > 1e-9 && f[0] < 1e9) || !(f[5] >= 0.0 && f[5] < 1e9)) return {};
  for (std::size_t k = 1; k < 4; ++k)
    if (std::abs(f[k]) > 1e12) return {};
  const std::string_view rest = bytes.substr(end + 1);
  if (rest.size() % 2 != 0) return {};
  std::vector<std::int16_t> numbers(rest.size() / 2);
  std::copy(rest.begin(), rest.end(), reinterpret_cast<char*>(numbers.data()));
  VdbVolume read{SparseVolume(Vec3(f[1], f[2], f[3]), f[0]), f[4] != 0.0, static_cast<std::size_t>(f[5])};
  if (!readRegions(numbers, read.volume)) return {};
  if (!closeOff(read.volume, 64 * rest.size() / sizeof(VolumeBlock))) return {};
  return read;
}

}  // namespace handwheel
