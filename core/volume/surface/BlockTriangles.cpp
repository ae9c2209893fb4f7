// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/surface/BlockTriangles.h"

#include "volume/VolumeSampler.h"
#include "volume/surface/MarchingCubesTable.h"

#include <algorithm>
#include <array>

namespace handwheel {
namespace {

// The samples of the cells in a cube, and one more on each side for differences.
class CellCube {
 public:
  // cells: along each axis.
  CellCube(const SparseVolume& volume, const VoxelIndex& first, int cells, int stride)
      : m_cells(cells), m_side(cells + 3), m_stride(stride), m_first(first), m_volume(volume) {
    m_samples.resize(static_cast<std::size_t>(m_side) * m_side * m_side);
    if (stride == 1) {
      copyBlocks();
      return;
    }
    const VolumeSampler sampler(volume);
    std::size_t i = 0;
    for (int z = -1; z < m_side - 1; ++z)
      for (int y = -1; y < m_side - 1; ++y)
        for (int x = -1; x < m_side - 1; ++x) m_samples[i++] = sampler.sample(first + stride * VoxelIndex(x, y, z));
  }

  VolumeTriangles triangles(const Vec3& origin) const {
    VolumeTriangles made;
    if (!hasSurface()) return made;
    made.points.reserve(400);
    made.normals.reserve(400);
    made.corners.reserve(600);
    std::vector<std::int32_t> known(3 * m_samples.size(), -1);  // vertices, by the edge's first sample and axis
    const MarchingCubesTable& table = MarchingCubesTable::table();
    for (int z = 0; z < m_cells; ++z)
      for (int y = 0; y < m_cells; ++y) {
        unsigned sides = sideOf(0, y, z);
        for (int x = 0; x < m_cells; ++x) {
          const unsigned next = sideOf(x + 1, y, z);
          for (const MarchingCubesTable::EdgeTriangle& t : table.triangles[sides | next << 1])
            for (const int edge : t) made.corners.push_back(vertexOf({x, y, z}, edge, origin, known, made));
          sides = next;
        }
      }
    return made;
  }

 private:
  // Returns true if there are samples on both sides; about half of the blocks near the surface have no surface.
  bool hasSurface() const {
    const bool isInside = m_samples.front() > 0;
    return std::any_of(m_samples.begin(), m_samples.end(), [&](std::int16_t s) { return (s > 0) != isInside; });
  }

  // Each sample once, block by block.
  void copyBlocks() {
    const VoxelIndex low = m_first - VoxelIndex::Ones(), high = low + VoxelIndex::Constant(m_side - 1);
    const VoxelIndex firstBlock = SparseVolume::blockOf(low), lastBlock = SparseVolume::blockOf(high);
    for (int bz = firstBlock.z(); bz <= lastBlock.z(); ++bz)
      for (int by = firstBlock.y(); by <= lastBlock.y(); ++by)
        for (int bx = firstBlock.x(); bx <= lastBlock.x(); ++bx) {
          const SparseVolume::View view = m_volume.view({bx, by, bz});
          const std::int16_t uniform = view.isFull ? VolumeBlock::kFull : VolumeBlock::kEmpty;
          const VoxelIndex begin = (VolumeBlock::kSize * VoxelIndex(bx, by, bz)).cwiseMax(low);
          const VoxelIndex end = (VolumeBlock::kSize * VoxelIndex(bx, by, bz) + VoxelIndex::Constant(7)).cwiseMin(high);
          for (int z = begin.z(); z <= end.z(); ++z)
            for (int y = begin.y(); y <= end.y(); ++y)
              for (int x = begin.x(); x <= end.x(); ++x)
                m_samples[sampleIndex(VoxelIndex(x, y, z) - m_first)] =
                    view.block ? view.block->depths[VolumeBlock::at(x & 7, y & 7, z & 7)] : uniform;
        }
  }

  std::size_t sampleIndex(const VoxelIndex& at) const {
    return static_cast<std::size_t>(((at.z() + 1) * m_side + at.y() + 1) * m_side + at.x() + 1);
  }
  int sample(const VoxelIndex& at) const { return m_samples[sampleIndex(at)]; }

