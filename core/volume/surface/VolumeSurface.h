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

// The surface of a volume in a cube of its cells. Points count from its origin.
struct VolumePiece {
  // The part of the triangles that is in the cells of one block.
  struct BlockPart {
    std::uint16_t block;  // its number in the piece, x fastest
    std::uint32_t firstPoint, firstCorner;
  };

  Vec3 origin = Vec3::Zero();    // mm
  Box box;                       // of its points, mm
  VolumeTriangles fine;          // of marching cubes, as surfaceOf() makes them
  VolumeTriangles coarse;        // of every fourth sample: for views that move
  std::vector<BlockPart> parts;  // of the fine ones, by block

  std::size_t bytes() const;  // of the triangles
};

// The surface of a volume for its display, in pieces. Only those are made anew that an edit touches. Normals are those
// of the depths, so that pieces are shaded alike where they meet. A value; copies share the pieces.
class VolumeSurface {
 public:
  using Piece = std::shared_ptr<const VolumePiece>;  // not empty
  using Key = std::array<int, 3>;                    // of a piece: its number along z, y, x

  static constexpr int kPieceCells = 64;  // of a piece along each axis, where nobody chooses

  VolumeSurface() = default;
  // pieceCells: 16, 32, 64 or 128. On all threads of the arena. Without some pieces once cancelled.
  explicit VolumeSurface(const SparseVolume& volume, Progress progress = {}, int pieceCells = kPieceCells);

  int pieceCells() const { return m_pieceCells; }
  const std::map<Key, Piece>& pieces() const { return m_pieces; }
  Box box() const;  // of all pieces, mm
  std::size_t triangleCount() const;
  std::size_t bytes() const;  // of all pieces

  // Makes anew what has to do with these blocks, after they have changed. On all threads of the arena; O(changed
  // blocks), and a copy of the pieces that they are in.
  void update(const SparseVolume& volume, std::span<const VoxelIndex> changedBlocks);

  // The pieces that have cells with a sample of one of these blocks at a corner. withNormals: also those where they
  // only give a normal.
  std::vector<Key> piecesOf(std::span<const VoxelIndex> blocks, bool withNormals) const;
  // Makes these pieces anew as a whole, and leaves the others as they are. On all threads of the arena.
  void make(const SparseVolume& volume, std::span<const Key> pieces, Progress progress = {});

 private:
  void set(const Key& key, Piece piece);

  std::map<Key, Piece> m_pieces;
  int m_pieceCells = kPieceCells;
};

}  // namespace handwheel
