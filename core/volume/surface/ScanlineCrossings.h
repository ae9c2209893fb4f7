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

// Crossings of a closed surface with rows of voxel centres, and winding numbers of voxels. Rows are along x. The
// winding number of a voxel counts how often the surface encloses the voxel. Crossings are decided exactly: a row
// through an edge or corner is shifted symbolically, so that the winding number is 0 at both ends of every row.
class ScanlineCrossings {
 public:
  struct Crossing {
    double x;  // in voxels
    int step;  // 1: into the surface, -1: out of it
    std::uint32_t triangle;

    bool operator<(const Crossing& other) const { return std::pair(x, triangle) < std::pair(other.x, other.triangle); }
  };

  // closed: the surface, with points in voxels; centres of voxels have integer coordinates. Each edge must occur
  // equally often in both directions (closeBoundaries()). within: the rows to evaluate, by their y and z; nullopt: all
  // rows. Triangles that cross none of these rows may be missing. The object is empty if the construction was
  // cancelled. Runs on all threads of the arena. O(n + area).
  ScanlineCrossings(const TriangleSoup& closed, Progress progress = {},
                    const std::optional<Eigen::AlignedBox2i>& within = {});

  // Returns the crossings of a row, sorted by x.
  std::span<const Crossing> row(int y, int z) const;
  // Returns the winding number of a voxel. O(log crossings of the row).
  int winding(const VoxelIndex& voxel) const;
  bool isInside(const VoxelIndex& voxel) const { return winding(voxel) > 0; }

  // Returns true if all winding numbers are 0 or 1. Each triangle then bounds the inside.
  bool isSimple() const { return m_isSimple; }
  // Returns the largest winding number.
  int mostTurns() const { return m_mostTurns; }
  // A function that returns the winding number of a point, given the point and the integer winding number after the
  // crossing at the point.
  using Turns = std::function<double(const Vec3&, int)>;
  // Crossings at which rows enter or leave the inside.
  struct Bounding {
    std::vector<bool> triangles;                         // flags of the triangles that are crossed there
    std::vector<std::pair<Vec3, std::uint32_t>> points;  // points in voxels, each with its triangle
  };
  // Returns the crossings at which rows enter or leave the inside. A point is inside if its winding number, as returned
  // by `turns`, is above one half. O(crossings).
  Bounding boundingBy(const Turns& turns) const;
  // Returns flags of the triangles: true for each triangle that a row crosses.
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
