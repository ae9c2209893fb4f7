// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "volume/SparseVolume.h"

#include <map>
#include <memory>
#include <span>

namespace handwheel {

// Triangles for a graphics card. Those of one piece share their vertices; pieces do not.
struct VolumeTriangles {
  std::vector<float> points;          // x y z …, mm from the origin of the piece
  std::vector<float> normals;         // of length 1, outwards
  std::vector<std::int32_t> corners;  // three to a triangle

  std::size_t count() const { return corners.size() / 3; }
};

// The surface of a volume in 64³ of its cells.
struct VolumePiece {
  Vec3 origin = Vec3::Zero();  // mm
  Box box;                     // of its points, mm
  VolumeTriangles fine;        // of marching cubes, as surfaceOf() makes them
  VolumeTriangles coarse;      // of every fourth sample: for views that move
};

// The surface of a volume for its display, in pieces, so that only those are made anew that an edit touches. Normals
// are those of the depths, so that pieces are shaded alike where they meet. A value; copies share the pieces.
class VolumeSurface {
 public:
  using Piece = std::shared_ptr<const VolumePiece>;  // not empty
  using Key = std::array<int, 3>;                    // of a piece: its 64³ cells along z, y, x

  VolumeSurface() = default;
  // On all threads of the arena. Without some pieces once cancelled.
  explicit VolumeSurface(const SparseVolume& volume, Progress progress = {});

  const std::map<Key, Piece>& pieces() const { return m_pieces; }
  std::size_t triangleCount() const;
  std::size_t bytes() const;  // of all pieces

  // Makes the pieces anew that have to do with these blocks, after they have changed. On all threads of the arena.
  void update(const SparseVolume& volume, std::span<const VoxelIndex> changedBlocks);

 private:
  void make(const SparseVolume& volume, const std::vector<Key>& keys, Progress progress);

  std::map<Key, Piece> m_pieces;
};

}  // namespace handwheel
