// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/VolumeChunks.h"

#include "volume/VolumeSerialization.h"

#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

constexpr std::size_t kMostChunks = 90'000;           // fewer than a container has entries
constexpr std::size_t kChunk = std::size_t{1} << 19;  // numbers from which on a chunk takes no further region

std::string nameOf(const std::string& folder, std::size_t chunk) {
  std::string digits = std::to_string(chunk);
  digits.insert(0, 4 - std::min<std::size_t>(4, digits.size()), '0');
  return folder + digits;
}

}  // namespace

nlohmann::json gridOf(const SparseVolume& volume) {
  return {{"voxel", volume.voxel()}, {"origin", {volume.origin().x(), volume.origin().y(), volume.origin().z()}}};
}

std::size_t writeChunks(const SparseVolume& volume, const std::string& folder, Container& container) {
  const std::vector<VoxelIndex> regions = regionsOf(volume);
  std::size_t chunks = 0;
  std::vector<std::int16_t> numbers;
  for (const VoxelIndex& region : regions) {
    appendRegion(volume, region, numbers);
    if (numbers.size() < kChunk && region != regions.back()) continue;
    container.blobs[nameOf(folder, chunks++)] = toBlob(numbers);
    numbers.clear();
  }
  return chunks;
}

ChunksRead readChunks(const Container& container, const std::string& folder, std::optional<std::size_t> count,
                      SparseVolume& volume, const Progress& progress) {
  ChunksRead read;
  const std::size_t chunks = count.value_or(kMostChunks);
  for (std::size_t i = 0; i < chunks && !progress.cancelled(); ++i) {
    progress.set(static_cast<double>(i) / static_cast<double>(chunks));
    const auto blob = container.blobs.find(nameOf(folder, i));
    if (blob == container.blobs.end() && !count) break;
    if (blob != container.blobs.end()) read.bytes += blob->second.size();
    if (blob == container.blobs.end() || !readRegions(fromBlob<std::int16_t>(blob->second), volume)) ++read.lost;
  }
  return read;
}

std::optional<std::size_t> chunkCountOf(const nlohmann::json& value) {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > kMostChunks) return std::nullopt;
  return value.get<std::size_t>();
}

}  // namespace handwheel
