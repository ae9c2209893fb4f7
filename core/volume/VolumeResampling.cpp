// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeResampling.h"

#include "base/NumberText.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeFilters.h"
#include "volume/VolumeMemory.h"
#include "volume/VolumeSampler.h"
#include "volume/VolumeSerialization.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

namespace handwheel {
namespace {

constexpr double kRegion = 64.0;      // voxels along an edge of a region
constexpr double kSameGrid = 1e-6;    // voxels, that grids may be apart by rounding
constexpr double kMostCoarser = 2.0;  // depths go four voxels deep: twice as coarse, they still pass the next voxel

bool isSameLength(double voxel, double other) {
  return std::abs(voxel / other - 1.0) < 1e-9;
}

// Returns the shift between the grids in blocks; none if it is not an integer.
std::optional<VoxelIndex> wholeBlocks(const SparseVolume& volume, const Vec3& origin, double voxel) {
  if (!isSameLength(volume.voxel(), voxel)) return std::nullopt;
  const Vec3 blocks = (volume.origin() - origin) / (VolumeBlock::kSize * voxel);
  const Vec3 whole = blocks.array().round();
  if (!((blocks - whole).cwiseAbs().maxCoeff() * VolumeBlock::kSize < kSameGrid)) return std::nullopt;
  return whole.cast<int>();
}

SparseVolume shifted(const SparseVolume& volume, const Vec3& origin, double voxel, const VoxelIndex& blocks) {
  SparseVolume made(origin, voxel);
  volume.forEach(
      [&](const VoxelIndex& at, const SparseVolume::Content& content) { made.setContent(at + blocks, content); });
  return made;
}

// From one grid into another.
class Resampling {
 public:
  Resampling(const SparseVolume& from, const Vec3& origin, double voxel) : m_from(from), m_made(origin, voxel) {}

  Result<SparseVolume> run(Progress progress) {
    if (const std::optional<Error> error = refusal()) return *error;
    const std::vector<VoxelIndex> blocks = candidates(progress);
    std::vector<SparseVolume::Content> made(blocks.size());
    std::atomic<std::size_t> done{0};
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
      if (progress.cancelled()) return;
      made[i] = contentAt(blocks[i]);
      progress.set(static_cast<double>(++done) / static_cast<double>(blocks.size()));
    });
    for (std::size_t i = 0; i < blocks.size(); ++i) m_made.setContent(blocks[i], std::move(made[i]));
    if (m_made.voxel() > m_from.voxel()) makeDistances(m_made, m_made.blocks(), DepthWindow::Beside::Kept, progress);
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    return std::move(m_made);
  }

 private:
  // Converts the coordinates of a voxel between the grids.
  Vec3 toMade(const Vec3& voxel) const {
    return (m_from.origin() + m_from.voxel() * voxel - m_made.origin()) / m_made.voxel();
  }
  Vec3 toFrom(const Vec3& voxel) const {
    return (m_made.origin() + m_made.voxel() * voxel - m_from.origin()) / m_from.voxel();
  }

  std::optional<Error> refusal() const {
    const Box box = m_from.extent();
    if (box.isEmpty()) return std::nullopt;
    constexpr double kMost = SparseVolume::kMostVoxels - kRegion;
    const double farthest = std::max(toMade(box.min()).cwiseAbs().maxCoeff(), toMade(box.max()).cwiseAbs().maxCoeff());
    const double voxel = m_made.voxel();
    if (!(farthest < kMost))
      return Error{VolumeErrors::TooFine,
                   {roundedText(voxel), roundedText(farthest * voxel), roundedText(farthest * voxel / kMost)},
                   {},
                   {}};
    // The number of blocks at surfaces grows with the square, that of regions with the cube; both exist twice
    // temporarily.
    const double finer = std::max(1.0, m_from.voxel() / voxel);
    const auto bytes = 2.0 * finer * finer * static_cast<double>(m_from.blockCount()) * (sizeof(VolumeBlock) + 64.0) +
                       finer * finer * finer * static_cast<double>(regionsOf(m_from).size()) * kRegionBytes;
    return memoryRefusal(voxel, bytes);
  }
  static constexpr double kRegionBytes = 512.0 * 24.0;  // pointers of its blocks, and their list here

