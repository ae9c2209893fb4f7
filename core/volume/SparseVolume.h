// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstdint>
#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

namespace handwheel {

// The index of a voxel, or of a block of voxels, along each axis.
using VoxelIndex = Eigen::Vector3i;

// A block of 8³ samples: depths below the surface, in 1/8192 of a voxel, x fastest. Positive depths are material.
struct VolumeBlock {
  static constexpr int kSize = 8;
  static constexpr std::size_t kCount = 512;
  static constexpr std::int16_t kFull = 32767;    // largest depth that can be stored, nearly four voxels
  static constexpr std::int16_t kEmpty = -32767;  // largest distance outside the surface that can be stored
  static constexpr double kUnit = 8192.0;         // units per voxel

  std::array<std::int16_t, kCount> depths;

  // Returns the fraction of a voxel that counts as enclosed by the surface, in 1/8192, for the depth of its centre. The
  // fraction rises from 0 for a centre half a voxel outside to 1 for a centre half a voxel inside.
  static int enclosed(std::int16_t depth) {
    constexpr int kVoxel = static_cast<int>(kUnit);
    return std::clamp(depth + kVoxel / 2, 0, kVoxel);
  }
  static std::size_t at(int x, int y, int z) { return static_cast<std::size_t>((z * kSize + y) * kSize + x); }
};

// Returns the sample for a depth in voxels. The sample is never 0, as each sample is either inside or outside.
std::int16_t depthSample(double voxels);

// A sparse volume, stored near its surface only. It is a truncated signed distance field, in which depth below the
// surface is positive. Blocks away from the surface are full or empty, and take no memory of their own.
//
// A value type: copies share blocks, and the time and memory of a copy are proportional to the number of 64³ regions.
// So a snapshot costs little, and an edit consists of the blocks that it changed. Different copies may be read on
// different threads.
class SparseVolume {
 public:
  using Block = std::shared_ptr<const VolumeBlock>;

  // The content of a block: samples, or a uniform value (empty or full).
  struct Content {
    Block block;          // null: the block is uniform
    bool isFull = false;  // value of a uniform block

    bool operator==(const Content&) const = default;
  };

  // Largest index of a voxel along an axis, positive or negative. Larger volumes would not fit into any memory.
  static constexpr int kMostVoxels = 1 << 20;

  SparseVolume() = default;
  // origin: the centre of voxel (0, 0, 0), mm. voxel: the edge length of a voxel, mm, above 0.
  SparseVolume(const Vec3& origin, double voxel) : m_origin(origin), m_voxel(voxel) {}

  const Vec3& origin() const { return m_origin; }
  double voxel() const { return m_voxel; }
  Vec3 centre(const VoxelIndex& voxel) const { return m_origin + m_voxel * voxel.cast<double>(); }

  Content content(const VoxelIndex& block) const;
  // The content of a block without shared ownership. It is valid until the volume changes; getting it does not
  // allocate.
  struct View {
    const VolumeBlock* block = nullptr;  // null: the block is uniform
    bool isFull = false;                 // value of a uniform block
  };
  View view(const VoxelIndex& block) const;
  void setContent(const VoxelIndex& block, Content content);
  // Returns true if both volumes share the same object for a region of 64³ voxels, or if neither has it. O(1).
  bool sharesRegion(const SparseVolume& other, const VoxelIndex& region) const;

  // Returns the sample of a voxel, as VolumeBlock stores it. O(1).
  std::int16_t sample(const VoxelIndex& voxel) const;

  // Calls visit(block index, content) for each block that is not empty, in an order that depends on the content alone.
  void forEach(const std::function<void(const VoxelIndex&, const Content&)>& visit) const;
  // Returns the blocks that hold samples, in the order of forEach().
  std::vector<VoxelIndex> blocks() const;
  std::size_t blockCount() const { return m_blockCount; }  // number of blocks that hold samples
  // Returns the volume of all voxels whose centre is inside, mm³. It serves to count voxels and to detect material; use
  // enclosed() for a volume that users read.
  double material() const { return static_cast<double>(m_count.inside) * m_voxel * m_voxel * m_voxel; }
  // Returns the volume that the surface encloses, mm³. The result is exact for faces along the axes and of second order
  // for others; it is too large for walls thinner than a voxel.
  double enclosed() const {
    return static_cast<double>(m_count.enclosed) / VolumeBlock::kUnit * m_voxel * m_voxel * m_voxel;
  }
  bool isEmpty() const { return m_regions.empty(); }
  // Returns the bounding box of all material, in voxels, rounded outwards to multiples of 64.
  Box extent() const;
  // Returns the memory of this volume in bytes, including memory that is shared with other volumes.
  std::size_t bytes() const;

  // Returns the block that contains a voxel.
  static VoxelIndex blockOf(const VoxelIndex& voxel) {
    return voxel.unaryExpr([](int i) { return i >> 3; });
  }

 private:
  // A region of 8³ blocks.
  struct Region {
    std::array<Block, 512> blocks;
    std::bitset<512> full;  // values of the blocks without samples

    bool isEmpty() const;
  };
  struct Count {
    std::uint64_t inside = 0;    // number of voxels whose centre is inside
    std::uint64_t enclosed = 0;  // enclosed volume, in 8192ths of a voxel
  };
  static Count countOf(const Content& content);
  static std::uint64_t keyOf(const VoxelIndex& region);
  static std::size_t indexOf(const VoxelIndex& block);

  Vec3 m_origin = Vec3::Zero();
  double m_voxel = 1.0;
  std::unordered_map<std::uint64_t, std::shared_ptr<Region>> m_regions;
  std::size_t m_blockCount = 0;
  Count m_count;
};

}  // namespace handwheel
