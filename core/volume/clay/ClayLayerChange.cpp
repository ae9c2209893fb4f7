// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/clay/ClayLayerChange.h"

#include "volume/VolumeDifference.h"
#include "volume/repair/Eikonal.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace handwheel {
namespace {

constexpr float kKnown = ClayLayerChange::kKnownDepth;
constexpr float kUnknown = std::numeric_limits<float>::infinity();
constexpr std::size_t kNoBlock = std::numeric_limits<std::size_t>::max();
constexpr float kBucket = 0.25f;  // voxels of distance that are dealt with together: less than a step of the front

using Neighbours = std::array<std::size_t, 6>;  // their numbers: -x, x, -y, y, -z, z

std::size_t numberIn(const std::vector<VoxelIndex>& blocks, const VoxelIndex& block) {
  const auto found = std::lower_bound(blocks.begin(), blocks.end(), block, isBlockBefore);
  return found != blocks.end() && *found == block ? static_cast<std::size_t>(found - blocks.begin()) : kNoBlock;
}

std::vector<Neighbours> neighboursOf(const std::vector<VoxelIndex>& blocks) {
  std::vector<Neighbours> all(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i)
    for (std::size_t side = 0; side < 6; ++side) {
      const VoxelIndex step = (side & 1 ? 1 : -1) * VoxelIndex::Unit(static_cast<Eigen::Index>(side / 2));
      all[i][side] = numberIn(blocks, blocks[i] + step);
    }
  return all;
}

// Connected blocks have the same number.
std::vector<std::size_t> groupsOf(const std::vector<Neighbours>& neighbours) {
  std::vector<std::size_t> groups(neighbours.size(), kNoBlock), waiting;
  for (std::size_t first = 0; first < groups.size(); ++first) {
    if (groups[first] != kNoBlock) continue;
    groups[first] = first;
    waiting = {first};
    while (!waiting.empty()) {
      const std::size_t block = waiting.back();
      waiting.pop_back();
      for (const std::size_t beside : neighbours[block]) {
        if (beside == kNoBlock || groups[beside] != kNoBlock) continue;
        groups[beside] = first;
        waiting.push_back(beside);
      }
    }
  }
  return groups;
}

// Distances of the voxels of some blocks from the surface of a volume, by a front that goes outwards from it.
class DistanceFront {
 public:
  DistanceFront(const SparseVolume& volume, const std::vector<VoxelIndex>& blocks,
                const std::vector<Neighbours>& neighbours)
      : m_neighbours(neighbours),
        m_distances(blocks.size() * VolumeBlock::kCount, kUnknown),
        m_isInside(m_distances.size(), 0),
        m_isFixed(m_distances.size(), 0) {
    for (std::size_t i = 0; i < blocks.size(); ++i) seed(volume.view(blocks[i]), i * VolumeBlock::kCount);
    for (std::size_t index = 0; index < m_distances.size(); ++index)
      if (m_isFixed[index]) reach(index);
    for (; m_bucket < m_buckets.size(); ++m_bucket) {
      // reach() adds to this bucket and to those after it.
      for (std::size_t i = 0; i < m_buckets[m_bucket].size(); ++i) {
        const std::size_t index = m_buckets[m_bucket][i];
        if (m_isFixed[index]) continue;
        m_isFixed[index] = 1;
        reach(index);
      }
      m_buckets[m_bucket] = {};
    }
    for (std::size_t i = 0; i < blocks.size(); ++i) keepSamples(volume.view(blocks[i]), i * VolumeBlock::kCount);
  }

  float distance(std::size_t index) const { return m_distances[index]; }  // infinite: no surface is in the blocks
  bool isInside(std::size_t index) const { return m_isInside[index] != 0; }

