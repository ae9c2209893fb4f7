// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/WindingNumberFill.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr int kBlock = VolumeBlock::kSize;
constexpr double kLook = 0.4;       // least turns of the cones for evaluating a block; at one half the side may differ
constexpr double kBandReach = 8.0;  // voxels: half the diagonal between evaluated points, plus the band

// The turns of the cones grow by 1 across them, which is no slope.
double withoutJump(double difference) {
  return difference - std::round(difference);
}

// The turns at 27 points of a block: its first, middle and last voxels.
class CoarseTurns {
 public:
  CoarseTurns(const SolidAngleTree& cones, const VoxelIndex& block) {
    constexpr std::array<double, 3> kOffsets{0.0, 3.5, 7.0};
    for (std::size_t i = 0; i < 27; ++i)
      m_turns[i] =
          cones.turns((kBlock * block).cast<double>() + Vec3(kOffsets[i % 3], kOffsets[i / 3 % 3], kOffsets[i / 9]));
  }

  double most() const {
    double most = 0.0;
    for (const double turns : m_turns) most = std::max(most, std::abs(turns));
    return most;
  }
  // Returns true if a membrane may be within the band of the block's voxels, judging by the slope between the points.
  bool isHalfNear() const {
    double nearest = 1.0, slope = 0.0;
    for (std::size_t i = 0; i < 27; ++i) {
      nearest = std::min(nearest, 0.5 - std::abs(withoutJump(m_turns[i])));
      if (i % 3 < 2) slope = std::max(slope, std::abs(withoutJump(m_turns[i + 1] - m_turns[i])));
      if (i / 3 % 3 < 2) slope = std::max(slope, std::abs(withoutJump(m_turns[i + 3] - m_turns[i])));
      if (i / 9 < 2) slope = std::max(slope, std::abs(withoutJump(m_turns[i + 9] - m_turns[i])));
    }
    return nearest < kBandReach * std::sqrt(3.0) * slope / 3.5;
  }

 private:
  std::array<double, 27> m_turns;
};

// Calls visit(block) for those that a triangle may pass through.
template <class Visit>
void forBlocksOf(const TriangleSoup& soup, const Triangle& t, Visit visit) {
  const Vec3 &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
  const Vec3 cross = (b - a).cross(c - a);
  const double length = cross.norm();
  const Vec3 normal = length > 0.0 ? Vec3(cross / length) : Vec3(Vec3::Zero());
  const VoxelIndex low = (a.cwiseMin(b).cwiseMin(c) / kBlock).array().floor().cast<int>();
  const VoxelIndex high = (a.cwiseMax(b).cwiseMax(c) / kBlock).array().floor().cast<int>();
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x) {
        const Vec3 middle = kBlock * Vec3(x + 0.5, y + 0.5, z + 0.5);
        if (std::abs(normal.dot(middle - a)) <= 0.5 * kBlock * std::sqrt(3.0)) visit(VoxelIndex(x, y, z));
      }
}

}  // namespace

std::uint64_t WindingNumberFill::keyOf(const VoxelIndex& block) {
  std::uint64_t key = 0;
  for (int k = 0; k < 3; ++k) key = key << 21 | (static_cast<std::uint32_t>(block[k]) & 0x1fffff);
  return key;
}

