// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/ClayDab.h"

#include "volume/VolumeFilters.h"
#include "volume/VolumeReader.h"
#include "volume/repair/DepthWindow.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr double kDepths = DepthWindow::kMargin;  // voxels from the surface that depths reach
constexpr double kInflation = 0.5;                // voxels that a dab of full strength moves the surface by
constexpr double kLargestShift = 0.25;            // of the radius that material goes in a dab

// A dab in voxels.
struct VoxelDab {
  ClayAction action;
  Vec3 centre, way, direction;
  double radius, strength, falloff;

  VoxelDab(const SparseVolume& volume, const ClayDab& dab)
      : action(dab.action),
        centre((dab.centre - volume.origin()) / volume.voxel()),
        way(dab.way / volume.voxel()),
        direction(dab.direction),
        radius(dab.radius / volume.voxel()),
        strength(std::clamp(dab.strength, -1.0, 1.0)),
        falloff(std::clamp(dab.falloff, 0.0, 1.0)) {
    if (action == ClayAction::Move && way.norm() > kLargestShift * radius) way *= kLargestShift * radius / way.norm();
  }

  bool isShape() const { return action == ClayAction::Add || action == ClayAction::Carve; }

  // Of the ball swept along its way: how deep a place is in it.
  double inside(const Vec3& p) const {
    const double length = way.squaredNorm();
    const double share = length > 0.0 ? std::clamp((centre - p).dot(way) / length, 0.0, 1.0) : 0.0;
    return radius - (p - centre + share * way).norm();
  }

  // How much a place is affected; 0 outside the radius.
  double weight(const Vec3& p) const {
    const double share = (p - centre).squaredNorm() / (radius * radius);
    if (share >= 1.0) return 0.0;
    return 1.0 - falloff + falloff * (1.0 - share) * (1.0 - share);
  }

  // Where what comes to a place was before, in voxels from it, at full weight.
  Vec3 source(const Vec3& p) const {
    const Vec3 from = p - centre;
    if (action == ClayAction::Move) return -way;
    if (action == ClayAction::Attract) return kLargestShift * from;
    return kLargestShift * (from - direction.dot(from) * direction);
  }
  // The longest of those.
  double longestShift() const {
    if (action == ClayAction::Move) return std::abs(strength) * way.norm();
    const bool isShift = action == ClayAction::Attract || action == ClayAction::Pinch;
    return isShift ? std::abs(strength) * kLargestShift * radius : 1.0;
  }
};

bool isSound(const ClayDab& dab, const SparseVolume& volume) {
  const double limit = SparseVolume::kMostVoxels * volume.voxel();
  return dab.centre.allFinite() && dab.way.allFinite() && dab.direction.allFinite() && std::isfinite(dab.strength) &&
         std::isfinite(dab.falloff) && dab.way.norm() <= ClayDab::kMostRadii * dab.radius && dab.radius > 0.0 &&
         dab.radius <= ClayDab::kMostVoxels * volume.voxel() &&
         (dab.centre - volume.origin()).cwiseAbs().maxCoeff() < limit;
}

VoxelIndex firstOf(const VoxelIndex& block) {
  return VolumeBlock::kSize * block;
}

constexpr double kHalfDiagonal = 6.1;  // voxels, from the middle of a block to its farthest samples

Vec3 middleOf(const VoxelIndex& block) {
  return firstOf(block).cast<double>() + Vec3::Constant(3.5);
}

// The blocks that match within a box around two places, in voxels.
template <class Matches>
std::vector<VoxelIndex> blocksAround(const Vec3& a, const Vec3& b, double reach, Matches matches) {
  const VoxelIndex low = SparseVolume::blockOf((a.cwiseMin(b).array() - reach).floor().cast<int>().matrix());
  const VoxelIndex high = SparseVolume::blockOf((a.cwiseMax(b).array() + reach).ceil().cast<int>().matrix());
  std::vector<VoxelIndex> blocks;
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x)
        if (matches(VoxelIndex(x, y, z))) blocks.emplace_back(x, y, z);
  return blocks;
}

// Replaces the content of the blocks by what make(block) gives. Returns those that are others now.
template <class Make>
std::vector<VoxelIndex> replace(SparseVolume& volume, const std::vector<VoxelIndex>& blocks, Make make) {
  std::vector<SparseVolume::Content> made(blocks.size());
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) { made[i] = make(blocks[i]); });
  std::vector<VoxelIndex> changed;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const SparseVolume::View before = volume.view(blocks[i]);
    const bool isSame = before.block && made[i].block
                            ? before.block->depths == made[i].block->depths
                            : !before.block && !made[i].block && before.isFull == made[i].isFull;
    if (isSame) continue;
    volume.setContent(blocks[i], std::move(made[i]));
    changed.push_back(blocks[i]);
  }
  return changed;
}

