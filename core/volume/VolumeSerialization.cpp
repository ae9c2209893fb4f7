// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeSerialization.h"

#include <algorithm>

namespace handwheel {
namespace {

constexpr std::int32_t kMostRegion = SparseVolume::kMostVoxels / 64;  // from the origin along an axis
constexpr int kRegionBlocks = 512;                                    // blocks of a region
constexpr std::size_t kRegionHead = 6 + 2 * kRegionBlocks / 16;

VoxelIndex blockIn(const VoxelIndex& region, int i) {
  return 8 * region + VoxelIndex(i & 7, i >> 3 & 7, i >> 6);
}

// A sample as the program writes them.
std::int16_t validSample(std::int16_t sample) {
  if (sample == 0) return 1;
  return std::max(sample, VolumeBlock::kEmpty);
}

}  // namespace

std::vector<VoxelIndex> regionsOf(const SparseVolume& volume) {
  std::vector<VoxelIndex> regions;
  volume.forEach([&](const VoxelIndex& at, const SparseVolume::Content&) {
    const VoxelIndex region = SparseVolume::blockOf(at);  // 8³ blocks, as a block is of 8³ voxels
    if (regions.empty() || regions.back() != region) regions.push_back(region);
  });
  return regions;
}

void appendRegion(const SparseVolume& volume, const VoxelIndex& region, std::vector<std::int16_t>& numbers) {
  const std::size_t head = numbers.size();
  numbers.resize(head + kRegionHead, 0);
  for (int k = 0; k < 3; ++k) {
    const auto part = static_cast<std::uint32_t>(region[k]);
    numbers[head + static_cast<std::size_t>(2 * k)] = static_cast<std::int16_t>(part & 0xffff);
    numbers[head + static_cast<std::size_t>(2 * k + 1)] = static_cast<std::int16_t>(part >> 16);
  }
  const auto set = [&](std::size_t first, int i) {
    auto& word = numbers[head + first + static_cast<std::size_t>(i / 16)];
    word = static_cast<std::int16_t>(static_cast<std::uint16_t>(word) | 1u << i % 16);
  };
  for (int i = 0; i < kRegionBlocks; ++i) {
    const SparseVolume::Content content = volume.content(blockIn(region, i));
    if (content.isFull) set(6, i);
    if (!content.block) continue;
    set(6 + kRegionBlocks / 16, i);
    numbers.insert(numbers.end(), content.block->depths.begin(), content.block->depths.end());
  }
}

bool readRegions(std::span<const std::int16_t> numbers, SparseVolume& volume) {
  const auto unsignedAt = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<std::uint16_t>(numbers[i]));
  };
  const auto bit = [&](std::size_t first, int i) {
    return (unsignedAt(first + static_cast<std::size_t>(i / 16)) >> i % 16 & 1) != 0;
  };
  while (!numbers.empty()) {
    if (numbers.size() < kRegionHead) return false;
    VoxelIndex region;
    for (int k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(2 * k);
      region[k] = static_cast<std::int32_t>(unsignedAt(at) | unsignedAt(at + 1) << 16);
      if (region[k] < -kMostRegion || region[k] >= kMostRegion) return false;
    }
    std::size_t next = kRegionHead;
    for (int i = 0; i < kRegionBlocks; ++i) {
      SparseVolume::Content content{nullptr, bit(6, i)};
      if (bit(6 + kRegionBlocks / 16, i)) {
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

}  // namespace handwheel
