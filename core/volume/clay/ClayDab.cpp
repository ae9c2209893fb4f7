// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/clay/ClayDab.h"

#include "volume/VolumeFilters.h"
#include "volume/VolumeSampler.h"
#include "volume/clay/ClayMask.h"
#include "volume/clay/ClayStamp.h"
#include "volume/clay/DabBlocks.h"
#include "volume/repair/DepthWindow.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr double kDepths = DepthWindow::kMargin;  // voxels from the surface that depths reach
constexpr double kInflation = 0.5;                // voxels that a dab of full strength moves the surface by
constexpr double kLargestShift = 0.25;            // largest displacement of material in a dab, as a share of the radius
constexpr double kSmudging = 0.3;                 // smoothing by Smudge, as a share of that by Smooth

bool isShapeAction(ClayAction action) {
  return action == ClayAction::Add || action == ClayAction::Carve;
}

// A dab in voxels.
struct VoxelDab : SweptBall {
  ClayAction action;
  Vec3 direction, right, up;
  double strength, falloff;
  const ClayStamp* stamp;  // stamp of Add and Carve; null: a ball
  const ClayMask* mask;    // null: all is free

  VoxelDab(const SparseVolume& volume, const ClayDab& dab, const ClayMask* protecting)
      : SweptBall(volume, dab),
        action(dab.action),
        direction(dab.direction),
        right(dab.right),
        up(dab.up),
        strength(std::clamp(dab.strength, -1.0, 1.0)),
        falloff(std::clamp(dab.falloff, 0.0, 1.0)),
        stamp(isShapeAction(dab.action) ? dab.stamp.get() : nullptr),
        mask(protecting) {
    // The height is that of a stamp to either side.
    if (stamp) strength = std::copysign(strength, dab.action == ClayAction::Add ? 1.0 : -1.0);
    if (action == ClayAction::Smudge) {
      strength = std::abs(strength);
      displacement -= displacement.dot(direction) * direction;
    }
    if (isDisplacing() && displacement.norm() > kLargestShift * radius)
      displacement *= kLargestShift * radius / displacement.norm();
  }

  bool isBall() const { return isShapeAction(action) && !stamp; }
  bool isDisplacing() const { return action == ClayAction::Move || action == ClayAction::Smudge; }
  // Returns the largest distance from the centre with an effect: a stamp acts in a cylinder.
  double reach() const { return stamp ? std::sqrt(2.0) * radius : radius; }

  // Returns the weight of the dab at a point; 0 outside the radius.
  double weight(const Vec3& p) const {
    if (stamp) return stampAt(p);
    const double share = (p - centre).squaredNorm() / (radius * radius);
    if (share >= 1.0) return 0.0;
    return 1.0 - falloff + falloff * (1.0 - share) * (1.0 - share);
  }

  // Returns the source of the material that moves to a point, in voxels relative to it, at full weight.
  Vec3 source(const Vec3& p) const {
    const Vec3 from = p - centre;
    if (stamp) return -ClayDab::kStampHeight * radius * direction;
    if (isDisplacing()) return -displacement;
    if (action == ClayAction::Attract) return kLargestShift * from;
    return kLargestShift * (from - direction.dot(from) * direction);
  }
  // The longest of those.
  double longestShift() const {
    if (isDisplacing()) return std::abs(strength) * displacement.norm();
    if (stamp) return std::abs(strength) * ClayDab::kStampHeight * radius;
    const bool isShift = action == ClayAction::Attract || action == ClayAction::Pinch;
    return isShift ? std::abs(strength) * kLargestShift * radius : 1.0;
  }

  // Returns the height of the stamp over a point. Along the direction it fades out within the radius, slowly enough to
  // avoid folds, so that the far side of thin walls is not moved.
  double stampAt(const Vec3& p) const {
    const Vec3 from = p - centre;
    const double along = 2.0 - 2.0 * std::abs(direction.dot(from)) / radius;
    if (!(along > 0.0)) return 0.0;
    const double scale = std::sqrt(2.0) / radius, share = std::min(along, 1.0);
    // The mean over a voxel, as its edges may be steep: walls of steps would be left.
    const double x = scale * right.dot(from), y = scale * up.dot(from), half = 0.5 * scale;
    const double height = stamp->at(x - half, y - half) + stamp->at(x + half, y - half) +
                          stamp->at(x - half, y + half) + stamp->at(x + half, y + half);
    return 0.25 * height * share * share * (3.0 - 2.0 * share);
  }

