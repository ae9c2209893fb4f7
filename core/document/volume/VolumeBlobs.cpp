// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/VolumeBlobs.h"

#include "base/NumberText.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

namespace handwheel {
namespace {

constexpr std::int32_t kMostRegion = SparseVolume::kMostVoxels / 64;  // from the origin along an axis
constexpr std::size_t kMostChunks = 90'000;                           // fewer than a container has entries
constexpr std::size_t kChunk = std::size_t{1} << 19;  // numbers from which on a chunk takes no further region
constexpr int kBlocks = 512;                          // of a region
// Of a region: its number along x, y and z; for each of its blocks whether it is full, and whether it has samples; then
// the samples of those. All of 16 bits, the numbers as two of them.
constexpr std::size_t kHead = 6 + 2 * kBlocks / 16;

std::string nameOf(std::size_t chunk) {
  std::string digits = std::to_string(chunk);
  digits.insert(0, 4 - std::min<std::size_t>(4, digits.size()), '0');
  return "volume/chunks/" + digits;
}

VoxelIndex blockIn(const VoxelIndex& region, int i) {
  return 8 * region + VoxelIndex(i & 7, i >> 3 & 7, i >> 6);
}

void addRegion(const SparseVolume& volume, const VoxelIndex& region, std::vector<std::int16_t>& numbers) {
  const std::size_t head = numbers.size();
  numbers.resize(head + kHead, 0);
  for (int k = 0; k < 3; ++k) {
    const auto part = static_cast<std::uint32_t>(region[k]);
    numbers[head + static_cast<std::size_t>(2 * k)] = static_cast<std::int16_t>(part & 0xffff);
    numbers[head + static_cast<std::size_t>(2 * k + 1)] = static_cast<std::int16_t>(part >> 16);
  }
  const auto set = [&](std::size_t first, int i) {
    auto& word = numbers[head + first + static_cast<std::size_t>(i / 16)];
    word = static_cast<std::int16_t>(static_cast<std::uint16_t>(word) | 1u << i % 16);
  };
  for (int i = 0; i < kBlocks; ++i) {
    const SparseVolume::Content content = volume.content(blockIn(region, i));
    if (content.isFull) set(6, i);
    if (!content.block) continue;
    set(6 + kBlocks / 16, i);
    numbers.insert(numbers.end(), content.block->depths.begin(), content.block->depths.end());
  }
}

// A sample as the program writes them.
std::int16_t validSample(std::int16_t sample) {
  if (sample == 0) return 1;
  return std::max(sample, VolumeBlock::kEmpty);
}

// Adds the regions of a chunk to the volume; false when what follows in it makes no sense.
bool readChunk(std::span<const std::int16_t> numbers, SparseVolume& volume) {
  const auto unsignedAt = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<std::uint16_t>(numbers[i]));
  };
  const auto bit = [&](std::size_t first, int i) {
    return (unsignedAt(first + static_cast<std::size_t>(i / 16)) >> i % 16 & 1) != 0;
  };
  while (!numbers.empty()) {
    if (numbers.size() < kHead) return false;
    VoxelIndex region;
    for (int k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(2 * k);
      region[k] = static_cast<std::int32_t>(unsignedAt(at) | unsignedAt(at + 1) << 16);
      if (region[k] < -kMostRegion || region[k] >= kMostRegion) return false;
    }
    std::size_t next = kHead;
    for (int i = 0; i < kBlocks; ++i) {
      SparseVolume::Content content{nullptr, bit(6, i)};
      if (bit(6 + kBlocks / 16, i)) {
        if (next + VolumeBlock::kCount > numbers.size()) return false;
        auto block = std::make_shared<VolumeBlock>();
        const auto samples = numbers.subspan(next, VolumeBlock::kCount);
        std::transform(samples.begin(), samples.end(), block->depths.begin(), validSample);
        next += VolumeBlock::kCount;
        content = {std::move(block), false};
      }
      if (content.block || content.isFull) volume.setContent(blockIn(region, i), std::move(content));
    }
    numbers = numbers.subspan(next);
  }
  return true;
}

// Gives full blocks beside empty ones samples, so that a surface lies between them. False where that would be more than
// so many.
bool closeOff(SparseVolume& volume, std::size_t most) {
  std::vector<VoxelIndex> open;
  volume.forEach([&](const VoxelIndex& at, const SparseVolume::Content& content) {
    if (content.block) return;
    for (int k = 0; k < 6; ++k) {
      const SparseVolume::Content beside = volume.content(at + (k & 1 ? 1 : -1) * VoxelIndex::Unit(k / 2));
      if (beside.block || beside.isFull) continue;
      open.push_back(at);
      return;
    }
  });
  if (open.size() > most) return false;
  for (const VoxelIndex& at : open) {
    auto block = std::make_shared<VolumeBlock>();
    block->depths.fill(VolumeBlock::kFull);
    volume.setContent(at, {std::move(block), false});
  }
  return true;
}

}  // namespace

void writeVolume(const SparseVolume& volume, Container& container) {
  nlohmann::json& document = (*container.manifest)["document"];
  if (!document.is_object()) document = nlohmann::json::object();
  std::vector<VoxelIndex> regions;
  volume.forEach([&](const VoxelIndex& at, const SparseVolume::Content&) {
    const VoxelIndex region = SparseVolume::blockOf(at);  // 8³ blocks, as a block is of 8³ voxels
    if (regions.empty() || regions.back() != region) regions.push_back(region);
  });
  document["voxel"] = volume.voxel();
  document["origin"] = {volume.origin().x(), volume.origin().y(), volume.origin().z()};
  std::size_t chunks = 0;
  std::vector<std::int16_t> numbers;
  for (const VoxelIndex& region : regions) {
    addRegion(volume, region, numbers);
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
    return Error{ErrorCode::ElementMalformed, {"document.voxel", "it is no size of a voxel"}, {}, {}};
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
    damage.push_back({ErrorCode::ElementMalformed, {"document.chunks", "it is no number of chunks"}, {}, {}});
  const std::size_t chunks = isCount ? count.get<std::size_t>() : kMostChunks;
  std::size_t lost = 0, bytes = 0;
  for (std::size_t i = 0; i < chunks; ++i) {
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    progress.set(static_cast<double>(i) / static_cast<double>(chunks));
    const auto blob = container.blobs.find(nameOf(i));
    if (blob == container.blobs.end() && !isCount) break;
    if (blob != container.blobs.end()) bytes += blob->second.size();
    if (blob == container.blobs.end() || !readChunk(fromBlob<std::int16_t>(blob->second), volume)) ++lost;
  }
  if (lost > 0)
    damage.push_back({ErrorCode::ElementMalformed,
                      {"volume", std::to_string(lost) + " of its chunks are lost, or end early"},
                      {},
                      {}});
  // As other arrays of a container: at most 64 times its bytes.
  if (!closeOff(volume, 64 * bytes / sizeof(VolumeBlock)))
    return Error{ErrorCode::ElementMalformed, {"volume", "full and empty blocks have nothing between them"}, {}, {}};
  return volume;
}

}  // namespace handwheel
