// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeParts.h"

#include "volume/VolumeFilters.h"
#include "volume/VolumeMemory.h"

#include <algorithm>
#include <numeric>

namespace handwheel {
namespace {

constexpr int kSize = VolumeBlock::kSize;

// Sets that are joined (Tarjan 1975, with path halving).
class Sets {
 public:
  explicit Sets(std::size_t count) : m_parents(count) { std::iota(m_parents.begin(), m_parents.end(), 0u); }

  std::uint32_t of(std::uint32_t i) {
    while (m_parents[i] != i) i = m_parents[i] = m_parents[m_parents[i]];
    return i;
  }
  // The smaller number is that of the set.
  void join(std::uint32_t a, std::uint32_t b) {
    a = of(a);
    b = of(b);
    if (a != b) m_parents[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> m_parents;
};

// Labels connected voxels in a block from 1 on. Returns the number of labels.
template <class Labels>
int label(const VolumeBlock& block, Labels& labels) {
  labels.fill(0);
  int count = 0;
  std::array<std::uint16_t, VolumeBlock::kCount> open;
  for (std::size_t start = 0; start < VolumeBlock::kCount; ++start) {
    if (block.depths[start] <= 0 || labels[start] != 0) continue;
    const auto number = static_cast<std::uint16_t>(++count);
    std::size_t waiting = 0;
    labels[start] = number;
    open[waiting++] = static_cast<std::uint16_t>(start);
    while (waiting > 0) {
      const int at = open[--waiting];
      const std::array<int, 3> position{at & 7, at >> 3 & 7, at >> 6};
      for (std::size_t k = 0; k < 3; ++k)
        for (const int step : {-1, 1}) {
          if (position[k] + step < 0 || position[k] + step >= kSize) continue;
          const auto next = static_cast<std::size_t>(at + step * (1 << 3 * k));
          if (block.depths[next] <= 0 || labels[next] != 0) continue;
          labels[next] = number;
          open[waiting++] = static_cast<std::uint16_t>(next);
        }
    }
  }
  return count;
}

struct IndexHash {
  std::size_t operator()(const VoxelIndex& at) const {
    const auto bits = [](int i) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)); };
    std::uint64_t mixed =
        bits(at.x()) * 0x9e3779b97f4a7c15u ^ bits(at.y()) * 0xc2b2ae3d27d4eb4fu ^ bits(at.z()) * 0x165667b19e3779f9u;
    return static_cast<std::size_t>(mixed ^ mixed >> 32);
  }
};

}  // namespace

std::optional<Error> VolumeParts::refusal(const SparseVolume& volume) {
  constexpr double kMapNode = 64.0;  // bytes of a block in a map
  constexpr double kBytes = sizeof(Labels) + sizeof(Labelled) + sizeof(VolumeBlock) + 2.0 * kMapNode;
  return memoryRefusal(volume.voxel(), kBytes * static_cast<double>(volume.blockCount()));
}

VolumeParts::VolumeParts(const SparseVolume& volume, Progress progress) : m_volume(volume) {
  std::unordered_map<VoxelIndex, std::size_t, IndexHash> indices;
  std::uint32_t numbers = 0;
  volume.forEach([&](const VoxelIndex& at, const SparseVolume::Content& content) {
    if (progress.cancelled()) return;
    Labelled block{at, numbers, nullptr};
    if (content.block) {
      block.labels = std::make_unique<Labels>();
      const int count = label(*content.block, *block.labels);
      if (count == 0) return;
      numbers += static_cast<std::uint32_t>(count);
    } else {
      ++numbers;
    }
    indices.emplace(at, m_blocks.size());
    m_blocks.push_back(std::move(block));
  });
  if (progress.cancelled()) return;
  progress.set(0.4);

  // Connects the labels across the faces between neighbouring blocks.
  Sets sets(numbers);
  std::vector<std::uint64_t> voxels(numbers, 0);
  for (const Labelled& block : m_blocks) {
    if (progress.cancelled()) return;
    if (!block.labels) voxels[block.first] += VolumeBlock::kCount;
    if (block.labels)
      for (const std::uint16_t number : *block.labels)
        if (number != 0) ++voxels[block.first + number - 1u];
    for (int k = 0; k < 3; ++k) {
      const auto beside = indices.find(block.at + VoxelIndex::Unit(k));
      if (beside == indices.end()) continue;
      const Labelled& next = m_blocks[beside->second];
      const int step = 1 << 3 * k, across = 1 << 3 * ((k + 1) % 3), along = 1 << 3 * ((k + 2) % 3);
      for (int j = 0; j < kSize * kSize; ++j) {
        const auto here = static_cast<std::size_t>((j & 7) * across + (j >> 3) * along + (kSize - 1) * step);
        const auto there = here - static_cast<std::size_t>((kSize - 1) * step);
        const bool isBoth =
            (!block.labels || (*block.labels)[here] != 0) && (!next.labels || (*next.labels)[there] != 0);
        if (isBoth) sets.join(numberOf(block, here), numberOf(next, there));
      }
    }
  }
  progress.set(0.9);

  std::vector<std::uint32_t> roots;
  for (std::uint32_t i = 0; i < numbers; ++i) {
    if (sets.of(i) == i)
      roots.push_back(i);
    else
      voxels[sets.of(i)] += voxels[i];
  }
  std::stable_sort(roots.begin(), roots.end(), [&](std::uint32_t a, std::uint32_t b) { return voxels[a] > voxels[b]; });
  std::vector<std::uint32_t> ranks(numbers, 0);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    ranks[roots[i]] = static_cast<std::uint32_t>(i);
    m_voxels.push_back(voxels[roots[i]]);
  }
  m_parts.resize(numbers);
  for (std::uint32_t i = 0; i < numbers; ++i) m_parts[i] = ranks[sets.of(i)];
}

