// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/SparseVolume.h"

#include "base/SoleOwner.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace handwheel {
namespace {

constexpr int kKeyBits = 21;  // bits of a region's index along each axis: 2^27 voxels
constexpr std::int32_t kKeyOffset = 1 << (kKeyBits - 1);

VoxelIndex regionOfKey(std::uint64_t key) {
  const auto part = [&](int shift) {
    return static_cast<std::int32_t>((key >> shift) & ((1u << kKeyBits) - 1)) - kKeyOffset;
  };
  return {part(0), part(kKeyBits), part(2 * kKeyBits)};
}

}  // namespace

std::int16_t depthSample(double voxels) {
  // Rounds by truncation, as std::round is a function call.
  const double scaled = std::clamp(voxels * VolumeBlock::kUnit, -32767.0, 32767.0);
  const auto sample = static_cast<std::int16_t>(scaled + std::copysign(0.5, scaled));
  return sample != 0 ? sample : static_cast<std::int16_t>(voxels < 0.0 ? -1 : 1);
}

bool SparseVolume::Region::isEmpty() const {
  return full.none() && std::none_of(blocks.begin(), blocks.end(), [](const Block& b) { return b != nullptr; });
}

SparseVolume::Count SparseVolume::countOf(const Content& content) {
  constexpr std::uint64_t kAll = VolumeBlock::kCount, kVoxel = static_cast<std::uint64_t>(VolumeBlock::kUnit);
  if (!content.block) return content.isFull ? Count{kAll, kAll * kVoxel} : Count{};
  std::uint32_t inside = 0, enclosed = 0;  // below 2^22 for a block
  for (const std::int16_t depth : content.block->depths) {
    inside += depth > 0;
    enclosed += static_cast<std::uint32_t>(VolumeBlock::enclosed(depth));
  }
  return {inside, enclosed};
}

std::uint64_t SparseVolume::keyOf(const VoxelIndex& block) {
  std::uint64_t key = 0;
  for (int k = 2; k >= 0; --k) {
    const std::int32_t region = (block[k] >> 3) + kKeyOffset;
    assert(region >= 0 && region < 2 * kKeyOffset);
    key = key << kKeyBits | static_cast<std::uint32_t>(region);
  }
  return key;
}

std::size_t SparseVolume::indexOf(const VoxelIndex& block) {
  return VolumeBlock::at(block.x() & 7, block.y() & 7, block.z() & 7);
}

SparseVolume::Content SparseVolume::content(const VoxelIndex& block) const {
  const auto found = m_regions.find(keyOf(block));
  if (found == m_regions.end()) return {};
  const std::size_t index = indexOf(block);
  return {found->second->blocks[index], found->second->full[index]};
}

SparseVolume::View SparseVolume::view(const VoxelIndex& block) const {
  const auto found = m_regions.find(keyOf(block));
  if (found == m_regions.end()) return {};
  const std::size_t index = indexOf(block);
  return {found->second->blocks[index].get(), found->second->full[index]};
}

void SparseVolume::setContent(const VoxelIndex& block, Content content) {
  const std::uint64_t key = keyOf(block);
  auto found = m_regions.find(key);
  if (found == m_regions.end()) {
    if (!content.block && !content.isFull) return;
    found = m_regions.emplace(key, std::make_shared<Region>()).first;
  } else if (!isSoleOwner(found->second)) {
    found->second = std::make_shared<Region>(*found->second);
  }
  Region& region = *found->second;
  const std::size_t index = indexOf(block);
  if (region.blocks[index]) --m_blockCount;
  if (content.block) ++m_blockCount;
  const Count gone = countOf({region.blocks[index], region.full[index]}), added = countOf(content);
  m_count.inside += added.inside - gone.inside;  // modulo 2^64
  m_count.enclosed += added.enclosed - gone.enclosed;
  region.full[index] = !content.block && content.isFull;
  region.blocks[index] = std::move(content.block);
  if (region.isEmpty()) m_regions.erase(found);
}

bool SparseVolume::sharesRegion(const SparseVolume& other, const VoxelIndex& region) const {
  const std::uint64_t key = keyOf(8 * region);
  const auto own = m_regions.find(key), others = other.m_regions.find(key);
  const bool has = own != m_regions.end(), hasOther = others != other.m_regions.end();
  return has == hasOther && (!has || own->second == others->second);
}

std::int16_t SparseVolume::sample(const VoxelIndex& voxel) const {
  const View samples = view(blockOf(voxel));
  if (samples.block) return samples.block->depths[VolumeBlock::at(voxel.x() & 7, voxel.y() & 7, voxel.z() & 7)];
  return samples.isFull ? VolumeBlock::kFull : VolumeBlock::kEmpty;
}

void SparseVolume::forEach(const std::function<void(const VoxelIndex&, const Content&)>& visit) const {
  std::vector<std::uint64_t> keys;
  keys.reserve(m_regions.size());
  for (const auto& [key, region] : m_regions) keys.push_back(key);
  std::sort(keys.begin(), keys.end());
  for (const std::uint64_t key : keys) {
    const Region& region = *m_regions.at(key);
    const VoxelIndex first = 8 * regionOfKey(key);
    for (int i = 0; i < 512; ++i) {
      const auto index = static_cast<std::size_t>(i);
      if (region.blocks[index] || region.full[index])
        visit(first + VoxelIndex(i & 7, i >> 3 & 7, i >> 6), {region.blocks[index], region.full[index]});
    }
  }
}

std::vector<VoxelIndex> SparseVolume::blocks() const {
  std::vector<VoxelIndex> all;
  all.reserve(m_blockCount);
  forEach([&](const VoxelIndex& at, const Content& content) {
    if (content.block) all.push_back(at);
  });
  return all;
}

Box SparseVolume::extent() const {
  constexpr int kSide = 64;
  Box box;
  for (const auto& [key, region] : m_regions) {
    const Vec3 low = (kSide * regionOfKey(key)).cast<double>();
    box.extend(low - Vec3::Ones());
    box.extend(low + Vec3::Constant(kSide));
  }
  return box;
}

std::size_t SparseVolume::bytes() const {
  constexpr std::size_t kCounts = 16;  // control block of a shared pointer
  return sizeof *this + m_regions.size() * (sizeof(Region) + kCounts + 32) +
         m_blockCount * (sizeof(VolumeBlock) + kCounts);
}

}  // namespace handwheel