// The turns of cones are harmonic beside them, so blocks with large turns are connected with those of the cones.
WindingNumberFill::WindingNumberFill(const TriangleSoup& closed, std::span<const std::uint32_t> cones,
                                     const Progress& progress)
    : m_cones(closed, cones) {
  std::vector<VoxelIndex> wave;
  const auto add = [&](const VoxelIndex& block) {
    if (m_near.emplace(keyOf(block), false).second) wave.push_back(block);
  };
  for (const std::uint32_t i : cones) forBlocksOf(closed, closed.triangles[i], add);
  for (const VoxelIndex& block : wave) m_coneBlocks.insert(keyOf(block));
  // Around the edges of holes, turns change within a voxel, between the evaluated points.
  for (const VoxelIndex& block : std::vector<VoxelIndex>(wave))
    for (int k = 0; k < 27; ++k) add(block + VoxelIndex(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1));
  while (!wave.empty() && !progress.cancelled()) {
    std::vector<std::pair<double, bool>> found(wave.size());
    tbb::parallel_for(std::size_t{0}, wave.size(), [&](std::size_t i) {
      const CoarseTurns turns(m_cones, wave[i]);
      found[i] = {turns.most(), turns.isHalfNear()};
    });
    const std::vector<VoxelIndex> last = std::exchange(wave, {});
    for (std::size_t i = 0; i < last.size(); ++i) {
      m_blocks.push_back(last[i]);
      m_near[keyOf(last[i])] = found[i].second;
      if (found[i].first < kLook) continue;
      for (int k = 0; k < 27; ++k) add(last[i] + VoxelIndex(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1));
    }
  }
}

// Over a flat round hole the turns are (1 - h / √(h² + r²)) / 2 in the middle at the height h: kLook up to a fifth of
// the radius, and less towards the edge: a spindle of a third of r³ above and as much below, in terms of the area.
// Around the cones there is a block more on either side.
double WindingNumberFill::predictedBlocks(const TriangleSoup& closed, std::span<const std::uint32_t> cones) {
  constexpr double kSpindle = 0.115, kAround = 3.0 + 1.5;  // blocks across a cone: its own, and those beside it
  double blocks = 0.0;
  for (std::size_t i = 0; i < cones.size();) {
    const std::uint32_t tip = closed.triangles[cones[i]][2];
    double area = 0.0;  // square blocks
    for (; i < cones.size() && closed.triangles[cones[i]][2] == tip; ++i) {
      const Triangle& t = closed.triangles[cones[i]];
      const Vec3 &a = closed.points[t[0]], &b = closed.points[t[1]], &c = closed.points[t[2]];
      area += 0.5 * (b - a).cross(c - a).norm() / (kBlock * kBlock);
    }
    blocks += kSpindle * area * std::sqrt(area) + kAround * area;
  }
  return blocks;
}

bool WindingNumberFill::isNear(const VoxelIndex& block) const {
  const auto found = m_near.find(keyOf(block));
  return found != m_near.end() && found->second;
}

WindingNumberFill::Samples WindingNumberFill::samples(const VoxelIndex& block, const ScanlineCrossings& rows) const {
  Samples made;
  const VoxelIndex first = kBlock * block;
  constexpr int kSide = kBlock + 2;
  const auto sampleIndex = [](int x, int y, int z) {
    return static_cast<std::size_t>(((z + 1) * kSide + y + 1) * kSide + x + 1);
  };
  const bool isSloped = isNear(block);
  std::array<double, static_cast<std::size_t>(kSide * kSide * kSide)> turns{};
  const int margin = isSloped ? 1 : 0;
  for (int z = -margin; z < kBlock + margin; ++z)
    for (int y = -margin; y < kBlock + margin; ++y)
      for (int x = -margin; x < kBlock + margin; ++x)
        turns[sampleIndex(x, y, z)] = m_cones.turns((first + VoxelIndex(x, y, z)).cast<double>());
  for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
    const VoxelIndex in(i & 7, i >> 3 & 7, i >> 6);
    const std::size_t at = sampleIndex(in.x(), in.y(), in.z());
    const double above = rows.winding(first + in) - turns[at] - 0.5;
    made.isInside[static_cast<std::size_t>(i)] = above > 0.0;
    float& distance = made.distance[static_cast<std::size_t>(i)];
    distance = kNone;
    if (!isSloped) continue;
    constexpr std::array<std::size_t, 3> kSteps{1, kSide, kSide * kSide};
    Vec3 slope;
    for (std::size_t k = 0; k < 3; ++k)
      slope[static_cast<Eigen::Index>(k)] = 0.5 * withoutJump(turns[at + kSteps[k]] - turns[at - kSteps[k]]);
    if (const double steep = slope.norm(); steep > 0.0) distance = static_cast<float>(std::abs(above) / steep);
  }
  return made;
}

}  // namespace handwheel
