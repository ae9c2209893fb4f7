// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/SurfaceDensity.h"

#include "volume/VolumeFilters.h"
#include "volume/repair/BoundingTriangles.h"
#include "volume/repair/ClosedSurfaceInVoxels.h"
#include "volume/repair/WindingNumberFill.h"
#include "volume/surface/ScanlineCrossings.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

constexpr int kRays = 2;                      // to a voxel, along either axis across them
constexpr double kShift = 0.5 * (kRays - 1);  // shift of the rays, which are evenly distributed within a voxel
constexpr double kGreys = 255.0;

// A surface met by rays along an axis: along x of a space whose axes are turned, and whose y and z count rays.
class AxisRays {
 public:
  AxisRays(const TriangleSoup& closed, int axis, const Progress& progress)
      : m_axis(axis), m_rows(turned(closed, axis), progress) {}

  // Adds the length within each voxel of a block that is inside, over all rays.
  void add(const VoxelIndex& block, std::array<float, VolumeBlock::kCount>& sums) const {
    constexpr int n = VolumeBlock::kSize;
    const VoxelIndex first = n * block;
    const int across = (m_axis + 1) % 3, up = (m_axis + 2) % 3;
    for (int j = 0; j < n * kRays; ++j)
      for (int k = 0; k < n * kRays; ++k) {
        VoxelIndex in = VoxelIndex::Zero();
        in[across] = j / kRays;
        in[up] = k / kRays;
        addRay(kRays * first[across] + j, kRays * first[up] + k, first[m_axis], in, sums);
      }
  }

  // Calls visit(voxel) for each in which a ray passes the surface.
  template <class Visit>
  void forEachPassed(const VoxelIndex& low, const VoxelIndex& high, Visit visit) const {
    const int across = (m_axis + 1) % 3, up = (m_axis + 2) % 3;
    for (int k = kRays * low[up]; k < kRays * (high[up] + 1); ++k)
      for (int j = kRays * low[across]; j < kRays * (high[across] + 1); ++j)
        for (const ScanlineCrossings::Crossing& crossing : m_rows.row(j, k)) {
          VoxelIndex at;
          at[m_axis] = static_cast<int>(std::floor(crossing.x + 0.5));
          at[across] = (j - (j & 1)) / kRays;
          at[up] = (k - (k & 1)) / kRays;
          visit(at);
        }
  }

  // Adds some of the points where rays enter or leave the inside; voxels.
  void addBounding(std::vector<Vec3>& points) const {
    constexpr std::size_t kMost = 100'000;
    const auto found = m_rows.boundingBy([](const Vec3&, int turns) { return static_cast<double>(turns); }).points;
    for (std::size_t i = 0; i < found.size(); i += found.size() / kMost + 1) {
      Vec3 at;
      at[m_axis] = found[i].first.x();
      at[(m_axis + 1) % 3] = (found[i].first.y() - kShift) / kRays;
      at[(m_axis + 2) % 3] = (found[i].first.z() - kShift) / kRays;
      points.push_back(at);
    }
  }
  int mostTurns() const { return m_rows.mostTurns(); }

  // Tests approximately the centre of a voxel.
  bool isInside(const VoxelIndex& voxel) const {
    return m_rows.isInside({voxel[m_axis], kRays * voxel[(m_axis + 1) % 3], kRays * voxel[(m_axis + 2) % 3]});
  }

 private:
  static TriangleSoup turned(const TriangleSoup& closed, int axis) {
    TriangleSoup made = closed;
    for (Vec3& p : made.points)
      p = Vec3(p[axis], kRays * p[(axis + 1) % 3] + kShift, kRays * p[(axis + 2) % 3] + kShift);
    return made;
  }

  void addRay(int y, int z, int first, const VoxelIndex& in, std::array<float, VolumeBlock::kCount>& sums) const {
    const double low = first - 0.5, high = low + VolumeBlock::kSize;
    int winding = 0;
    double from = -std::numeric_limits<double>::infinity();
    const auto addUpTo = [&](double to) {
      const double begin = std::max(from, low), end = std::min(to, high);
      VoxelIndex at = in;
      for (auto i = static_cast<int>(begin - low); begin < end && i < VolumeBlock::kSize && low + i < end; ++i) {
        at[m_axis] = i;
        const double share = std::min(end, low + i + 1.0) - std::max(begin, low + i);
        sums[VolumeBlock::at(at.x(), at.y(), at.z())] += static_cast<float>(share);
      }
    };
    for (const ScanlineCrossings::Crossing& crossing : m_rows.row(y, z)) {
      if (winding > 0) addUpTo(crossing.x);
      winding += crossing.step;
      from = crossing.x;
      if (from >= high) return;
    }
  }

