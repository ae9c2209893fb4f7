// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "base/Progress.h"
#include "volume/SparseVolume.h"

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace handwheel {

// The parts of a volume: material that hangs together over faces of voxels. The largest is the first; of equal ones the
// one whose first block comes first. It holds a copy of the volume, and a number for each voxel near its surface.
class VolumeParts {
 public:
  // Why there is no memory for the parts of a volume and one of them alone: TooLarge; none where there is.
  static std::optional<Error> refusal(const SparseVolume& volume);
  // O(voxels of the blocks with samples). After a cancel it is not to be used.
  explicit VolumeParts(const SparseVolume& volume, Progress progress = {});

  // The voxels of each part.
  const std::vector<std::uint64_t>& voxels() const { return m_voxels; }
  // How many parts have at least so many voxels; these are the first.
  std::size_t countFrom(std::uint64_t voxels) const;
  // The volume of the parts from first on, before end. The surface of these stays as it is; depths outside, which were
  // those to parts that are gone, are distances again. On all threads of the arena; O(blocks of the other parts).
  SparseVolume only(std::size_t first, std::size_t end, Progress progress = {}) const;

 private:
  using Labels = std::array<std::uint16_t, VolumeBlock::kCount>;  // from 1 on, in a block; 0: outside
  struct Labelled {
    VoxelIndex at;
    std::uint32_t first = 0;         // the number of its first label
    std::unique_ptr<Labels> labels;  // null: all is material, of one label
  };

  std::uint32_t numberOf(const Labelled& block, std::size_t voxel) const {
    return block.labels ? block.first + (*block.labels)[voxel] - 1u : block.first;
  }

  SparseVolume m_volume;
  std::vector<Labelled> m_blocks;      // those with material
  std::vector<std::uint32_t> m_parts;  // of each number
  std::vector<std::uint64_t> m_voxels;
};

}  // namespace handwheel
