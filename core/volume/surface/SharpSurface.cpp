// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/surface/SharpSurface.h"

#include "proximity/SelfIntersection.h"
#include "volume/surface/SharpFeature.h"
#include "volume/surface/VolumeToSurface.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace handwheel {
namespace {

using Cell = std::array<int, 3>;  // by its lowest sample
using Edge = std::pair<std::uint32_t, std::uint32_t>;

VoxelIndex indexOf(const Cell& cell) {
  return {cell[0], cell[1], cell[2]};
}

constexpr double kBeside = 1.2;  // voxels, of the point of an edge from the cell that has it, at most
constexpr double kApart = 0.05;  // voxels, of such points from one another, at least

// Rounds points as many mesh files store them.
std::vector<Vec3> inSinglePrecision(std::vector<Vec3> points) {
  for (Vec3& p : points) p = rounded(p, NumberType::Float32);
  return points;
}

// A cell with one polygon, its consecutive triangles in the list, and its sharp feature.
struct SharpCell {
  Cell cell;
  std::vector<std::uint32_t> triangles;
  std::vector<Edge> sides;  // sides of the polygon
  SharpFeature feature;
  double away = 0.0;  // voxels, of the feature's point from the cell
  bool isUsed = true;
};

class Sharpening {
 public:
  Sharpening(const SparseVolume& volume, Progress progress) : m_volume(volume) {
    m_plain = surfaceOf(volume, progress.part(0.0, 0.2));
    findCells(progress.part(0.2, 0.5));
    rank();
    moveCrossings();
  }

  TriangleSoup run(Progress progress) {
    constexpr int kMostRounds = 40;  // each leaves out what met in the last; then all
    bool isRounded = false;
    int clean = 0;  // checks in a row: as it is, and rounded
    for (int round = 0; !progress.cancelled(); ++round) {
      if (round == kMostRounds)
        for (SharpCell& cell : m_cells) cell.isUsed = false;
      TriangleSoup made = assembled();
      const auto pairs = selfIntersections(isRounded ? inSinglePrecision(made.points) : made.points, made.triangles,
                                           progress.part(0.0, 1.0 - 1.0 / (2.0 + round)));
      if (!pairs) break;
      clean = leaveOut(*pairs) ? 0 : clean + 1;
      if (clean == 2) return made;
      if (clean == 1) isRounded = !isRounded;
    }
    return {};
  }

 private:
  Vec3 inVoxels(const Vec3& p) const { return (p - m_volume.origin()) / m_volume.voxel(); }

  Cell cellOf(const Triangle& t) const {
    const Vec3 middle = inVoxels((m_plain.points[t[0]] + m_plain.points[t[1]] + m_plain.points[t[2]]) / 3.0);
    return cellAt(middle);
  }
  static Cell cellAt(const Vec3& voxels) {
    return {static_cast<int>(std::floor(voxels.x())), static_cast<int>(std::floor(voxels.y())),
            static_cast<int>(std::floor(voxels.z()))};
  }

  // Returns the sides of the polygon of these triangles; none if there are several polygons.
  std::vector<Edge> polygonOf(const std::vector<std::uint32_t>& triangles) const {
    std::vector<Edge> sides;
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t i : triangles) {
      const Triangle& t = m_plain.triangles[i];
      for (std::size_t k = 0; k < 3; ++k) {
        corners.push_back(t[k]);
        const Edge back{t[(k + 1) % 3], t[k]};
        if (const auto inner = std::find(sides.begin(), sides.end(), back); inner != sides.end())
          sides.erase(inner);
        else
          sides.emplace_back(back.second, back.first);
      }
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners.size() == triangles.size() + 2 ? sides : std::vector<Edge>{};
  }

  void findCells(Progress progress) {
    std::vector<std::pair<Cell, std::uint32_t>> byCell(m_plain.triangles.size());
    for (std::size_t i = 0; i < byCell.size(); ++i)
      byCell[i] = {cellOf(m_plain.triangles[i]), static_cast<std::uint32_t>(i)};
    std::sort(byCell.begin(), byCell.end());
    std::vector<std::size_t> begins;
    for (std::size_t i = 0; i < byCell.size(); ++i)
      if (i == 0 || byCell[i].first != byCell[i - 1].first) begins.push_back(i);
    begins.push_back(byCell.size());
    std::vector<std::optional<SharpFeature>> features(begins.size() - 1);
    std::atomic<std::size_t> done{0};
    tbb::parallel_for(std::size_t{0}, features.size(), [&](std::size_t i) {
      if (progress.cancelled()) return;
      features[i] = featureOf(m_volume, indexOf(byCell[begins[i]].first));
      progress.set(static_cast<double>(++done) / static_cast<double>(features.size()));
    });
    for (std::size_t i = 0; i < features.size(); ++i) {
      if (!features[i]) continue;
      SharpCell cell{byCell[begins[i]].first, {}, {}, std::move(*features[i]), 0.0, true};
      for (std::size_t k = begins[i]; k < begins[i + 1]; ++k) cell.triangles.push_back(byCell[k].second);
      cell.sides = polygonOf(cell.triangles);
      if (!cell.sides.empty()) m_cells.push_back(std::move(cell));
    }
  }