  // The blocks that the regions of the other grid reach.
  std::vector<VoxelIndex> candidates(const Progress& progress) const {
    std::vector<VoxelIndex> blocks;
    for (const VoxelIndex& region : regionsOf(m_from)) {
      if (progress.cancelled()) break;
      const Vec3 first = kRegion * region.cast<double>();
      const VoxelIndex low = SparseVolume::blockOf(toMade(first - Vec3::Ones()).array().floor().cast<int>().matrix());
      const VoxelIndex high =
          SparseVolume::blockOf(toMade(first + Vec3::Constant(kRegion)).array().ceil().cast<int>().matrix());
      for (int z = low.z(); z <= high.z(); ++z)
        for (int y = low.y(); y <= high.y(); ++y)
          for (int x = low.x(); x <= high.x(); ++x) blocks.emplace_back(x, y, z);
    }
    sortUnique(blocks);
    return blocks;
  }

  SparseVolume::Content contentAt(const VoxelIndex& block) const {
    constexpr double n = VolumeBlock::kSize;
    const Vec3 first = n * block.cast<double>();
    if (const auto isFull = uniformIn(toFrom(first), toFrom(first + Vec3::Constant(n - 1.0))))
      return {nullptr, *isFull};
    const VolumeSampler sampler(m_from);
    const double voxel = m_made.voxel();
    // The slope of interpolated depths is at most this, and the corners of a block are 6.1 voxels away.
    constexpr double kSteepest = 1.8, kFar = VolumeBlock::kFull / VolumeBlock::kUnit + kSteepest * 6.1;
    const double middle = sampler.depthAt(m_made.origin() + voxel * (first + Vec3::Constant(0.5 * (n - 1.0)))).depth;
    if (std::abs(middle) > kFar * voxel) return {nullptr, middle > 0.0};
    // Samples at the limit of the source must remain at the limit.
    const double limit = 0.999 * m_from.voxel() * VolumeBlock::kFull / VolumeBlock::kUnit;
    auto samples = std::make_shared<VolumeBlock>();
    for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
      const VoxelIndex at = VolumeBlock::kSize * block + VoxelIndex(i & 7, i >> 3 & 7, i >> 6);
      const double depth = sampler.depthAt(m_made.centre(at)).depth;
      std::int16_t& sample = samples->depths[static_cast<std::size_t>(i)];
      sample = depthSample(depth / voxel);
      if (std::abs(depth) >= limit) sample = depth > 0.0 ? VolumeBlock::kFull : VolumeBlock::kEmpty;
    }
    return contentOf(std::move(samples));
  }

  // Returns the uniform value of the source between two corners, including all samples that contribute there; none: it
  // is not uniform.
  std::optional<bool> uniformIn(const Vec3& low, const Vec3& high) const {
    const VoxelIndex from = SparseVolume::blockOf(low.array().floor().cast<int>().matrix());
    const VoxelIndex to = SparseVolume::blockOf((high.array().floor() + 1.0).cast<int>().matrix());
    const bool isFull = m_from.view(from).isFull;
    for (int z = from.z(); z <= to.z(); ++z)
      for (int y = from.y(); y <= to.y(); ++y)
        for (int x = from.x(); x <= to.x(); ++x) {
          const SparseVolume::View view = m_from.view(VoxelIndex(x, y, z));
          if (view.block || view.isFull != isFull) return std::nullopt;
        }
    return isFull;
  }

  const SparseVolume& m_from;
  SparseVolume m_made;
};

}  // namespace

Result<SparseVolume> resampled(const SparseVolume& volume, const Vec3& origin, double voxel, Progress progress) {
  if (const auto blocks = wholeBlocks(volume, origin, voxel)) {
    // Checks the range of block indices.
    const Box box = volume.extent();
    const Vec3 shift = VolumeBlock::kSize * blocks->cast<double>();
    constexpr double kMost = SparseVolume::kMostVoxels;
    if (box.isEmpty() || (box.min() + shift).cwiseAbs().cwiseMax((box.max() + shift).cwiseAbs()).maxCoeff() < kMost)
      return shifted(volume, origin, voxel, *blocks);
  }
  SparseVolume coarser = volume;
  while (voxel > kMostCoarser * coarser.voxel() * (1.0 + 1e-9)) {
    Result<SparseVolume> half =
        Resampling(coarser, coarser.origin(), kMostCoarser * coarser.voxel()).run(progress.part(0.0, 0.5));
    if (!half) return half;
    coarser = std::move(*half);
  }
  return Resampling(coarser, origin, voxel).run(progress.part(0.5, 1.0));
}

}  // namespace handwheel