  bool isFree(const VoxelIndex& block) const { return !mask || mask->block(block).isFree(); }
  bool isProtected(const VoxelIndex& block) const {
    return mask && mask->block(block).isUniform() && !mask->block(block).isFree();
  }
  // Fully protected samples are preserved exactly.
  bool isProtected(const VoxelIndex& block, std::size_t sample) const {
    return mask && mask->block(block).at(sample) >= 1.0;
  }
};

// Makes depths distances again beside the edge of the mask, where the surface does not go by the ball alone.
void correctAtMask(SparseVolume& volume, const VoxelDab& dab, const std::vector<VoxelIndex>& changed) {
  std::vector<VoxelIndex> blocks;
  for (const VoxelIndex& block : changed) {
    bool isBeside = false;
    for (int k = 0; k < 27 && !isBeside; ++k)
      isBeside = !dab.mask->block(block + VoxelIndex(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1)).isUniform();
    if (isBeside) blocks.push_back(block);
  }
  const SparseVolume raw = volume;
  replace(volume, blocks, [&](const VoxelIndex& block) {
    DepthWindow window(raw, block);
    window.redistance();
    return window.content(raw.content(block),
                          [&](int x, int y, int z) { return dab.isProtected(block, VolumeBlock::at(x, y, z)); });
  });
}

// Unites with a swept ball, or subtracts it. Blocks far inside of it become full or empty at once. Where a share of it
// is protected, the ball has the rest of its radius.
std::vector<VoxelIndex> applyBall(SparseVolume& volume, const VoxelDab& dab) {
  const bool isAdding = dab.action == ClayAction::Add;
  const auto blocks =
      blocksAround(dab.centre, dab.centre - dab.displacement, dab.radius + kDepths, [&](const VoxelIndex& block) {
        const SparseVolume::View view = volume.view(block);
        return (view.block || view.isFull != isAdding) && dab.inside(middleOf(block)) > -kDepths - kHalfDiagonal;
      });
  std::vector<VoxelIndex> changed = replace(volume, blocks, [&](const VoxelIndex& block) -> SparseVolume::Content {
    const VoxelIndex first = firstOf(block);
    if (dab.isProtected(block)) return volume.content(block);
    const bool isFree = dab.isFree(block);
    if (isFree && dab.inside(middleOf(block)) > kDepths + kHalfDiagonal) return {nullptr, isAdding};
    std::shared_ptr<VolumeBlock> samples = samplesOf(volume.content(block));
    for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
      const Vec3 p = (first + VoxelIndex(i & 7, i >> 3 & 7, i >> 6)).cast<double>();
      const double share = isFree ? 0.0 : dab.mask->block(block).at(static_cast<std::size_t>(i));
      const double inside = dab.inside(p) - share * (dab.radius + kDepths);
      std::int16_t& sample = samples->depths[static_cast<std::size_t>(i)];
      sample = isAdding ? std::max(sample, depthSample(inside)) : std::min(sample, depthSample(-inside));
    }
    return contentOf(std::move(samples));
  });
  if (dab.mask) correctAtMask(volume, dab, changed);
  // Blocks near a surface that has vanished.
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
  const VolumeSampler sampler(volume);
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
        slope[k] = (sampler.sample(at + VoxelIndex::Unit(k)) - sampler.sample(at - VoxelIndex::Unit(k))) /
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
    m_blocks = blocksAround(dab.centre, dab.centre, dab.reach() + kDepths, [&](const VoxelIndex& block) {
      return (middleOf(block) - dab.centre).norm() < dab.reach() + kDepths + kHalfDiagonal &&
             isSurfaceNear(block, away);
    });
    if (dab.action == ClayAction::Flatten) m_plane = planeOf(volume, dab, m_blocks);
  }

  std::vector<VoxelIndex> apply(SparseVolume& volume) const {
    SparseVolume raw = m_volume;
    replace(raw, m_blocks, [&](const VoxelIndex& block) { return changed(block); });
    return replace(volume, m_blocks, [&](const VoxelIndex& block) {
      DepthWindow window(raw, block);
      window.redistance();
      const double reach = m_dab.reach() + kDepths;
      const bool isWithin = !m_dab.mask && (middleOf(block) - m_dab.centre).norm() + kHalfDiagonal < reach;
      return window.content(volume.content(block), [&](int x, int y, int z) {
        if (isWithin) return false;
        const Vec3 p = (firstOf(block) + VoxelIndex(x, y, z)).cast<double>();
        return (p - m_dab.centre).squaredNorm() > reach * reach || m_dab.isProtected(block, VolumeBlock::at(x, y, z));
      });
    });
  }

 private:
  // Returns true if a surface is in the block or at most `away` blocks from it.
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
    if ((middleOf(block) - m_dab.centre).norm() > m_dab.reach() + kHalfDiagonal) return old;
    if (m_dab.isProtected(block)) return old;
    const bool isFree = m_dab.isFree(block);
    const std::shared_ptr<VolumeBlock> samples = samplesOf(old);
    const VolumeSampler sampler(m_volume);
    std::optional<DepthWindow> means;
    if (m_dab.action == ClayAction::Smooth || m_dab.action == ClayAction::Smudge) {
      means.emplace(m_volume, block);
      means->average(smoothingReach());
    }
    for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
      const VoxelIndex in(i & 7, i >> 3 & 7, i >> 6);
      const Vec3 p = (firstOf(block) + in).cast<double>();
      const double free = isFree ? 1.0 : 1.0 - m_dab.mask->block(block).at(static_cast<std::size_t>(i));
      const double strength = m_dab.strength * m_dab.weight(p) * free;
      if (strength == 0.0) continue;
      std::int16_t& sample = samples->depths[static_cast<std::size_t>(i)];
      const double before = sample / VolumeBlock::kUnit;
      double depth = before;
      const double smoothing = means ? static_cast<double>(means->at(in.x(), in.y(), in.z())) - before : 0.0;
      if (m_dab.action == ClayAction::Smooth) {
        depth += std::abs(strength) * smoothing;
      } else if (m_dab.action == ClayAction::Inflate) {
        depth += kInflation * strength;
      } else if (m_dab.action == ClayAction::Flatten) {
        if (m_plane.isKnown) depth += std::abs(strength) * (std::clamp(m_plane.depth(p), -kDepths, kDepths) - before);
      } else {
        depth = sampler.depthInVoxels(p + strength * m_dab.source(p)) + kSmudging * strength * smoothing;
      }
      sample = depthSample(depth);
    }
    return contentOf(samples);
  }

  // A tool smooths details that are small compared with it.
  int smoothingReach() const { return std::clamp(static_cast<int>(m_dab.radius / 8.0), 1, DepthWindow::kMargin - 1); }

  const SparseVolume& m_volume;  // before the dab
  const VoxelDab& m_dab;
  std::vector<VoxelIndex> m_blocks;
  SurfacePlane m_plane;
};

}  // namespace