std::size_t VolumeParts::countFrom(std::uint64_t voxels) const {
  const auto end =
      std::partition_point(m_voxels.begin(), m_voxels.end(), [voxels](std::uint64_t own) { return own >= voxels; });
  return static_cast<std::size_t>(end - m_voxels.begin());
}

std::vector<std::optional<std::size_t>> VolumeParts::partsOf(std::span<const VoxelIndex> voxels) const {
  std::unordered_map<VoxelIndex, std::size_t, IndexHash> indices;
  indices.reserve(m_blocks.size());
  for (std::size_t i = 0; i < m_blocks.size(); ++i) indices.emplace(m_blocks[i].at, i);
  std::vector<std::optional<std::size_t>> parts(voxels.size());
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const VoxelIndex& at = voxels[i];
    const auto found = indices.find(SparseVolume::blockOf(at));
    if (found == indices.end()) continue;
    const Labelled& block = m_blocks[found->second];
    const std::size_t inBlock = VolumeBlock::at(at.x() & 7, at.y() & 7, at.z() & 7);
    if (!block.labels || (*block.labels)[inBlock] != 0) parts[i] = m_parts[numberOf(block, inBlock)];
  }
  return parts;
}

SparseVolume VolumeParts::without(const std::vector<bool>& kept) const {
  SparseVolume volume = m_volume;
  for (const Labelled& block : m_blocks) {
    if (!block.labels) {
      if (!kept[m_parts[block.first]]) volume.setContent(block.at, {});
      continue;
    }
    std::shared_ptr<VolumeBlock> samples;
    for (std::size_t i = 0; i < VolumeBlock::kCount; ++i) {
      if ((*block.labels)[i] == 0 || kept[m_parts[numberOf(block, i)]]) continue;
      if (!samples) samples = samplesOf(m_volume.content(block.at));
      samples->depths[i] = static_cast<std::int16_t>(-samples->depths[i]);
    }
    if (samples) volume.setContent(block.at, {std::move(samples), false});
  }
  return volume;
}

SparseVolume VolumeParts::only(std::size_t first, std::size_t end, Progress progress) const {
  const auto isKept = [&](std::uint32_t number) { return m_parts[number] >= first && m_parts[number] < end; };
  SparseVolume volume = m_volume;
  std::vector<VoxelIndex> changed;
  for (const Labelled& block : m_blocks) {
    if (progress.cancelled()) return m_volume;
    if (!block.labels) {
      if (!isKept(block.first)) volume.setContent(block.at, {});
      continue;
    }
    std::shared_ptr<VolumeBlock> samples;
    for (std::size_t i = 0; i < VolumeBlock::kCount; ++i) {
      if ((*block.labels)[i] == 0 || isKept(numberOf(block, i))) continue;
      if (!samples) samples = samplesOf(m_volume.content(block.at));
      samples->depths[i] = VolumeBlock::kEmpty;
    }
    if (!samples) continue;
    volume.setContent(block.at, {std::move(samples), false});
    changed.push_back(block.at);
  }
  makeDistances(volume, changed, DepthWindow::Beside::Kept, progress);
  return volume;
}

}  // namespace handwheel
