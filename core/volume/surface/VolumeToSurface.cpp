// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/surface/VolumeToSurface.h"

#include "volume/surface/BlockCells.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <bit>
#include <unordered_map>
#include <vector>

namespace handwheel {
namespace {

constexpr std::size_t kBlocksAtOnce = 16;

// The edges of a block that the surface crosses, and the index of its first point.
struct CrossedEdges {
  VoxelIndex block;
  std::array<std::uint64_t, BlockCells::kEdges / 64> bits{};
  std::array<std::uint16_t, BlockCells::kEdges / 64> before{};  // bits set in the words before
  std::uint32_t firstPoint = 0;
  std::uint32_t firstTriangle = 0;
  std::uint32_t points = 0, triangles = 0;

  std::uint32_t pointOf(std::size_t edge) const {
    const std::uint64_t below = bits[edge / 64] & ((std::uint64_t{1} << edge % 64) - 1);
    return firstPoint + before[edge / 64] + static_cast<std::uint32_t>(std::popcount(below));
  }
};

std::uint64_t keyOf(const VoxelIndex& block) {
  std::uint64_t key = 0;
  for (int k = 0; k < 3; ++k) key = key << 21 | (static_cast<std::uint32_t>(block[k]) & 0x1fffff);
  return key;
}

using BlockNumbers = std::unordered_map<std::uint64_t, std::uint32_t>;

// Adds what of the neighbours of the first `own` blocks is not in the list yet, in the directions given.
void addNeighbours(std::vector<VoxelIndex>& blocks, std::size_t own, int direction) {
  BlockNumbers known;
  known.reserve(2 * own);
  for (std::size_t i = 0; i < own; ++i) known.emplace(keyOf(blocks[i]), 0);
  for (std::size_t i = 0; i < own; ++i)
    for (int k = 1; k < 8; ++k) {
      const VoxelIndex next = blocks[i] + direction * VoxelIndex(k & 1, k >> 1 & 1, k >> 2);
      if (known.emplace(keyOf(next), 0).second) blocks.push_back(next);
    }
}

// Leaves out the points that no triangle has.
void dropUnused(TriangleSoup& soup) {
  std::vector<std::uint32_t> number(soup.points.size(), kNone);
  std::uint32_t used = 0;
  std::vector<bool> isUsed(soup.points.size(), false);
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t v : t) isUsed[v] = true;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (!isUsed[i]) continue;
    soup.points[used] = soup.points[i];
    number[i] = used++;
  }
  soup.points.resize(used);
  for (Triangle& t : soup.triangles)
    for (std::uint32_t& v : t) v = number[v];
}

}  // namespace

std::vector<VoxelIndex> blocksWithCells(const SparseVolume& volume) {
  std::vector<VoxelIndex> all = volume.blocks();
  addNeighbours(all, all.size(), -1);
  return all;
}

TriangleSoup surfaceOf(const SparseVolume& volume, Progress progress) {
  // The blocks with cells, and then those that own edges of theirs.
  std::vector<VoxelIndex> blocks = blocksWithCells(volume);
  const std::size_t cellBlocks = blocks.size();
  addNeighbours(blocks, cellBlocks, 1);
  std::vector<CrossedEdges> crossed(blocks.size());
  const auto forAll = [&](Progress part, auto work) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks.size(), kBlocksAtOnce),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        if (part.cancelled()) return;
                        for (std::size_t i = range.begin(); i < range.end(); ++i) work(i);
                        part.set(static_cast<double>(range.end()) / static_cast<double>(blocks.size()));
                      });
  };
  forAll(progress.part(0.0, 0.5), [&](std::size_t i) {
    CrossedEdges& edges = crossed[i];
    edges.block = blocks[i];
    const BlockCells cells(volume, blocks[i]);
    cells.forEachCrossedEdge([&](std::size_t edge, double) { edges.bits[edge / 64] |= std::uint64_t{1} << edge % 64; });
    for (std::size_t w = 0; w < edges.bits.size(); ++w) {
      edges.before[w] = static_cast<std::uint16_t>(edges.points);
      edges.points += static_cast<std::uint32_t>(std::popcount(edges.bits[w]));
    }
    if (i < cellBlocks) cells.forEachTriangle([&](const auto&) { ++edges.triangles; });
  });
  TriangleSoup soup;
  if (progress.cancelled()) return soup;
  BlockNumbers numbers;
  numbers.reserve(blocks.size());
  std::uint32_t points = 0, triangles = 0;
  for (std::size_t i = 0; i < crossed.size(); ++i) {
    crossed[i].firstPoint = points;
    crossed[i].firstTriangle = triangles;
    points += crossed[i].points;
    triangles += crossed[i].triangles;
    numbers.emplace(keyOf(blocks[i]), static_cast<std::uint32_t>(i));
  }
  soup.points.resize(points);
  soup.triangles.resize(triangles);
  forAll(progress.part(0.5, 1.0), [&](std::size_t i) {
    if (crossed[i].points == 0 && crossed[i].triangles == 0) return;
    const BlockCells cells(volume, blocks[i]);
    std::uint32_t point = crossed[i].firstPoint;
    cells.forEachCrossedEdge(
        [&](std::size_t edge, double share) { soup.points[point++] = cells.pointOn(edge, share); });
    if (crossed[i].triangles == 0) return;
    std::uint32_t triangle = crossed[i].firstTriangle;
    cells.forEachTriangle([&](const std::array<BlockCells::Edge, 3>& corners) {
      Triangle& t = soup.triangles[triangle++];
      for (std::size_t k = 0; k < 3; ++k) {
        const auto owner = numbers.at(keyOf(blocks[i] + corners[k].block));
        t[k] = crossed[owner].pointOf(corners[k].edge);
      }
    });
  });
  if (progress.cancelled()) return {};
  dropUnused(soup);
  return soup;
}

}  // namespace handwheel