bool isSoundDab(const ClayDab& dab, const SparseVolume& grid) {
  const double limit = SparseVolume::kMostVoxels * grid.voxel();
  return dab.centre.allFinite() && dab.displacement.allFinite() && dab.direction.allFinite() && dab.right.allFinite() &&
         dab.up.allFinite() && std::isfinite(dab.strength) && std::isfinite(dab.falloff) &&
         dab.displacement.norm() <= ClayDab::kMostRadii * dab.radius && dab.radius > 0.0 &&
         dab.radius <= ClayDab::kMostVoxels * grid.voxel() &&
         (dab.centre - grid.origin()).cwiseAbs().maxCoeff() < limit;
}

std::vector<VoxelIndex> applyDab(SparseVolume& volume, const ClayDab& dab, const ClayMask* mask) {
  if (dab.action == ClayAction::Mask || !isSoundDab(dab, volume)) return {};
  const VoxelDab inVoxels(volume, dab, mask && mask->fits(volume) && !mask->isFree() ? mask : nullptr);
  if (inVoxels.isBall()) return applyBall(volume, inVoxels);
  const SparseVolume before = volume;
  return Reshaping(before, inVoxels).apply(volume);
}

ClayDab mirrored(const ClayDab& dab, const Vec3& point, int axis) {
  ClayDab other = dab;
  other.centre[axis] = 2.0 * point[axis] - dab.centre[axis];
  other.displacement[axis] = -dab.displacement[axis];
  for (Vec3 ClayDab::*vector : {&ClayDab::direction, &ClayDab::right, &ClayDab::up})
    (other.*vector)[axis] = -(dab.*vector)[axis];
  return other;
}

}  // namespace handwheel
