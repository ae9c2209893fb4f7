// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/clay/ClayMask.h"

#include "volume/clay/DabBlocks.h"
#include "volume/repair/DepthWindow.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

// Never 0, as no sample of a SparseVolume is.
std::int16_t maskSample(double share) {
  constexpr double kRange = VolumeBlock::kFull - VolumeBlock::kEmpty;
  const auto sample = static_cast<std::int16_t>(std::lround(share * kRange) + VolumeBlock::kEmpty);
  return sample != 0 ? sample : std::int16_t{1};
}

// From 0 to 1 without a kink at either end.
double smoothStep(double t) {
  const double x = std::clamp(t, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

}  // namespace

double ClayMask::shareAt(const Vec3& point) const {
  const Vec3 at = (point - m_values.origin()) / m_values.voxel();
  if (!at.allFinite() || !(at.cwiseAbs().maxCoeff() < SparseVolume::kMostVoxels)) return 0.0;
  const VoxelIndex voxel = at.array().round().cast<int>();
  return block(SparseVolume::blockOf(voxel)).at(VolumeBlock::at(voxel.x() & 7, voxel.y() & 7, voxel.z() & 7));
}

bool ClayMask::isKnownSame(const ClayMask& other, const VoxelIndex& region) const {
  if (m_isInverted != other.m_isInverted) return false;
  for (int k = 0; k < 8; ++k)
    if (!m_values.sharesRegion(other.m_values, region + VoxelIndex(k & 1, k >> 1 & 1, k >> 2))) return false;
  return true;
}

std::vector<VoxelIndex> ClayMask::paint(const ClayDab& dab) {
  if (!isSoundDab(dab, m_values)) return {};
  const SweptBall ball(m_values, dab);
  const double most = std::min(1.0, std::abs(dab.strength));
  const double edge = std::clamp(0.5 * std::clamp(dab.falloff, 0.0, 1.0) * ball.radius, kLeastEdge, kWidestEdge);
  const bool isRaising = (dab.strength > 0.0) != m_isInverted;  // direction of the stored values
  const auto blocks =
      blocksAround(ball.centre, ball.centre - ball.displacement, ball.radius, [&](const VoxelIndex& block) {
        const SparseVolume::View view = m_values.view(block);
        return (view.block || view.isFull != isRaising) && ball.inside(middleOf(block)) > -kHalfDiagonal;
      });
  return replace(m_values, blocks, [&](const VoxelIndex& block) -> SparseVolume::Content {
    if (most == 1.0 && ball.inside(middleOf(block)) > edge + kHalfDiagonal) return {nullptr, isRaising};
    const std::shared_ptr<VolumeBlock> samples = samplesOf(m_values.content(block));
    const VoxelIndex first = firstOf(block);
    for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
      const Vec3 p = (first + VoxelIndex(i & 7, i >> 3 & 7, i >> 6)).cast<double>();
      const double share = most * smoothStep(ball.inside(p) / edge);
      std::int16_t& sample = samples->depths[static_cast<std::size_t>(i)];
      sample = isRaising ? std::max(sample, maskSample(share)) : std::min(sample, maskSample(1.0 - share));
    }
    return contentOf(samples);
  });
}

}  // namespace handwheel
