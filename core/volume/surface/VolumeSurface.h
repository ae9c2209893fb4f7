// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "volume/SparseVolume.h"
#include "volume/surface/BlockTriangles.h"

#include <map>
#include <memory>
#include <span>
#include <vector>

namespace handwheel {

// The surface of a volume in a cube of its cells. Points are relative to the origin of the piece.
struct VolumePiece {
  // The part of the triangles that is in the cells of one block.
  struct BlockPart {
    std::uint16_t block;  // number of the block in the piece, x fastest
    std::uint32_t firstPoint, firstCorner;
  };

  Vec3 origin = Vec3::Zero();    // mm
  Box box;                       // bounding box of the points, mm
  VolumeTriangles fine;          // triangles of marching cubes, as surfaceOf() makes them
  VolumeTriangles coarse;        // triangles of every fourth sample, for moving views
  std::vector<BlockPart> parts;  // parts of the fine triangles, one per block

  std::size_t bytes() const;  // memory of the triangles, bytes
};

// The surface of a volume for display, in pieces. Only pieces that an edit touches are rebuilt. Normals are gradients
// of the depths, so that neighbouring pieces are shaded alike. VolumeSurface is a value type: copies share the pieces.
class VolumeSurface {
 public:
  using Piece = std::shared_ptr<const VolumePiece>;  // a piece that is not empty
  using Key = std::array<int, 3>;                    // index of a piece along z, y and x

  static constexpr int kPieceCells = 64;  // default number of cells of a piece along each axis

  VolumeSurface() = default;
  // pieceCells: 16, 32, 64 or 128. The construction runs on all threads of the arena. Pieces are missing if it was
  // cancelled.
  explicit VolumeSurface(const SparseVolume& volume, Progress progress = {}, int pieceCells = kPieceCells);

  int pieceCells() const { return m_pieceCells; }
  const std::map<Key, Piece>& pieces() const { return m_pieces; }
  Box box() const;  // bounding box of all pieces, mm
  std::size_t triangleCount() const;
  std::size_t bytes() const;  // memory of all pieces, bytes

  // Rebuilds the surface around these blocks, after they have changed. Runs on all threads of the arena. O(changed
  // blocks) plus the cost of copying the pieces that contain them.
  void update(const SparseVolume& volume, std::span<const VoxelIndex> changedBlocks);

  // Returns the pieces with cells that have a sample of one of these blocks at a corner. If withNormals is true, the
  // result also contains the pieces in which only normals depend on the blocks.
  std::vector<Key> piecesOf(std::span<const VoxelIndex> blocks, bool withNormals) const;
  // Rebuilds these pieces completely, and leaves the others unchanged. Runs on all threads of the arena.
  void make(const SparseVolume& volume, std::span<const Key> pieces, Progress progress = {});

 private:
  void set(const Key& key, Piece piece);

  std::map<Key, Piece> m_pieces;
  int m_pieceCells = kPieceCells;
};

}  // namespace handwheel
