// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "base/Progress.h"
#include "volume/SparseVolume.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace handwheel {

// The connected parts of a volume, the largest first. Voxels are connected by their faces. Parts of equal size are in
// the order of their first blocks. The object holds a copy of the volume, and a label for each voxel near its surface.
class VolumeParts {
 public:
  // Returns VolumeErrors::TooLarge if there is not enough memory for the parts of a volume, and for one of them as a
  // separate volume.
  static std::optional<Error> refusal(const SparseVolume& volume);
  // Finds the parts. O(voxels of the blocks with samples). The object must not be used if cancelled.
  explicit VolumeParts(const SparseVolume& volume, Progress progress = {});

  // Number of voxels of each part.
  const std::vector<std::uint64_t>& voxels() const { return m_voxels; }
  // Returns the number of parts with at least this number of voxels. They are the first parts.
  std::size_t countFrom(std::uint64_t voxels) const;
  // Returns the volume of the parts [first, end). Their surface is unchanged; outside depths that referred to removed
  // parts become distances to the remaining parts. Runs on all threads of the arena; O(blocks of the other parts).
  SparseVolume only(std::size_t first, std::size_t end, Progress progress = {}) const;
  // Returns the volume without the parts whose flags are false. The depths in those change their sign, so that samples
  // beside them keep their distances from the surface that was there.
  SparseVolume without(const std::vector<bool>& kept) const;
  // Returns the part of each voxel; nothing for voxels outside. O(n + blocks).
  std::vector<std::optional<std::size_t>> partsOf(std::span<const VoxelIndex> voxels) const;

 private:
  using Labels = std::array<std::uint16_t, VolumeBlock::kCount>;  // labels within a block, from 1 on; 0: outside
  struct Labelled {
    VoxelIndex at;
    std::uint32_t first = 0;         // index in m_parts of label 1 of the block
    std::unique_ptr<Labels> labels;  // null: the block is full and has one label
  };

  std::uint32_t numberOf(const Labelled& block, std::size_t voxel) const {
    return block.labels ? block.first + (*block.labels)[voxel] - 1u : block.first;
  }

  SparseVolume m_volume;
  std::vector<Labelled> m_blocks;      // blocks with material
  std::vector<std::uint32_t> m_parts;  // part of each label; see Labelled::first
  std::vector<std::uint64_t> m_voxels;
};

}  // namespace handwheel
