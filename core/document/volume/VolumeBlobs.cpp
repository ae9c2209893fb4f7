// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/VolumeBlobs.h"

#include "base/NumberText.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

constexpr std::int32_t kMostRegion = 1 << 17;  // from the origin along an axis
constexpr std::size_t kMostRegions = 90'000;   // fewer than a container has entries
constexpr int kBlocks = 512;                   // of a region
// Of a region: its number along x, y and z; for each of its blocks whether it is full, and whether it has samples; then
// the samples of those. All of 16 bits, the numbers as two of them.
constexpr std::size_t kHead = 6 + 2 * kBlocks / 16;

std::string nameOf(std::size_t region) {
  std::string digits = std::to_string(region);
  digits.insert(0, 4 - std::min<std::size_t>(4, digits.size()), '0');
  return "volume/regions/" + digits;
}

VoxelIndex blockIn(const VoxelIndex& region, int i) {
  return 8 * region + VoxelIndex(i & 7, i >> 3 & 7, i >> 6);
}

struct RegionBits {
  std::bitset<kBlocks> full, sampled;
};

std::vector<std::int16_t> regionNumbers(const SparseVolume& volume, const VoxelIndex& region) {
  std::vector<std::int16_t> numbers(kHead, 0);
  for (int k = 0; k < 3; ++k) {
    const auto part = static_cast<std::uint32_t>(region[k]);
    numbers[static_cast<std::size_t>(2 * k)] = static_cast<std::int16_t>(part & 0xffff);
    numbers[static_cast<std::size_t>(2 * k + 1)] = static_cast<std::int16_t>(part >> 16);
  }
  const auto set = [&](std::size_t first, int i) {
    auto& word = numbers[first + static_cast<std::size_t>(i / 16)];
    word = static_cast<std::int16_t>(static_cast<std::uint16_t>(word) | 1u << i % 16);
  };
  for (int i = 0; i < kBlocks; ++i) {
    const SparseVolume::Content content = volume.content(blockIn(region, i));
    if (content.isFull) set(6, i);
    if (!content.block) continue;
    set(6 + kBlocks / 16, i);
    numbers.insert(numbers.end(), content.block->depths.begin(), content.block->depths.end());
  }
  return numbers;
}

// A sample as the program writes them.
std::int16_t validSample(std::int16_t sample) {
  if (sample == 0) return 1;
  return std::max(sample, VolumeBlock::kEmpty);
}

// Adds a region to the volume; false when it makes no sense.
bool readRegion(const std::vector<std::int16_t>& numbers, SparseVolume& volume) {
  if (numbers.size() < kHead || (numbers.size() - kHead) % VolumeBlock::kCount != 0) return false;
  const auto unsignedAt = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<std::uint16_t>(numbers[i]));
  };
  VoxelIndex region;
  for (int k = 0; k < 3; ++k) {
    const auto at = static_cast<std::size_t>(2 * k);
    region[k] = static_cast<std::int32_t>(unsignedAt(at) | unsignedAt(at + 1) << 16);
    if (region[k] < -kMostRegion || region[k] > kMostRegion) return false;
  }
  const auto bit = [&](std::size_t first, int i) {
    return (unsignedAt(first + static_cast<std::size_t>(i / 16)) >> i % 16 & 1) != 0;
  };
  std::size_t next = kHead;
  for (int i = 0; i < kBlocks; ++i) {
    SparseVolume::Content content{nullptr, bit(6, i)};
    if (bit(6 + kBlocks / 16, i)) {
      if (next + VolumeBlock::kCount > numbers.size()) return false;
      auto block = std::make_shared<VolumeBlock>();
      std::transform(numbers.begin() + static_cast<std::ptrdiff_t>(next),
                     numbers.begin() + static_cast<std::ptrdiff_t>(next + VolumeBlock::kCount), block->depths.begin(),
                     validSample);
      next += VolumeBlock::kCount;
      content = {std::move(block), false};
    }
    if (content.block || content.isFull) volume.setContent(blockIn(region, i), std::move(content));
  }
  return next == numbers.size();
}

// Gives full blocks beside empty ones samples, so that a surface lies between them.
void closeOff(SparseVolume& volume) {
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
  for (const VoxelIndex& at : open) {
    auto block = std::make_shared<VolumeBlock>();
    block->depths.fill(VolumeBlock::kFull);
    volume.setContent(at, {std::move(block), false});
  }
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
  document["regions"] = regions.size();
  for (std::size_t i = 0; i < regions.size(); ++i)
    container.blobs[nameOf(i)] = toBlob(regionNumbers(volume, regions[i]));
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
  const nlohmann::json count = found->value("regions", nlohmann::json());
  const bool isCount = count.is_number_unsigned() && count.get<std::uint64_t>() <= kMostRegions;
  if (!isCount)
    damage.push_back({ErrorCode::ElementMalformed, {"document.regions", "it is no number of regions"}, {}, {}});
  const std::size_t regions = isCount ? count.get<std::size_t>() : kMostRegions;
  std::size_t lost = 0;
  for (std::size_t i = 0; i < regions; ++i) {
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    progress.set(static_cast<double>(i) / static_cast<double>(regions));
    const auto blob = container.blobs.find(nameOf(i));
    if (blob == container.blobs.end() && !isCount) break;
    if (blob == container.blobs.end() || !readRegion(fromBlob<std::int16_t>(blob->second), volume)) ++lost;
  }
  if (lost > 0)
    damage.push_back(
        {ErrorCode::ElementMalformed, {"volume", std::to_string(lost) + " of its regions are lost"}, {}, {}});
  closeOff(volume);
  return volume;
}

}  // namespace handwheel
