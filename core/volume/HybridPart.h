// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "mesh/structure/TriangleSoup.h"
#include "proximity/TriangleHierarchy.h"
#include "volume/SparseVolume.h"
#include "volume/surface/ScanlineCrossings.h"

#include <array>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <vector>

namespace handwheel {

// A part made of triangles, with voxels only where they are needed. It is the hybrid model of He 2008, 5.2.1. Voxels
// are made in tiles of 32³, each block as volumeOfSurface() makes it, to the last bit. Tiles far from those that were
// requested last are released, except for the blocks that were cut. So the memory for voxels depends on the
// surroundings of the tool and on the cut, not on the size of the part. One thread at a time. A copy shares the
// triangles and the blocks.
class HybridPart {
 public:
  static constexpr int kTile = 32;  // voxels along an edge

  // Cost of making voxels. Only blocks that hold samples are counted.
  struct Figures {
    std::size_t blocksMade = 0;  // number of blocks made from triangles in total; a block made twice counts twice
    std::size_t mostBlocks = 0;  // largest number of blocks at one time
    std::size_t mostBytes = 0;   // largest value of bytes()
  };

  // Returns the part for a surface, without any voxels yet. voxel: mm. O(n log n). Errors: those of volumeOfSurface()
  // that do not come from voxels: MeshError::NoTriangles, NumberNotFinite, ValueOutOfRange, VolumeErrors::TooFine,
  // NothingInside (of a surface that encloses nothing by the sum of its triangles; voxels may still find a body beside
  // one that is inside out), Cancelled.
  static Result<HybridPart> of(const TriangleSoup& soup, double voxel, Progress progress = {});

  // Remaining material in the tiles that were made; the grid is that of volumeOfSurface().
  SparseVolume& left() { return m_left; }
  const SparseVolume& left() const { return m_left; }
  // Bounding box of the part, voxels.
  const Box& extent() const { return m_extent; }

  // Makes these tiles, given by their indices, and releases those that are neither beside their bounding box nor held.
  // On all threads of the arena.
  void make(std::span<const VoxelIndex> tiles);
  // Makes those of these tiles that meet the part, and releases nothing.
  void makeAlso(std::span<const VoxelIndex> tiles);
  // Makes the tiles of the part that intersect this box, mm, and holds them until the next call; an empty box: none.
  // Returns true if the held tiles changed.
  bool hold(const Box& box);
  // Keeps these blocks of left(), which were changed.
  void keep(std::span<const VoxelIndex> blocks);
  std::vector<VoxelIndex> cutBlocks() const;  // all blocks that were kept, in a fixed order
  // Returns the depth of a point below the surface before anything was cut, mm, as VolumeSampler::depthAt() does. Makes
  // the tiles that it needs.
  double depthBefore(const Vec3& point);

  // Returns true if the tiles made so far certainly equal those of volumeOfSurface(). They may differ where that
  // function closes wide curved holes, where the surface encloses a region twice or inside out, and where walls thinner
  // than a voxel were lost, which it may refuse.
  bool isExact() const;
  const Figures& figures() const { return m_figures; }
  std::size_t blockCount() const { return m_left.blockCount() + m_originals; }  // at present
  std::size_t bytes() const;  // present memory of voxels, cut blocks and scanlines; O(rows)

 private:
  using Key = std::array<int, 3>;  // tile or block index along z, y, x
  struct Tile;

  HybridPart() = default;
  void add(std::span<const VoxelIndex> tiles);
  Eigen::AlignedBox3i tilesIn(const Box& voxels) const;
  void giveBackBut(const Eigen::AlignedBox3i& kept);
  void giveBack(const VoxelIndex& tile);
  void makeRows(const VoxelIndex& tile);
  Tile madeTile(const VoxelIndex& tile) const;
  TriangleSoup trianglesIn(const Box& box) const;
  void count();

  std::shared_ptr<const TriangleHierarchy> m_triangles;  // voxels
  Box m_extent;
  SparseVolume m_left, m_before;  // equal except for the blocks that were cut
  std::set<Key> m_tiles;          // tiles that exist
  std::set<Key> m_cut;            // blocks that were cut
  std::size_t m_originals = 0;    // number of blocks with samples that only m_before has
  Eigen::AlignedBox3i m_kept;     // tiles that the last make() did not release
  Eigen::AlignedBox3i m_held;     // tiles that hold() keeps
  // Crossings of the rows of tiles, by z and y.
  std::map<std::array<int, 2>, std::shared_ptr<const ScanlineCrossings>> m_rows;
  bool m_isSimple = true;
  std::size_t m_near = 0, m_lost = 0;  // number of voxels beside the surface, and of those where it was lost
  std::set<Key> m_judged;              // tiles counted in m_near and m_lost; each counts once
  Figures m_figures;
};

}  // namespace handwheel
