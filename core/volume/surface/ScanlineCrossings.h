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
// number is how often the surface goes round a voxel. Crossings are decided exactly, a row through an edge or corner as
// if it were shifted by something infinitely small, so the number outside is 0 on either end of every row.
class ScanlineCrossings {
 public:
  struct Crossing {
    double x;  // in voxels
    int step;  // 1: into the surface, -1: out of it
    std::uint32_t triangle;

    bool operator<(const Crossing& other) const { return std::pair(x, triangle) < std::pair(other.x, other.triangle); }
  };

  // Points in voxels: a voxel's centre has whole coordinates. Each edge of the surface is passed equally often both
  // ways (closeBoundaries()). O(n + area), on all threads of the arena. Nothing once cancelled. within: the rows that
  // are looked at, by their y and z; then triangles may be missing that none of them crosses. None: all.
  ScanlineCrossings(const TriangleSoup& closed, Progress progress = {},
                    const std::optional<Eigen::AlignedBox2i>& within = {});

  // The crossings of a row, by x.
  std::span<const Crossing> row(int y, int z) const;
  // O(log of the crossings in its row).
  int winding(const VoxelIndex& voxel) const;
  bool isInside(const VoxelIndex& voxel) const { return winding(voxel) > 0; }

  // Whether it goes round nothing more than once, nor backwards: then each triangle bounds the inside.
  bool isSimple() const { return m_isSimple; }
  // How often it goes round anything at most.
  int mostTurns() const { return m_mostTurns; }
  // Where rows go into the inside or out of it: the triangles, each with true, and the places. Inside is what has a
  // winding number above a half; turns(place, whole) is it, given the whole one there. O(crossings).
  using Turns = std::function<double(const Vec3&, int)>;
  struct Bounding {
    std::vector<bool> triangles;
    std::vector<std::pair<Vec3, std::uint32_t>> places;  // voxels, with the triangle
  };
  Bounding boundingBy(const Turns& turns) const;
  // Per triangle: whether any row crosses it.
  const std::vector<bool>& crossed() const { return m_crossed; }
  std::size_t bytes() const;

 private:
  Eigen::AlignedBox2i m_range;        // of y and z
  std::vector<std::size_t> m_begin;   // per row
  std::vector<Crossing> m_crossings;  // by row, then by x
  std::vector<int> m_after;           // the winding number behind each
  std::vector<bool> m_crossed;
  bool m_isSimple = true;
  int m_mostTurns = 0;
};

}  // namespace handwheel