 private:
  void seed(const SparseVolume::View& view, std::size_t first) {
    for (std::size_t i = 0; i < VolumeBlock::kCount; ++i) {
      const std::size_t index = first + i;
      m_isInside[index] = view.block ? view.block->depths[i] > 0 : view.isFull;
      if (!view.block) continue;
      const float depth =
          std::abs(static_cast<float>(view.block->depths[i])) * static_cast<float>(1.0 / VolumeBlock::kUnit);
      if (depth >= kKnown) continue;
      m_distances[index] = depth;
      m_isFixed[index] = 1;
    }
  }
  // Distances near the surface are those of the samples, so that a share close to 1 gives nearly the samples of the
  // layer.
  void keepSamples(const SparseVolume::View& view, std::size_t first) {
    for (std::size_t i = 0; i < VolumeBlock::kCount; ++i) {
      float& distance = m_distances[first + i];
      const int sample = view.block ? std::abs(static_cast<int>(view.block->depths[i])) : int{VolumeBlock::kFull};
      // The deepest one says "at least kKnown": some volumes know no more than that.
      if (sample < ClayLayerChange::kDeepestSample)
        distance = static_cast<float>(sample) * static_cast<float>(1.0 / VolumeBlock::kUnit);
    }
  }
  // The voxel beside another one along an axis; kNoBlock: it is in none of the blocks.
  std::size_t beside(std::size_t index, std::size_t side) const {
    const std::size_t axis = side / 2, stride = std::size_t{1} << 3 * axis, along = index >> 3 * axis & 7;
    const bool isUp = side & 1;
    if (isUp ? along < 7 : along > 0) return isUp ? index + stride : index - stride;
    const std::size_t block = m_neighbours[index / VolumeBlock::kCount][side];
    if (block == kNoBlock) return kNoBlock;
    const std::size_t in = index % VolumeBlock::kCount;
    return block * VolumeBlock::kCount + (isUp ? in - 7 * stride : in + 7 * stride);
  }
  // Tells the neighbours of a voxel whose distance is fixed.
  void reach(std::size_t index) {
    for (std::size_t side = 0; side < 6; ++side) {
      const std::size_t next = beside(index, side);
      if (next == kNoBlock || m_isFixed[next] || m_isInside[next] != m_isInside[index]) continue;
      std::array<float, 3> nearest{kUnknown, kUnknown, kUnknown};
      for (std::size_t k = 0; k < 6; ++k) {
        const std::size_t other = beside(next, k);
        if (other == kNoBlock || !m_isFixed[other] || m_isInside[other] != m_isInside[next]) continue;
        nearest[k / 2] = std::min(nearest[k / 2], m_distances[other]);
      }
      const float distance = std::max(kKnown, eikonalDistance(nearest));
      if (!(distance < m_distances[next])) continue;
      m_distances[next] = distance;
      // Never an already processed bucket, regardless of rounding.
      const std::size_t bucket = std::max(m_bucket, static_cast<std::size_t>(distance / kBucket));
      if (bucket >= m_buckets.size()) m_buckets.resize(bucket + 1);
      m_buckets[bucket].push_back(next);
    }
  }

  const std::vector<Neighbours>& m_neighbours;
  std::vector<float> m_distances;  // by the number of the block, and the voxel in it
  std::vector<std::uint8_t> m_isInside;
  std::vector<std::uint8_t> m_isFixed;
  std::vector<std::vector<std::size_t>> m_buckets;  // voxels that the front has come to, by their distance
  std::size_t m_bucket = 0;                         // bucket that is being processed
};

// Weight 1 near a surface, where the samples of the two volumes differ, and 0 where both are far inside or far outside,
// so that a change ends without a step at the border of its blocks.
float shareOfChange(float base, float top) {
  if ((base > 0.0f) != (top > 0.0f)) return 1.0f;
  return std::clamp(kKnown + 1.0f - std::min(std::abs(base), std::abs(top)), 0.0f, 1.0f);
}

std::vector<ClayLayerChange::Distances> layerDistances(const SparseVolume& base, const SparseVolume& top,
                                                       const std::vector<VoxelIndex>& blocks) {
  const std::vector<Neighbours> neighbours = neighboursOf(blocks);
  const std::vector<std::size_t> groups = groupsOf(neighbours);
  const DistanceFront before(base, blocks, neighbours), after(top, blocks, neighbours);
  // Without any surface, as before a ball in the air, its distance is the largest distance of the other surface.
  std::vector<float> farthest(blocks.size(), kKnown + 1.0f);  // largest distance in each group
  const std::size_t count = blocks.size() * VolumeBlock::kCount;
  for (std::size_t index = 0; index < count; ++index) {
    float& most = farthest[groups[index / VolumeBlock::kCount]];
    for (const DistanceFront* front : {&before, &after})
      if (front->distance(index) < kUnknown) most = std::max(most, front->distance(index));
  }
  std::vector<ClayLayerChange::Distances> all(blocks.size());
  for (std::size_t index = 0; index < count; ++index) {
    const std::size_t block = index / VolumeBlock::kCount, i = index % VolumeBlock::kCount;
    const auto depth = [&](const DistanceFront& front) {
      const float distance = std::min(front.distance(index), farthest[groups[block]]);
      return front.isInside(index) ? distance : -distance;
    };
    const float from = depth(before), to = depth(after);
    all[block].base[i] = from;
    all[block].change[i] = shareOfChange(from, to) * (to - from);
  }
  return all;
}

}  // namespace

ClayLayerChange::ClayLayerChange(const SparseVolume& base, const SparseVolume& top)
    : m_blocks(differingBlocks(base, top)), m_base(onlyBlocks(base, m_blocks)), m_top(onlyBlocks(top, m_blocks)) {}

std::size_t ClayLayerChange::numberOf(const VoxelIndex& block) const {
  return numberIn(m_blocks, block);
}

bool ClayLayerChange::changes(const VoxelIndex& block) const {
  return numberOf(block) != kNoBlock;
}

const ClayLayerChange::Distances* ClayLayerChange::distances(const VoxelIndex& block) const {
  const std::size_t number = numberOf(block);
  if (number == kNoBlock) return nullptr;
  std::call_once(m_once, [this] { m_distances = layerDistances(m_base, m_top, m_blocks); });
  return &m_distances[number];
}

std::size_t ClayLayerChange::bytes() const {
  std::size_t bytes = sizeof *this + m_blocks.size() * sizeof(VoxelIndex);
  for (const VoxelIndex& block : m_blocks)
    for (const SparseVolume* volume : {&m_base, &m_top})
      if (volume->view(block).block) bytes += sizeof(VolumeBlock);
  return bytes;
}

}  // namespace handwheel