  int m_axis;
  ScanlineCrossings m_rows;
};

using ThreeAxes = std::array<AxisRays, 3>;

// The blocks with voxels that are neither full nor empty, and those beside them.
std::vector<VoxelIndex> passedBlocks(const ThreeAxes& rays, const VoxelIndex& blocks) {
  std::vector<VoxelIndex> passed;
  const VoxelIndex high = VolumeBlock::kSize * blocks;
  for (const AxisRays& axis : rays) {
    axis.forEachPassed(VoxelIndex::Zero(), high, [&](const VoxelIndex& at) {
      const VoxelIndex block = SparseVolume::blockOf(at);
      if (passed.empty() || passed.back() != block) passed.push_back(block);
    });
    sortUnique(passed);
  }
  return withNeighbours(passed);
}

SparseVolume::Content densityBlock(const ThreeAxes& rays, const VoxelIndex& at) {
  std::array<float, VolumeBlock::kCount> sums{};
  for (const AxisRays& axis : rays) axis.add(at, sums);
  auto block = std::make_shared<VolumeBlock>();
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double density = std::round(kGreys * static_cast<double>(sums[i]) / (3.0 * kRays * kRays)) / kGreys;
    block->depths[i] = depthSample(density - 0.5);
  }
  return {std::move(block), false};
}

}  // namespace

Result<SurfaceVolume> volumeByDensity(const TriangleSoup& soup, double voxel, Progress progress) {
  const Result<ClosedSurfaceInVoxels> prepared =
      closedInVoxels(soup, voxel, std::numeric_limits<double>::infinity(), {}, progress.part(0.0, 0.1));
  if (!prepared) return prepared.error();
  const TriangleSoup& closed = prepared->closed;
  const ThreeAxes rays{AxisRays(closed, 0, progress), AxisRays(closed, 1, progress), AxisRays(closed, 2, progress)};
  const VoxelIndex extent = prepared->blocks();
  const std::vector<VoxelIndex> blocks = passedBlocks(rays, extent);
  SurfaceVolume made{prepared->grid, prepared->caps.boundaries, prepared->enclosed(), 0.0, {}, 0, {}};
  std::vector<SparseVolume::Content> contents(blocks.size());
  std::atomic<std::size_t> done{0};
  const Progress sampling = progress.part(0.4, 0.8);
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
    if (progress.cancelled()) return;
    contents[i] = densityBlock(rays, blocks[i]);
    sampling.set(static_cast<double>(++done) / static_cast<double>(blocks.size()));
  });
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  for (std::size_t i = 0; i < blocks.size(); ++i) made.volume.setContent(blocks[i], std::move(contents[i]));
  for (int z = 0; z < extent.z(); ++z)
    for (int y = 0; y < extent.y(); ++y)
      for (int x = 0; x < extent.x(); ++x) {
        const VoxelIndex at(x, y, z);
        if (!made.volume.content(at).block && rays[0].isInside(VolumeBlock::kSize * at))
          made.volume.setContent(at, {nullptr, true});
      }
  makeDistances(made.volume, blocks, DepthWindow::Beside::Corrected, progress.part(0.8, 0.95));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  if (!(made.volume.material() > 0.0)) return prepared->nothingInside();
  std::vector<Vec3> points;
  for (const AxisRays& axis : rays) axis.addBounding(points);
  made.nearShare = nearShare(made.volume, points, progress.part(0.95, 0.97));
  const BoundingTriangles found(closed, ScanlineCrossings(closed, progress), WindingNumberFill(closed, {}, progress),
                                progress);
  made.thin = thinParts(*prepared, soup.triangles.size(), found, found.withPerhaps({}), progress.part(0.97, 1.0));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  if (const auto lost = lossRefusal(made.volume, made.nearShare, made.expected / std::max(1, rays[0].mostTurns())))
    return *lost;
  return made;
}

Result<SurfaceVolume> volumeOfSurface(const TriangleSoup& soup, double voxel, VoxelMethod method, Progress progress) {
  return method == VoxelMethod::Density ? volumeByDensity(soup, voxel, progress)
                                        : volumeOfSurface(soup, voxel, progress);
}

}  // namespace handwheel
