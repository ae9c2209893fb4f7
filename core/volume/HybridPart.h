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

// A part of triangles that has voxels only where they are needed. It is the hybrid model of He 2008, 5.2.1. Voxels are
// made in tiles of 32³, each block as volumeOfSurface() makes it, to the last bit. Tiles far from those that were asked
// for last are given back, but for the blocks that were cut. So the memory for voxels is that around a tool and of what
// it has cut, whatever the size of the part. One thread at a time. A copy shares the triangles and the blocks.
class HybridPart {
 public:
  static constexpr int kTile = 32;  // voxels along an edge

  // What making voxels took. Blocks are those that hold samples.
  struct Figures {
    std::size_t blocksMade = 0;  // of triangles, in all: what came back counts again
    std::size_t mostBlocks = 0;  // at once
    std::size_t mostBytes = 0;   // as bytes(), at once
  };

  // voxel: mm. O(n log n) and no voxel. Errors: those of volumeOfSurface() that do not come from voxels:
  // MeshError::NoTriangles, NumberNotFinite, ValueOutOfRange, VolumeErrors::TooFine, NothingInside (of a surface that
  // encloses nothing by the sum of its triangles; voxels may still find a body beside one that is inside out),
  // Cancelled.
  static Result<HybridPart> of(const TriangleSoup& soup, double voxel, Progress progress = {});

  // What is left of the part, where it is made; the grid is that of volumeOfSurface().
  SparseVolume& left() { return m_left; }
  const SparseVolume& left() const { return m_left; }
  // What holds the part, voxels.
  const Box& extent() const { return m_extent; }

  // Makes these tiles, by their numbers along the axes, and gives back those that are not beside their bounding box,
  // nor held. On all threads of the arena.
  void make(std::span<const VoxelIndex> tiles);
  // Makes these, as far as they meet the part, and gives nothing back.
  void makeAlso(std::span<const VoxelIndex> tiles);
  // Makes the tiles of the part that this box meets, mm, and holds them until it is given another; an empty box: none.
  // Returns whether these are others than before.
  bool hold(const Box& place);
  // Blocks of left() that were changed: they are kept.
  void keep(std::span<const VoxelIndex> blocks);
  std::vector<VoxelIndex> cutBlocks() const;  // all that were kept, in one order
  // How deep a place was below the surface before anything was cut, mm; as VolumeSampler::depthAt(). Makes what it
  // needs.
  double depthBefore(const Vec3& place);

  // Whether what was made so far is what volumeOfSurface() makes. It is not certain where it closes wide bent holes,
  // where the surface goes round something twice or backwards, and where walls thinner than a voxel were lost that it
  // may refuse.
  bool isExact() const;
  const Figures& figures() const { return m_figures; }
  std::size_t blockCount() const { return m_left.blockCount() + m_originals; }  // at present
  std::size_t bytes() const;  // of voxels, of what was cut and of the rows that sign them, at present; O(rows)

 private:
  using Key = std::array<int, 3>;  // along z, y, x
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
  SparseVolume m_left, m_before;  // the same blocks but for those that were cut
  std::set<Key> m_tiles;          // that are made
  std::set<Key> m_cut;            // blocks
  std::size_t m_originals = 0;    // blocks with samples that only m_before has
  Eigen::AlignedBox3i m_kept;     // tiles, the last that were not given back
  Eigen::AlignedBox3i m_held;     // tiles
  // Crossings of the rows of tiles, by z and y.
  std::map<std::array<int, 2>, std::shared_ptr<const ScanlineCrossings>> m_rows;
  bool m_isSimple = true;
  std::size_t m_near = 0, m_lost = 0;  // voxels beside the surface, and those of them where it was lost,
  std::set<Key> m_judged;              // of these tiles: each counts once, however often it comes back
  Figures m_figures;
};

}  // namespace handwheel
