// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeParts.h"

#include "volume/DepthWindow.h"
#include "volume/VolumeFilters.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace handwheel {
namespace {

constexpr int kPieceSide = VolumeBlock::kSize;

// Sets that are joined step by step; the number of a set is its least member.
class JoinedSets {
 public:
  std::uint32_t add() {
    m_parents.push_back(static_cast<std::uint32_t>(m_parents.size()));
    return m_parents.back();
  }
  std::uint32_t find(std::uint32_t i) {
    while (m_parents[i] != i) i = m_parents[i] = m_parents[m_parents[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    m_parents[std::max(a, b)] = std::min(a, b);
  }
  std::size_t size() const { return m_parents.size(); }

 private:
  std::vector<std::uint32_t> m_parents;
};

// The pieces of a block's inside, each with a number; 0 is outside. A full block is one piece.
struct BlockPieces {
  std::array<std::uint16_t, VolumeBlock::kCount> number{};
  std::uint16_t count = 0;
};

BlockPieces piecesOf(const SparseVolume::View& view) {
  BlockPieces pieces;
  if (!view.block) {
    pieces.number.fill(view.isFull ? 1 : 0);
    pieces.count = view.isFull ? 1 : 0;
    return pieces;
  }
  std::array<std::uint16_t, VolumeBlock::kCount> waiting;
  const auto& depths = view.block->depths;
  for (std::size_t first = 0; first < VolumeBlock::kCount; ++first) {
    if (depths[first] <= 0 || pieces.number[first] != 0) continue;
    pieces.number[first] = ++pieces.count;
    std::size_t count = 0;
    waiting[count++] = static_cast<std::uint16_t>(first);
    while (count > 0) {
      const int at = waiting[--count];
      for (int axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1}) {
          const int along = (at >> 3 * axis & 7) + step;
          if (along < 0 || along >= kPieceSide) continue;
          const auto to = static_cast<std::size_t>(at + step * (1 << 3 * axis));
          if (depths[to] <= 0 || pieces.number[to] != 0) continue;
          pieces.number[to] = pieces.count;
          waiting[count++] = static_cast<std::uint16_t>(to);
        }
    }
  }
  return pieces;
}

// All pieces of a volume, joined to parts.
class Labelling {
 public:
  explicit Labelling(const SparseVolume& volume) : m_volume(volume) {
    volume.forEach([&](const VoxelIndex& at, const SparseVolume::Content& content) {
      const BlockPieces pieces = piecesOf({content.block.get(), content.isFull});
      if (pieces.count == 0) return;
      m_firsts[keyOf(at)] = static_cast<std::uint32_t>(m_sets.size());
      m_blocks.push_back(at);
      const std::size_t first = m_sizes.size();
      m_sizes.resize(first + pieces.count, 0);
      for (std::uint16_t i = 0; i < pieces.count; ++i) m_sets.add();
      for (const std::uint16_t number : pieces.number)
        if (number != 0) ++m_sizes[first + number - 1];
    });
    for (const VoxelIndex& at : m_blocks) joinAround(at);
    gather();
  }

  const std::vector<VoxelIndex>& blocks() const { return m_blocks; }
  VolumeParts parts() const {
    VolumeParts parts;
    for (const std::uint32_t part : m_order) parts.voxels.push_back(m_sizes[part]);
    return parts;
  }
  // The place of a piece's part in their order. number: from 1.
  std::uint32_t rankOf(const VoxelIndex& block, std::uint16_t number) {
    return m_ranks[m_sets.find(m_firsts.at(keyOf(block)) + number - 1)];
  }

 private:
  static std::uint64_t keyOf(const VoxelIndex& at) {
    std::uint64_t key = 0;
    for (int k = 0; k < 3; ++k) key = key << 21 | (static_cast<std::uint32_t>(at[k]) & 0x1fffffu);
    return key;
  }

  // With the blocks after it along each axis.
  void joinAround(const VoxelIndex& at) {
    const BlockPieces own = piecesOf(m_volume.view(at));
    const std::uint32_t first = m_firsts.at(keyOf(at));
    for (int axis = 0; axis < 3; ++axis) {
      const VoxelIndex next = at + VoxelIndex::Unit(axis);
      const auto found = m_firsts.find(keyOf(next));
      if (found == m_firsts.end()) continue;
      const BlockPieces other = piecesOf(m_volume.view(next));
      const int last = (kPieceSide - 1) << 3 * axis;
      for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
        if ((i & last) != last) continue;
        const std::uint16_t a = own.number[static_cast<std::size_t>(i)],
                            b = other.number[static_cast<std::size_t>(i - last)];
        if (a != 0 && b != 0) m_sets.join(first + a - 1, found->second + b - 1);
      }
    }
  }

  void gather() {
    for (std::uint32_t i = 0; i < m_sizes.size(); ++i) {
      const std::uint32_t part = m_sets.find(i);
      if (part == i)
        m_order.push_back(i);
      else
        m_sizes[part] += m_sizes[i];
    }
    std::stable_sort(m_order.begin(), m_order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return m_sizes[a] > m_sizes[b]; });
    m_ranks.resize(m_sizes.size(), 0);
    for (std::uint32_t i = 0; i < m_order.size(); ++i) m_ranks[m_order[i]] = i;
  }

  const SparseVolume& m_volume;
  std::vector<VoxelIndex> m_blocks;
  std::unordered_map<std::uint64_t, std::uint32_t> m_firsts;  // the first piece of each block
  JoinedSets m_sets;
  std::vector<std::size_t> m_sizes;  // voxels of each piece; of a part's first, those of the part
  std::vector<std::uint32_t> m_order, m_ranks;
};

}  // namespace

VolumeParts partsOf(const SparseVolume& volume) {
  return Labelling(volume).parts();
}

VolumeParts keepLargest(SparseVolume& volume, std::size_t parts) {
  const SparseVolume before = volume;
  Labelling labelling(before);
  std::vector<VoxelIndex> changed;
  for (const VoxelIndex& at : labelling.blocks()) {
    const SparseVolume::Content content = before.content(at);
    const BlockPieces pieces = piecesOf({content.block.get(), content.isFull});
    std::vector<bool> isKept(pieces.count + 1u, true);
    for (std::uint16_t i = 1; i <= pieces.count; ++i) isKept[i] = labelling.rankOf(at, i) < parts;
    if (std::all_of(isKept.begin(), isKept.end(), [](bool kept) { return kept; })) continue;
    const auto block = samplesOf(content);
    for (std::size_t i = 0; i < VolumeBlock::kCount; ++i)
      if (!isKept[pieces.number[i]]) block->depths[i] = VolumeBlock::kEmpty;
    volume.setContent(at, contentOf(block));
    changed.push_back(at);
  }
  makeDistances(volume, changed, DepthWindow::Beside::Kept);
  return labelling.parts();
}

}  // namespace handwheel