// Unites with a swept ball, or subtracts it. Blocks far inside of it become full or empty at once.
std::vector<VoxelIndex> applyBall(SparseVolume& volume, const VoxelDab& dab) {
  const bool isAdding = dab.action == ClayAction::Add;
  const auto blocks =
      blocksAround(dab.centre, dab.centre - dab.way, dab.radius + kDepths, [&](const VoxelIndex& block) {
        const SparseVolume::View view = volume.view(block);
        return (view.block || view.isFull != isAdding) && dab.inside(middleOf(block)) > -kDepths - kHalfDiagonal;
      });
  std::vector<VoxelIndex> changed = replace(volume, blocks, [&](const VoxelIndex& block) -> SparseVolume::Content {
    const VoxelIndex first = firstOf(block);
    if (dab.inside(middleOf(block)) > kDepths + kHalfDiagonal) return {nullptr, isAdding};
    std::shared_ptr<VolumeBlock> samples = samplesOf(volume.content(block));
    for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
      const Vec3 p = (first + VoxelIndex(i & 7, i >> 3 & 7, i >> 6)).cast<double>();
      const double inside = dab.inside(p);
      std::int16_t& sample = samples->depths[static_cast<std::size_t>(i)];
      sample = isAdding ? std::max(sample, depthSample(inside)) : std::min(sample, depthSample(-inside));
    }
    return contentOf(std::move(samples));
  });
  // What was near a surface that has gone.
  const SparseVolume result = volume;
  const std::vector<VoxelIndex> gone = replace(volume, blocks, [&](const VoxelIndex& block) -> SparseVolume::Content {
    const SparseVolume::Content content = result.content(block);
    if (!content.block || !isFarFromSurface(result, block)) return content;
    return {nullptr, content.block->depths.front() > 0};
  });
  const auto isLess = [](const VoxelIndex& a, const VoxelIndex& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  changed.insert(changed.end(), gone.begin(), gone.end());
  std::sort(changed.begin(), changed.end(), isLess);
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  return changed;
}

// The plane of the surface within the radius: through the mean of its points there, across their mean normal.
struct SurfacePlane {
  Vec3 point = Vec3::Zero(), inwards = Vec3::Zero();
  bool isKnown = false;

  double depth(const Vec3& p) const { return inwards.dot(p - point); }
};

SurfacePlane planeOf(const SparseVolume& volume, const VoxelDab& dab, const std::vector<VoxelIndex>& blocks) {
  SurfacePlane plane;
  double weights = 0.0;
  const VolumeReader reader(volume);
  for (const VoxelIndex& block : blocks) {
    const SparseVolume::View view = volume.view(block);
    for (int i = 0; view.block && i < static_cast<int>(VolumeBlock::kCount); ++i) {
      const double depth = view.block->depths[static_cast<std::size_t>(i)] / VolumeBlock::kUnit;
      if (std::abs(depth) > 1.0) continue;
      const VoxelIndex at = firstOf(block) + VoxelIndex(i & 7, i >> 3 & 7, i >> 6);
      const double share = (at.cast<double>() - dab.centre).squaredNorm() / (dab.radius * dab.radius);
      if (share >= 1.0) continue;
      Vec3 slope;
      for (int k = 0; k < 3; ++k)
        slope[k] = (reader.sample(at + VoxelIndex::Unit(k)) - reader.sample(at - VoxelIndex::Unit(k))) /
                   (2.0 * VolumeBlock::kUnit);
      const double weight = (1.0 - share) * (1.0 - share);
      weights += weight;
      plane.inwards += weight * slope;
      plane.point += weight * (at.cast<double>() - depth * slope);
    }
  }
  if (!(weights > 0.0) || !(plane.inwards.norm() > 0.0)) return plane;
  plane.point /= weights;
  plane.inwards.normalize();
  plane.isKnown = true;
  return plane;
}

