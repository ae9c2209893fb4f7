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

// The number of a voxel, or of a block of them, along each axis.
using VoxelIndex = Eigen::Vector3i;

// 8 by 8 by 8 samples of a volume: depths below the surface, in 8192ths of a voxel, x fastest. Above 0 it is material.
struct VolumeBlock {
  static constexpr int kSize = 8;
  static constexpr std::size_t kCount = 512;
  static constexpr std::int16_t kFull = 32767;    // as deep as can be stored, nearly four voxels
  static constexpr std::int16_t kEmpty = -32767;  // as far outside
  static constexpr double kUnit = 8192.0;         // to a voxel

  std::array<std::int16_t, kCount> depths;

  // How much of a voxel counts as enclosed by the surface at such a depth of its centre: from nothing half a voxel
  // outside to all of it half a voxel inside; in 8192ths.
  static int enclosed(std::int16_t depth) {
    constexpr int kVoxel = static_cast<int>(kUnit);
    return std::clamp(depth + kVoxel / 2, 0, kVoxel);
  }
  static std::size_t at(int x, int y, int z) { return static_cast<std::size_t>((z * kSize + y) * kSize + x); }
};

// A sample for a depth in voxels. Never 0: each sample is inside or outside.
std::int16_t depthSample(double voxels);

// A sparse volume, stored near its surface only. It is a truncated signed distance field, in which depth below the
// surface is positive. Blocks that the
// surface does not come near are full or empty, and take no memory of their own.
//
// A value: copies share blocks, and a copy takes time and memory in proportion to the volume's 64³ regions. So a
// snapshot is cheap, and an edit is the blocks that it changed. Reading different copies on different threads is safe.
class SparseVolume {
 public:
  using Block = std::shared_ptr<const VolumeBlock>;

  // What a block holds: samples, or nothing (outside) or material everywhere.
  struct Content {
    Block block;          // null: uniform
    bool isFull = false;  // of a uniform one

    bool operator==(const Content&) const = default;
  };

  // Voxels from the origin along an axis, either way, at most. What is larger would not fit into any memory.
  static constexpr int kMostVoxels = 1 << 20;

  SparseVolume() = default;
  // The centre of voxel (0, 0, 0), and the edge of a voxel; mm, above 0.
  SparseVolume(const Vec3& origin, double voxel) : m_origin(origin), m_voxel(voxel) {}

  const Vec3& origin() const { return m_origin; }
  double voxel() const { return m_voxel; }
  Vec3 centre(const VoxelIndex& voxel) const { return m_origin + m_voxel * voxel.cast<double>(); }

  Content content(const VoxelIndex& block) const;
  // The same without a share in it: valid as long as the volume stays as it is. No allocation.
  struct View {
    const VolumeBlock* block = nullptr;  // null: uniform
    bool isFull = false;                 // of a uniform one
  };
  View view(const VoxelIndex& block) const;
  void setContent(const VoxelIndex& block, Content content);
  // Whether a region of 64³ voxels is one and the same object in another volume; true where neither has it. O(1).
  bool sharesRegion(const SparseVolume& other, const VoxelIndex& region) const;

  // The sample of a voxel, as VolumeBlock stores it. O(1).
  std::int16_t sample(const VoxelIndex& voxel) const;

  // Calls visit(number of the block, content) for each that is not empty, in an order that depends on the content
  // alone.
  void forEach(const std::function<void(const VoxelIndex&, const Content&)>& visit) const;
  // Those that hold samples, in that order.
  std::vector<VoxelIndex> blocks() const;
  std::size_t blockCount() const { return m_blockCount; }  // of those
  // What is inside by its voxels, each all or nothing; mm³. To count voxels, and to see whether any material is there
  // or was added; where people read a volume it is enclosed().
  double material() const { return static_cast<double>(m_count.inside) * m_voxel * m_voxel * m_voxel; }
  // What the surface encloses; mm³. Exact for faces along the axes, to second order for others; walls thinner than a
  // voxel count for too much.
  double enclosed() const {
    return static_cast<double>(m_count.enclosed) / VolumeBlock::kUnit * m_voxel * m_voxel * m_voxel;
  }
  bool isEmpty() const { return m_regions.empty(); }
  // What holds all material, to the next 64 voxels; in voxels.
  Box extent() const;
  // Memory of this version, were it the only one; bytes.
  std::size_t bytes() const;

  // The block of a voxel.
  static VoxelIndex blockOf(const VoxelIndex& voxel) {
    return voxel.unaryExpr([](int i) { return i >> 3; });
  }

 private:
  // 8 by 8 by 8 blocks.
  struct Region {
    std::array<Block, 512> blocks;
    std::bitset<512> full;  // of those without samples

    bool isEmpty() const;
  };
  struct Count {
    std::uint64_t inside = 0;    // voxels
    std::uint64_t enclosed = 0;  // in 8192ths of a voxel
  };
  static Count countOf(const Content& content);
  static std::uint64_t keyOf(const VoxelIndex& region);
  static std::size_t placeOf(const VoxelIndex& block);

  Vec3 m_origin = Vec3::Zero();
  double m_voxel = 1.0;
  std::unordered_map<std::uint64_t, std::shared_ptr<Region>> m_regions;
  std::size_t m_blockCount = 0;
  Count m_count;
};

}  // namespace handwheel
