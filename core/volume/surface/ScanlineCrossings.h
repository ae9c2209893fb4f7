// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"
#include "volume/SparseVolume.h"

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace handwheel {

// Crossings of a closed surface with rows of voxel centres, and voxels' winding numbers. Rows are along x; the winding
// number counts how often the surface encloses a voxel. Crossings are decided exactly: a row through an edge or corner
// is shifted symbolically, so the number is 0 at both ends of every row.
class ScanlineCrossings {
 public:
  struct Crossing {
    double x;  // voxels
    int step;  // 1: into the surface, -1: out of it
    std::uint32_t triangle;

    bool operator<(const Crossing& other) const { return std::pair(x, triangle) < std::pair(other.x, other.triangle); }
  };

  // closed: points in voxels, where centres of voxels have integer coordinates; each edge occurs equally often in both
  // directions (closeBoundaries()). within: the rows to evaluate, by their y and z, none: all; triangles that none of
  // these rows crosses may be missing. Empty if cancelled. O(n + area), on all threads of the arena.
  ScanlineCrossings(const TriangleSoup& closed, Progress progress = {},
                    const std::optional<Eigen::AlignedBox2i>& within = {});

  // Returns the crossings of a row, sorted by x.
  std::span<const Crossing> row(int y, int z) const;
  // O(log crossings of the row).
  int winding(const VoxelIndex& voxel) const;
  bool isInside(const VoxelIndex& voxel) const { return winding(voxel) > 0; }

  // Returns true if all winding numbers are 0 or 1: then each triangle bounds the inside.
  bool isSimple() const { return m_isSimple; }
  // Largest winding number.
  int mostTurns() const { return m_mostTurns; }
  // Returns the crossings at which rows enter or leave the inside: flags of the triangles, and the points. A point is
  // inside if its winding number is above one half; turns(point, integer number) returns it. O(crossings).
  using Turns = std::function<double(const Vec3&, int)>;
  struct Bounding {
    std::vector<bool> triangles;
    std::vector<std::pair<Vec3, std::uint32_t>> points;  // points in voxels, each with its triangle
  };
  Bounding boundingBy(const Turns& turns) const;
  // Flags of the triangles that a row crosses.
  const std::vector<bool>& crossed() const { return m_crossed; }
  std::size_t bytes() const;

 private:
  Eigen::AlignedBox2i m_range;        // range of y and z
  std::vector<std::size_t> m_begin;   // first crossing of each row
  std::vector<Crossing> m_crossings;  // sorted by row, then by x
  std::vector<int> m_after;           // winding number after each crossing
  std::vector<bool> m_crossed;
  bool m_isSimple = true;
  int m_mostTurns = 0;
};

}  // namespace handwheel