  // Cells that an edge passes. If it passes a cell without a polygon, the cells around it join its ends, the nearest
  // first.
  void rank() {
    for (SharpCell& cell : m_cells) {
      const Vec3 off = (cell.feature.point - indexOf(cell.cell).cast<double>() - Vec3::Constant(0.5)).cwiseAbs();
      cell.away = (off.array() - 0.5).max(0.0).matrix().norm();
      cell.isUsed = cell.away <= kBeside;
    }
    std::stable_sort(m_cells.begin(), m_cells.end(),
                     [](const SharpCell& a, const SharpCell& b) { return a.away < b.away; });
    // Each position belongs to one cell, so that no triangle is degenerate.
    std::map<Cell, std::vector<Vec3>> taken;
    for (SharpCell& cell : m_cells) {
      const Vec3& point = cell.feature.point;
      for (int k = 0; k < 27 && cell.isUsed; ++k) {
        const Cell at = cellAt(point + Vec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1));
        const auto near = taken.find(at);
        cell.isUsed = near == taken.end() || std::none_of(near->second.begin(), near->second.end(),
                                                          [&](const Vec3& p) { return (p - point).norm() < kApart; });
      }
      if (cell.isUsed) taken[cellAt(point)].push_back(point);
    }
  }

  // Puts the corners of polygons beside an edge onto its planes, along the edges of cells that they are on.
  void moveCrossings() {
    constexpr double kLeast = 0.01;  // see shareToSurface()
    for (const SharpCell& cell : m_cells)
      for (const Edge& side : cell.sides) {
        const Vec3 at = inVoxels(m_plain.points[side.first]);
        int axis = 0;
        const Vec3 off = (at.array() - at.array().round()).abs();
        off.maxCoeff(&axis);
        VoxelIndex from = at.array().round().cast<int>();
        from[axis] = static_cast<int>(std::floor(at[axis]));
        const auto share = cell.feature.crossing(from, axis, m_volume.sample(from) > 0);
        if (!share || *share < 0.0 || *share > 1.0) continue;
        Vec3 moved = from.cast<double>();
        moved[axis] += std::clamp(*share, kLeast, 1.0 - kLeast);
        m_plain.points[side.first] = m_volume.origin() + m_volume.voxel() * moved;
      }
  }

  // The triangles of used cells are fans; where two of them meet at a face, their points are joined across it.
  TriangleSoup assembled() {
    TriangleSoup made{m_plain.points, {}};
    std::vector<bool> isReplaced(m_plain.triangles.size(), false);
    std::map<Edge, std::size_t> sides;
    std::vector<std::uint32_t> points(m_cells.size());
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
      const SharpCell& cell = m_cells[i];
      if (!cell.isUsed) continue;
      for (const std::uint32_t t : cell.triangles) isReplaced[t] = true;
      for (const Edge& side : cell.sides) sides.emplace(side, i);
      points[i] = static_cast<std::uint32_t>(made.points.size());
      made.points.push_back(m_volume.origin() + m_volume.voxel() * cell.feature.point);
    }
    m_owners.clear();
    const auto add = [&](const Triangle& t, std::size_t a, std::size_t b) {
      made.triangles.push_back(t);
      m_owners.emplace_back(a, b);
    };
    for (std::size_t t = 0; t < isReplaced.size(); ++t)
      if (!isReplaced[t]) add(m_plain.triangles[t], kNobody, kNobody);
    std::map<std::pair<std::size_t, std::size_t>, int> joined;  // number of shared sides of two cells
    for (const auto& [side, i] : sides)
      if (const auto other = sides.find({side.second, side.first}); other != sides.end() && i < other->second)
        ++joined[{i, other->second}];
    for (const auto& [side, i] : sides) {
      const auto other = sides.find({side.second, side.first});
      const bool isJoined = other != sides.end() && joined.at(std::minmax(i, other->second)) == 1;
      if (!isJoined)
        add({side.first, side.second, points[i]}, i, i);
      else  // (a, b, P) and (b, a, Q) become (a, Q, P) and (b, P, Q)
        add({side.first, points[other->second], points[i]}, i, other->second);
    }
    return made;
  }

  // Leaves out of each pair of triangles that meet the cells whose point is farthest away; false when there are none.
  bool leaveOut(const std::vector<TrianglePair>& pairs) {
    std::set<std::size_t> left;
    for (const auto& [first, second] : pairs) {
      double farthest = -1.0;
      for (const std::uint32_t t : {first, second})
        for (const std::size_t cell : {m_owners[t].first, m_owners[t].second})
          if (cell != kNobody) farthest = std::max(farthest, m_cells[cell].away);
      for (const std::uint32_t t : {first, second})
        for (const std::size_t cell : {m_owners[t].first, m_owners[t].second})
          if (cell != kNobody && m_cells[cell].away >= farthest) left.insert(cell);
    }
    for (const std::size_t cell : left) m_cells[cell].isUsed = false;
    return !left.empty();
  }

  static constexpr std::size_t kNobody = static_cast<std::size_t>(-1);

  const SparseVolume& m_volume;
  TriangleSoup m_plain;
  std::vector<SharpCell> m_cells;
  std::vector<std::pair<std::size_t, std::size_t>> m_owners;  // cells of each triangle that was made
};

}  // namespace

TriangleSoup sharpSurfaceOf(const SparseVolume& volume, Progress progress) {
  Sharpening sharpening(volume, progress.part(0.0, 0.5));
  return sharpening.run(progress.part(0.5, 1.0));
}

}  // namespace handwheel