// Changes depths near the surface, and then makes them distances again.
class Reshaping {
 public:
  Reshaping(const SparseVolume& volume, const VoxelDab& dab) : m_volume(volume), m_dab(dab) {
    const int away = 1 + static_cast<int>(dab.longestShift()) / VolumeBlock::kSize;
    m_blocks = blocksAround(dab.centre, dab.centre, dab.radius + kDepths, [&](const VoxelIndex& block) {
      return (middleOf(block) - dab.centre).norm() < dab.radius + kDepths + kHalfDiagonal && isSurfaceNear(block, away);
    });
    if (dab.action == ClayAction::Flatten) m_plane = planeOf(volume, dab, m_blocks);
  }

  std::vector<VoxelIndex> apply(SparseVolume& volume) const {
    SparseVolume raw = m_volume;
    replace(raw, m_blocks, [&](const VoxelIndex& block) { return changed(block); });
    return replace(volume, m_blocks, [&](const VoxelIndex& block) {
      DepthWindow window(raw, block);
      window.redistance();
      const double reach = m_dab.radius + kDepths;
      return window.content(volume.content(block), [&](int x, int y, int z) {
        const Vec3 p = (firstOf(block) + VoxelIndex(x, y, z)).cast<double>();
        return (p - m_dab.centre).squaredNorm() > reach * reach;
      });
    });
  }

 private:
  // Whether a surface is in the block or in those around it, so many blocks away.
  bool isSurfaceNear(const VoxelIndex& block, int away) const {
    const SparseVolume::View here = m_volume.view(block);
    if (here.block) return true;
    for (int z = -away; z <= away; ++z)
      for (int y = -away; y <= away; ++y)
        for (int x = -away; x <= away; ++x) {
          const SparseVolume::View view = m_volume.view(block + VoxelIndex(x, y, z));
          if (view.block || view.isFull != here.isFull) return true;
        }
    return false;
  }

  SparseVolume::Content changed(const VoxelIndex& block) const {
    const SparseVolume::Content old = m_volume.content(block);
    if ((middleOf(block) - m_dab.centre).norm() > m_dab.radius + kHalfDiagonal) return old;
    const std::shared_ptr<VolumeBlock> samples = samplesOf(old);
    const VolumeReader reader(m_volume);
    std::optional<DepthWindow> means;
    if (m_dab.action == ClayAction::Smooth) {
      means.emplace(m_volume, block);
      means->average(smoothingReach());
    }
    for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
      const VoxelIndex in(i & 7, i >> 3 & 7, i >> 6);
      const Vec3 p = (firstOf(block) + in).cast<double>();
      const double strength = m_dab.strength * m_dab.weight(p);
      if (strength == 0.0) continue;
      std::int16_t& sample = samples->depths[static_cast<std::size_t>(i)];
      const double before = sample / VolumeBlock::kUnit;
      double depth = before;
      if (means) {
        depth += std::abs(strength) * (static_cast<double>(means->at(in.x(), in.y(), in.z())) - before);
      } else if (m_dab.action == ClayAction::Inflate) {
        depth += kInflation * strength;
      } else if (m_dab.action == ClayAction::Flatten) {
        if (m_plane.isKnown) depth += std::abs(strength) * (std::clamp(m_plane.depth(p), -kDepths, kDepths) - before);
      } else {
        const Vec3 from = m_volume.origin() + m_volume.voxel() * (p + strength * m_dab.source(p));
        depth = reader.depthAt(from).depth / m_volume.voxel();
      }
      sample = depthSample(depth);
    }
    return contentOf(samples);
  }

  // A tool smooths what is small beside it.
  int smoothingReach() const { return std::clamp(static_cast<int>(m_dab.radius / 8.0), 1, DepthWindow::kMargin - 1); }

  const SparseVolume& m_volume;  // before the dab
  const VoxelDab& m_dab;
  std::vector<VoxelIndex> m_blocks;
  SurfacePlane m_plane;
};

}  // namespace

std::vector<VoxelIndex> applyDab(SparseVolume& volume, const ClayDab& dab) {
  if (!isSound(dab, volume)) return {};
  const VoxelDab inVoxels(volume, dab);
  if (inVoxels.isShape()) return applyBall(volume, inVoxels);
  const SparseVolume before = volume;
  return Reshaping(before, inVoxels).apply(volume);
}

ClayDab mirrored(const ClayDab& dab, const Vec3& point, int axis) {
  ClayDab other = dab;
  other.centre[axis] = 2.0 * point[axis] - dab.centre[axis];
  other.way[axis] = -dab.way[axis];
  other.direction[axis] = -dab.direction[axis];
  return other;
}

}  // namespace handwheel
