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
// are made in tiles of 32³; each block equals that of volumeOfSurface(), to the last bit. Tiles far from those that
// were requested last are released, except for the blocks that were cut. So the memory for voxels depends on the
// surroundings of the tool and on the cut, not on the size of the part. A part must be used by one thread at a time. A
// copy shares the triangles and the blocks.
class HybridPart {
 public:
  static constexpr int kTile = 32;  // voxels along an edge

  // Cost of making voxels. Only blocks that hold samples (SparseVolume::Content) are counted.
  struct Figures {
    std::size_t blocksMade = 0;  // number of blocks made from triangles in total; a block made twice counts twice
    std::size_t mostBlocks = 0;  // largest number of blocks at one time
    std::size_t mostBytes = 0;   // largest value of bytes()
  };

  // Returns the part for a surface, without any voxels yet. voxel: size of a voxel, mm. O(n log n). Returns the errors
  // of volumeOfSurface() that do not depend on voxels: MeshError::NoTriangles, NumberNotFinite, ValueOutOfRange,
  // VolumeErrors::TooFine, Cancelled, and NothingInside if the signed volume of the closed surface is not above 0.
  // volumeOfSurface() may still find a body in such a surface, beside another one that is inside out.
  static Result<HybridPart> of(const TriangleSoup& soup, double voxel, Progress progress = {});

  // Remaining material in the tiles that were made; the grid is that of volumeOfSurface().
  SparseVolume& left() { return m_left; }
  const SparseVolume& left() const { return m_left; }
  // Bounding box of the part, voxels.
  const Box& extent() const { return m_extent; }

  // Makes the tiles with these indices, and releases all others, except those in or beside the bounding box
  // of these tiles and those that are held. Runs on
  // all threads of the arena.
  void make(std::span<const VoxelIndex> tiles);
  // Makes those of these tiles that intersect the part, and releases nothing.
  void makeAlso(std::span<const VoxelIndex> tiles);
  // Makes the tiles of the part that intersect this box, mm, and holds them until the next call. If the box is empty,
  // holds no tiles. Returns true if the set of held tiles changed.
  bool hold(const Box& box);
  // Marks blocks of left() as cut, so that they remain when their tiles are released. Must be called for all cut
  // blocks.
  void keep(std::span<const VoxelIndex> blocks);
  std::vector<VoxelIndex> cutBlocks() const;  // all blocks that were kept, in a fixed order
  // Returns the depth of a point below the surface before anything was cut, mm, by VolumeSampler::depthAt(). Makes the
  // tiles that it requires.
  double depthBefore(const Vec3& point);

  // Returns true if the tiles made so far certainly equal those of volumeOfSurface(). They may differ where that
  // function closes wide curved holes, and where the surface encloses a region twice or inside out. They may also
  // differ where walls thinner than a voxel were lost; volumeOfSurface() may refuse such a surface.
  bool isExact() const;
  const Figures& figures() const { return m_figures; }
  std::size_t blockCount() const {
    return m_left.blockCount() + m_originals;
  }                           // current number of blocks that hold samples
  std::size_t bytes() const;  // current memory of voxels, cut blocks and scanlines; O(rows)

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

  std::shared_ptr<const TriangleHierarchy> m_triangles;  // triangles, in units of voxels
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
  // Number of voxels beside the surface, and of those among them without a neighbour on the other side of the surface.
  std::size_t m_near = 0, m_lost = 0;
  std::set<Key> m_judged;  // tiles counted in m_near and m_lost; each counts once
  Figures m_figures;
};

}  // namespace handwheel
