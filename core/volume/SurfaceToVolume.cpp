// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/SurfaceToVolume.h"

#include "volume/repair/BoundingTriangles.h"
#include "volume/repair/ClosedSurfaceInVoxels.h"
#include "volume/repair/CrumbRemoval.h"
#include "volume/repair/WindingNumberFill.h"
#include "volume/surface/ScanlineCrossings.h"
#include "volume/surface/SurfaceTile.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <vector>

namespace handwheel {
namespace {

constexpr double kBand = SurfaceTile::kBand;
constexpr double kBytesOfBlock = sizeof(VolumeBlock) + 64.0;
// Temporary memory in addition to the result, and memory of the triangles of its surface, relative to the result;
// measured.
constexpr double kWhileMaking = 1.5, kTriangleShare = 4.0;
// Time of one thread for a block with its triangles: 5.3 s for 61,242 blocks (docs/adr/0041). The least time of a job
// is an estimate; s.
constexpr double kSecondsOfBlock = 87e-6, kSecondsOfJob = 0.01;
constexpr int kTile = SurfaceTile::kSide;

using Tile = std::array<int, 3>;  // its number along z, y, x: the order of the map
using Tiles = std::vector<std::pair<Tile, std::vector<std::uint32_t>>>;

int floorOf(double v) {
  return static_cast<int>(std::floor(v));
}

// The triangles that come within the band of each tile, and the tiles of membranes; all in voxels.
Tiles tilesNear(const TriangleSoup& soup, const std::vector<bool>& isUsed, const WindingNumberFill& holeFill,
                const Progress& progress) {
  std::map<Tile, std::vector<std::uint32_t>> near;
  const double halfDiagonal = 0.5 * kTile * std::sqrt(3.0);
  for (std::size_t i = 0; i < soup.triangles.size() && !progress.cancelled(); ++i) {
    if (!isUsed[i]) continue;
    const SurfaceTile::Corners t(soup, soup.triangles[i]);
    const Vec3 low = (t.low().array() - kBand) / kTile, high = (t.high().array() + kBand) / kTile;
    for (int z = floorOf(low.z()); z <= high.z(); ++z)
      for (int y = floorOf(low.y()); y <= high.y(); ++y)
        for (int x = floorOf(low.x()); x <= high.x(); ++x) {
          const Vec3 middle = kTile * Vec3(x + 0.5, y + 0.5, z + 0.5);
          if (std::abs(t.normal.dot(middle - t.a)) <= halfDiagonal + kBand)
            near[{z, y, x}].push_back(static_cast<std::uint32_t>(i));
        }
  }
  for (const VoxelIndex& block : holeFill.blocks()) {
    const auto tileOf = [](int i) { return floorOf(static_cast<double>(i) / SurfaceTile::kBlocks); };
    near.try_emplace({tileOf(block.z()), tileOf(block.y()), tileOf(block.x())});
  }
  return {std::make_move_iterator(near.begin()), std::make_move_iterator(near.end())};
}

using NumberedBlock = std::pair<VoxelIndex, SparseVolume::Content>;

// The content of a block where membranes can be.
SparseVolume::Content holeFillBlock(const SurfaceTile& distances, const VoxelIndex& inTile,
                                    const WindingNumberFill::Samples& holeFill) {
  auto block = std::make_shared<VolumeBlock>();
  bool isNear = false;
  for (std::size_t i = 0; i < VolumeBlock::kCount; ++i) {
    const auto at = static_cast<int>(i);
    const float fromSurface = distances.squared(inTile + VoxelIndex(at & 7, at >> 3 & 7, at >> 6));
    const float squared = std::min(fromSurface, holeFill.distance[i] * holeFill.distance[i]);
    isNear = isNear || squared < SurfaceTile::kFar;
    block->depths[i] = SurfaceTile::sampleAt(squared, holeFill.isInside[i]);
  }
  if (!isNear) return {nullptr, holeFill.isInside.front()};
  return {std::move(block), false};
}

bool isFarFromTriangles(const SurfaceTile& distances, const VoxelIndex& inTile) {
  for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i)
    if (distances.squared(inTile + VoxelIndex(i & 7, i >> 3 & 7, i >> 6)) < SurfaceTile::kFar) return false;
  return true;
}

// Marks the blocks without samples that are inside. The boundary of the inside is in blocks with samples, so one voxel
// represents its block.
void fillInside(SparseVolume& volume, const ScanlineCrossings& rows, const WindingNumberFill& holeFill,
                const VoxelIndex& blocks, const Progress& progress) {
  for (int z = 0; z < blocks.z() && !progress.cancelled(); ++z)
    for (int y = 0; y < blocks.y(); ++y) {
      if (rows.row(8 * y, 8 * z).empty()) continue;
      for (int x = 0; x < blocks.x(); ++x) {
        const VoxelIndex at(x, y, z);
        if (!rows.isInside(8 * at) || volume.content(at).block || holeFill.contains(at)) continue;
        volume.setContent(at, {nullptr, true});
      }
    }
}

// Selects points evenly, except those on triangles that close the surface; mm.
std::vector<Vec3> keptPoints(const std::vector<std::pair<Vec3, std::uint32_t>>& points, std::size_t triangles,
                             const SparseVolume& volume) {
  constexpr std::size_t kMost = 100'000;
  const std::size_t step = points.size() / kMost + 1;
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < points.size(); i += step)
    if (points[i].second < triangles) kept.push_back(volume.origin() + volume.voxel() * points[i].first);
  return kept;
}

