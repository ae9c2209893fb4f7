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

// The connected parts of a volume (voxels connected by faces), the largest first. Parts of equal size are in the order
// of their first blocks. Holds a copy of the volume, and a label for each voxel near its surface.
class VolumeParts {
 public:
  // Returns TooLarge if there is not enough memory for the parts of a volume and one of them as a volume of its own.
  static std::optional<Error> refusal(const SparseVolume& volume);
  // O(voxels of the blocks with samples). Must not be used if cancelled.
  explicit VolumeParts(const SparseVolume& volume, Progress progress = {});

  // Number of voxels of each part.
  const std::vector<std::uint64_t>& voxels() const { return m_voxels; }
  // Returns the number of parts with at least so many voxels; these are the first.
  std::size_t countFrom(std::uint64_t voxels) const;
  // Returns the volume of the parts [first, end). Their surface stays as it is; depths outside that referred to removed
  // parts become distances to the remaining ones. On all threads of the arena; O(blocks of the other parts).
  SparseVolume only(std::size_t first, std::size_t end, Progress progress = {}) const;

 private:
  using Labels = std::array<std::uint16_t, VolumeBlock::kCount>;  // from 1 on within a block; 0: outside
  struct Labelled {
    VoxelIndex at;
    std::uint32_t first = 0;         // number of its first label
    std::unique_ptr<Labels> labels;  // null: full, one label
  };

  std::uint32_t numberOf(const Labelled& block, std::size_t voxel) const {
    return block.labels ? block.first + (*block.labels)[voxel] - 1u : block.first;
  }

  SparseVolume m_volume;
  std::vector<Labelled> m_blocks;      // blocks with material
  std::vector<std::uint32_t> m_parts;  // part of each label number
  std::vector<std::uint64_t> m_voxels;
};

}  // namespace handwheel
