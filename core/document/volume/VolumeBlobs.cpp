// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/VolumeBlobs.h"

#include "base/NumberText.h"
#include "volume/VolumeRegions.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

constexpr std::size_t kMostChunks = 90'000;           // fewer than a container has entries
constexpr std::size_t kChunk = std::size_t{1} << 19;  // numbers from which on a chunk takes no further region

std::string nameOf(std::size_t chunk) {
  std::string digits = std::to_string(chunk);
  digits.insert(0, 4 - std::min<std::size_t>(4, digits.size()), '0');
  return "volume/chunks/" + digits;
}

}  // namespace

void writeVolume(const SparseVolume& volume, Container& container) {
  nlohmann::json& document = (*container.manifest)["document"];
  if (!document.is_object()) document = nlohmann::json::object();
  const std::vector<VoxelIndex> regions = regionsOf(volume);
  document["voxel"] = volume.voxel();
  document["origin"] = {volume.origin().x(), volume.origin().y(), volume.origin().z()};
  std::size_t chunks = 0;
  std::vector<std::int16_t> numbers;
  for (const VoxelIndex& region : regions) {
    appendRegion(volume, region, numbers);
    if (numbers.size() < kChunk && region != regions.back()) continue;
    container.blobs[nameOf(chunks++)] = toBlob(numbers);
    numbers.clear();
  }
  document["chunks"] = chunks;
}

Result<SparseVolume> readVolume(const Container& container, std::vector<Error>& damage, Progress progress) {
  const auto found = container.manifest->find("document");
  if (found == container.manifest->end() || !found->is_object())
    return Error{ErrorCode::ElementMalformed, {"document", "it is missing"}, {}, {}};
  const nlohmann::json voxel = found->value("voxel", nlohmann::json()),
                       origin = found->value("origin", nlohmann::json());
  if (!voxel.is_number() || !(voxel.get<double>() > 1e-9) || !(voxel.get<double>() < 1e9))
    return Error{ErrorCode::ElementMalformed, {"document.voxel", "it is not the size of a voxel"}, {}, {}};
  Vec3 corner = Vec3::Zero();
  bool isPlace = origin.is_array() && origin.size() == 3;
  for (std::size_t k = 0; k < 3 && isPlace; ++k) {
    isPlace = origin[k].is_number() && std::abs(origin[k].get<double>()) < 1e12;
    if (isPlace) corner[static_cast<Eigen::Index>(k)] = origin[k].get<double>();
  }
  if (!isPlace) return Error{ErrorCode::ElementMalformed, {"document.origin", "it is no place"}, {}, {}};

  SparseVolume volume(corner, voxel.get<double>());
  const nlohmann::json count = found->value("chunks", nlohmann::json());
  const bool isCount = count.is_number_unsigned() && count.get<std::uint64_t>() <= kMostChunks;
  if (!isCount)
    damage.push_back({ErrorCode::ElementMalformed, {"document.chunks", "it is not a number of chunks"}, {}, {}});
  const std::size_t chunks = isCount ? count.get<std::size_t>() : kMostChunks;
  std::size_t lost = 0, bytes = 0;
  for (std::size_t i = 0; i < chunks; ++i) {
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    progress.set(static_cast<double>(i) / static_cast<double>(chunks));
    const auto blob = container.blobs.find(nameOf(i));
    if (blob == container.blobs.end() && !isCount) break;
    if (blob != container.blobs.end()) bytes += blob->second.size();
    if (blob == container.blobs.end() || !readRegions(fromBlob<std::int16_t>(blob->second), volume)) ++lost;
  }
  if (lost > 0)
    damage.push_back({ErrorCode::ElementMalformed,
                      {"volume", std::to_string(lost) + " of its chunks are lost, or end early"},
                      {},
                      {}});
  // As other arrays of a container: at most 64 times its bytes.
  if (!closeOff(volume, 64 * bytes / sizeof(VolumeBlock)))
    return Error{ErrorCode::ElementMalformed, {"volume", "full and empty blocks have no surface between them"}, {}, {}};
  return volume;
}

}  // namespace handwheel