std::vector<Vec3> inVoxels(std::vector<Vec3> points, const SparseVolume& volume) {
  for (Vec3& p : points) p = (p - volume.origin()) / volume.voxel();
  return points;
}

}  // namespace

Result<SurfaceVolume> volumeOfSurface(const TriangleSoup& soup, double voxel, Progress progress,
                                      const std::optional<Vec3>& alignedTo) {
  Result<ClosedSurfaceInVoxels> prepared =
      closedInVoxels(soup, voxel, WindingNumberFill::kWide, alignedTo, progress.part(0.0, 0.05));
  if (!prepared) return prepared.error();
  const TriangleSoup& closed = prepared->closed;
  const BoundaryCaps& caps = prepared->caps;
  SurfaceVolume made;
  made.volume = prepared->grid;
  made.closedBoundaries = caps.boundaries;
  const ScanlineCrossings rows(closed, progress.part(0.05, 0.3));
  const WindingNumberFill holeFill(closed, caps.wide, progress);
  const BoundingTriangles found(closed, rows, holeFill, progress.part(0.3, 0.4));
  const std::vector<bool> bounding = found.withPerhaps(caps.wide);
  const Tiles tiles = tilesNear(closed, bounding, holeFill, progress);

  std::vector<std::vector<NumberedBlock>> blocks(tiles.size());
  std::atomic<std::size_t> done{0};
  const Progress sampling = progress.part(0.4, 0.85);
  tbb::parallel_for(std::size_t{0}, tiles.size(), [&](std::size_t i) {
    if (progress.cancelled()) return;
    const Tile& tile = tiles[i].first;
    const VoxelIndex first = kTile * VoxelIndex(tile[2], tile[1], tile[0]);
    SurfaceTile distances(first);
    for (const std::uint32_t t : tiles[i].second) distances.add({closed, closed.triangles[t]});
    for (int b = 0; b < SurfaceTile::kAllBlocks; ++b) {
      const VoxelIndex inTile = VolumeBlock::kSize * SurfaceTile::blockAt(b);
      const VoxelIndex block = SparseVolume::blockOf(first + inTile);
      SparseVolume::Content content;
      if (!holeFill.contains(block))
        content.block = distances.signedBlock(inTile, rows);
      else if (holeFill.isFarFromMembranes(block) && isFarFromTriangles(distances, inTile))
        content.isFull = holeFill.isInside(VolumeBlock::kSize * block, rows);
      else
        content = holeFillBlock(distances, inTile, holeFill.samples(block, rows));
      if (content.block || content.isFull) blocks[i].emplace_back(block, std::move(content));
    }
    sampling.set(static_cast<double>(++done) / static_cast<double>(tiles.size()));
  });
  for (std::vector<NumberedBlock>& some : blocks)
    for (NumberedBlock& block : some) made.volume.setContent(block.first, std::move(block.second));
  fillInside(made.volume, rows, holeFill, prepared->blocks(), progress);
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  made.expected = prepared->enclosed();
  if (!(made.volume.material() > 0.0)) return prepared->nothingInside();
  std::vector<std::pair<Vec3, std::uint32_t>> points = found.points();
  made.removedCrumbs = removeCrumbs(made.volume, *prepared, soup.triangles.size(), points, progress);
  made.thin = thinParts(*prepared, soup.triangles.size(), found, bounding, progress.part(0.85, 0.9));
  made.kept = keptPoints(points, soup.triangles.size(), made.volume);
  const Progress comparing = progress.part(0.9, 1.0);
  made.nearShare = rows.isSimple() ? prepared->nearShare(made.volume, bounding, comparing)
                                   : nearShare(made.volume, inVoxels(made.kept, made.volume), comparing);
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  // Cones do not enclose the volume that a membrane closes.
  const double least = caps.wide.empty() ? made.expected / std::max(1, rows.mostTurns()) : 0.0;
  if (const auto lost = lossRefusal(made.volume, made.nearShare, least)) return *lost;
  progress.set(1.0);
  return made;
}

double usualVoxel(const TriangleSoup& surface, double across) {
  Box bounds;
  for (const Vec3& p : surface.points) bounds.extend(p);
  const double extent = bounds.isEmpty() ? 0.0 : bounds.sizes().maxCoeff();
  return extent > 0.0 ? extent / across : 1.0;
}

double surfaceArea(const TriangleSoup& soup) {
  double area = 0.0;
  for (const Triangle& t : soup.triangles)
    area += 0.5 * (soup.points[t[1]] - soup.points[t[0]]).cross(soup.points[t[2]] - soup.points[t[0]]).norm();
  return area;
}

double predictedBlocks(double area, double voxel) {
  // A plane in any direction, three voxels thick on either side, meets so many blocks to its area: their mean extent
  // across it is 1.5 edges (the mean projection of a cube), and the band's two more.
  const double edge = VolumeBlock::kSize * voxel;
  return area / (edge * edge) * (1.5 + 2.0 * kBand / VolumeBlock::kSize);
}

double predictedVolumeBytes(double area, double voxel) {
  return kBytesOfBlock * predictedBlocks(area, voxel);
}

double predictedMakingBytes(double area, const Vec3& extent, double voxel) {
  const double rows = extent.y() / voxel * (extent.z() / voxel);
  return predictedVolumeBytes(area, voxel) * (1.0 + kWhileMaking + kTriangleShare) +
         rows * sizeof(std::size_t);  // their index
}

double predictedMakingSeconds(double area, double voxel) {
  return kSecondsOfJob + kSecondsOfBlock * predictedBlocks(area, voxel) / tbb::this_task_arena::max_concurrency();
}

}  // namespace handwheel
