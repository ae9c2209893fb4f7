// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"
#include "volume/surface/ScanlineCrossings.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace handwheel {

class WindingNumberFill;

// The triangles of a closed surface that bound its inside. They are found by rows of voxel centres along all axes.
class BoundingTriangles {
 public:
  // closed: the surface in voxels. alongX: its crossings. holeFill: the membranes over its wide holes.
  BoundingTriangles(const TriangleSoup& closed, const ScanlineCrossings& alongX, const WindingNumberFill& holeFill,
                    const Progress& progress);

  // Returns true if every triangle bounds the inside, because no point is enclosed twice.
  bool isSimple() const { return m_isSimple; }
  // Returns the crossings at which rows pass between inside and outside, in voxels, each with its triangle. Rows along
  // y and z are only used if isSimple() is false.
  const std::vector<std::pair<Vec3, std::uint32_t>>& points() const { return m_points; }
  // Returns a flag for each triangle: true for those that bound the inside, or that no row crosses. cones: triangles
  // that do not count.
  std::vector<bool> withPerhaps(std::span<const std::uint32_t> cones) const;

 private:
  void add(const ScanlineCrossings& rows, int turn, const WindingNumberFill& holeFill);

  bool m_isSimple;
  std::vector<bool> m_certain;  // bounds the inside by the rows that cross it
  std::vector<bool> m_perhaps;  // no row along any axis crosses it
  std::vector<std::pair<Vec3, std::uint32_t>> m_points;
};

}  // namespace handwheel