  // Returns the inside flags of the four corners of a cell with this x, as bits 0, 2, 4 and 6.
  unsigned sideOf(int x, int y, int z) const {
    const std::size_t at = sampleIndex({x, y, z});
    const auto row = static_cast<std::size_t>(m_side), layer = row * row;
    return static_cast<unsigned>(m_samples[at] > 0) | static_cast<unsigned>(m_samples[at + row] > 0) << 2 |
           static_cast<unsigned>(m_samples[at + layer] > 0) << 4 |
           static_cast<unsigned>(m_samples[at + layer + row] > 0) << 6;
  }

  std::int32_t vertexOf(const VoxelIndex& cell, int edge, const Vec3& origin, std::vector<std::int32_t>& known,
                        VolumeTriangles& made) const {
    const auto [low, high] = cornersOfCellEdge(edge);
    const VoxelIndex a = cell + VoxelIndex(low & 1, low >> 1 & 1, low >> 2);
    const VoxelIndex b = cell + VoxelIndex(high & 1, high >> 1 & 1, high >> 2);
    std::int32_t& number = known[3 * sampleIndex(a) + static_cast<std::size_t>(edge / 4)];
    if (number >= 0) return number;
    number = static_cast<std::int32_t>(made.points.size() / 3);
    const double from = sample(a), to = sample(b), share = shareToSurface(from, to);
    const Vec3 at = (a.cast<double>() + share * (b - a).cast<double>()) * m_stride + m_first.cast<double>();
    const Vec3 p = m_volume.origin() - origin + m_volume.voxel() * at, n = normal(a, b, share);
    for (int k = 0; k < 3; ++k) {
      made.points.push_back(static_cast<float>(p[k]));
      made.normals.push_back(static_cast<float>(n[k]));
    }
    return number;
  }

  // From differences between samples two apart, at both ends of the edge.
  Vec3 normal(const VoxelIndex& a, const VoxelIndex& b, double share) const {
    Vec3 n;
    for (int k = 0; k < 3; ++k) {
      const VoxelIndex step = VoxelIndex::Unit(k);
      const double atA = sample(a - step) - sample(a + step), atB = sample(b - step) - sample(b + step);
      n[k] = atA + share * (atB - atA);
    }
    const double length = n.norm();
    return length > 0.0 ? Vec3(n / length) : Vec3(Vec3::UnitZ());
  }

  int m_cells, m_side, m_stride;
  VoxelIndex m_first;
  const SparseVolume& m_volume;
  std::vector<std::int16_t> m_samples;
};

}  // namespace

void VolumeTriangles::append(const VolumeTriangles& other, std::size_t firstPoint, std::size_t pointCount,
                             std::size_t firstCorner, std::size_t cornerCount) {
  const auto offset = static_cast<std::int32_t>(points.size() / 3) - static_cast<std::int32_t>(firstPoint);
  const auto part = [](const std::vector<float>& of, std::size_t first, std::size_t count) {
    const auto begin = of.begin() + static_cast<std::ptrdiff_t>(3 * first);
    return std::pair(begin, begin + static_cast<std::ptrdiff_t>(3 * count));
  };
  const auto [p, pEnd] = part(other.points, firstPoint, pointCount);
  const auto [n, nEnd] = part(other.normals, firstPoint, pointCount);
  points.insert(points.end(), p, pEnd);
  normals.insert(normals.end(), n, nEnd);
  for (std::size_t i = firstCorner; i < firstCorner + cornerCount; ++i) corners.push_back(other.corners[i] + offset);
}

VolumeTriangles blockTriangles(const SparseVolume& volume, const VoxelIndex& block, const Vec3& origin) {
  return CellCube(volume, VolumeBlock::kSize * block, VolumeBlock::kSize, 1).triangles(origin);
}

VolumeTriangles coarseTriangles(const SparseVolume& volume, const VoxelIndex& first, int cells, int stride,
                                const Vec3& origin) {
  return CellCube(volume, first, cells, stride).triangles(origin);
}

}  // namespace handwheel
