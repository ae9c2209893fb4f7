// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillCut.h"

#include "volume/drilling/DrillHead.h"
#include "volume/repair/DepthWindow.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr double kNear = 6.1;            // voxels, from the middle of a block to its farthest samples
constexpr double kMostRadius = 500.0;    // voxels
constexpr std::size_t kFewBlocks = 200;  // to wake other threads for would take longer
constexpr double kWideHead = 256.0;      // voxels, of a head that is looked for where there is material alone
constexpr double kTwistStep =
    0.25;  // voxels, distance between the sampled positions of a head that is not swept exactly
constexpr double kSampleRounding = 0.4999;  // a lower sample is further away than what is rounded to this one

// The share of a voxel that is below the surface.
double share(std::int16_t depth) {
  return std::clamp(0.5 + depth / VolumeBlock::kUnit, 0.0, 1.0);
}

using Row = Eigen::Array<double, VolumeBlock::kSize, 1>;

// The new content of a block, and the material removed from it.
struct BlockCut {
  SparseVolume::Content content;
  bool isChanged = false;
  double removed = 0.0;      // voxels
  Vec3 push = Vec3::Zero();  // sum over them of directions from the centre
};

// Lengths of a tool in voxels.
DrillBit inVoxels(DrillBit tool, double voxel) {
  tool.diameter /= voxel;
  tool.length /= voxel;
  tool.width /= voxel;
  return tool;
}

// A move in voxels.
class HeadSweep {
 public:
  HeadSweep(const SparseVolume& volume, const DrillBit& tool, const DrillMove& move)
      : m_from((move.from - volume.origin()) / volume.voxel()),
        m_to((move.to - volume.origin()) / volume.voxel()),
        m_axis(move.axis),
        m_tool(inVoxels(tool, volume.voxel())),
        m_head(m_tool),
        m_along(std::abs((m_to - m_from).dot(m_axis))),
        m_across((m_to - m_from - (m_to - m_from).dot(m_axis) * m_axis).norm()),
        m_erosion(move.erosion * (m_to - m_from).norm()),
        m_positions(m_head.isBall() ? 1 : 1 + static_cast<int>((m_to - m_from).norm() / kTwistStep)) {}

  const Vec3& centre() const { return m_to; }
  double inside(const Vec3& p) const {
    if (m_head.isBall()) {
      const Vec3 displacement = m_to - m_from;
      const double length = displacement.squaredNorm(),
                   at = length > 0.0 ? (p - m_from).dot(displacement) / length : 1.0;
      return m_head.inside(p - m_from - std::clamp(at, 0.0, 1.0) * displacement, m_axis);
    }
    double most = -1e9;
    for (int i = 0; i <= m_positions; ++i)
      most = std::max(most, m_head.inside(p - m_from - static_cast<double>(i) / m_positions * (m_to - m_from), m_axis));
    return most;
  }
  // Returns upper bounds of inside() for a row of a block, from this point along x.
  Row boundOfRow(const Vec3& first) const {
    return m_head.row<VolumeBlock::kSize>(first - m_from, m_axis, m_across, m_along);
  }
  // Returns a bounding box of the sweep.
  Box box() const {
    Box box(m_from.cwiseMin(m_to), m_from.cwiseMax(m_to));
    const double out = std::max(m_tool.radius(), m_tool.reach()) + DepthWindow::kMargin;
    const Vec3 shank = m_tool.shape == DrillShape::Twist ? Vec3(m_tool.length * m_axis) : Vec3(Vec3::Zero());
    Box all(box.min() - Vec3::Constant(out), box.max() + Vec3::Constant(out));
    all.extend(all.min() + shank.cwiseMin(0.0));
    all.extend(all.max() + shank.cwiseMax(0.0));
    return all;
  }
  double erosion() const { return m_erosion; }

 private:
  Vec3 m_from, m_to, m_axis;
  DrillBit m_tool;
  DrillHead m_head;
  double m_along, m_across;  // extent of the move, voxels
  double m_erosion;          // voxels
  int m_positions;
};

// Returns the cubes of `edge` voxels within a box, in voxels, with blocks near the head that matter.
template <class Matters>
std::vector<VoxelIndex> cubesNear(const HeadSweep& head, const Box& box, int edge, Matters matters) {
  std::vector<VoxelIndex> cubes;
  if (box.isEmpty()) return cubes;
  // From the middle of a cube to that of a block in it.
  const double inCube = 0.5 * std::sqrt(3.0) * (edge - VolumeBlock::kSize);
  const VoxelIndex low = (box.min().array().floor() / edge).floor().matrix().cast<int>();
  const VoxelIndex high = (box.max().array().ceil() / edge).floor().matrix().cast<int>();
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x) {
        const VoxelIndex cube(x, y, z);
        const Vec3 middle = edge * cube.cast<double>() + Vec3::Constant(0.5 * (edge - 1));
        if (matters(cube) && head.inside(middle) > -DepthWindow::kMargin - kNear - inCube) cubes.push_back(cube);
      }
  return cubes;
}

// In a cycle of a simulation few of its samples change: a bound for each row leaves out the others.
BlockCut cutBlock(const SparseVolume& volume, const VoxelIndex& block, const HeadSweep& head) {
  BlockCut cut;
  const SparseVolume::Content old = volume.content(block);
  std::shared_ptr<VolumeBlock> samples;
  Row bound;
  for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
    const Vec3 p = (VolumeBlock::kSize * block + VoxelIndex(i & 7, i >> 3 & 7, i >> 6)).cast<double>();
    if ((i & 7) == 0) bound = -VolumeBlock::kUnit * head.boundOfRow(p);
    const std::int16_t before = old.block ? old.block->depths[static_cast<std::size_t>(i)] : VolumeBlock::kFull;
    if (bound[i & 7] > before - kSampleRounding) continue;
    const double inside = head.inside(p);
    if (!(-inside * VolumeBlock::kUnit < before)) continue;
    const std::int16_t after = depthSample(std::max(-inside, before / VolumeBlock::kUnit - head.erosion()));
    if (after >= before) continue;
    if (!samples) samples = samplesOf(old);
    samples->depths[static_cast<std::size_t>(i)] = after;
    const double taken = share(before) - share(after), distance = (p - head.centre()).norm();
    cut.removed += taken;
    if (distance > 0.0) cut.push += taken / distance * (p - head.centre());
  }
  cut.isChanged = samples != nullptr;
  if (samples) cut.content = contentOf(std::move(samples));
  return cut;
}

bool isSound(const SparseVolume& volume, const DrillBit& tool, const DrillMove& move) {
  const double limit = SparseVolume::kMostVoxels * volume.voxel();
  const auto isInRange = [&](const Vec3& p) {
    return p.allFinite() && (p - volume.origin()).cwiseAbs().maxCoeff() < limit;
  };
  return isInRange(move.from) && isInRange(move.to) && move.axis.allFinite() && move.erosion > 0.0 &&
         tool.radius() <= kMostRadius * volume.voxel() && tool.diameter > 0.0 &&
         (move.to - move.from).norm() <= kMostDrillTravel * tool.diameter;
}

}  // namespace

DrillCut drill(SparseVolume& volume, const DrillBit& tool, const DrillMove& move) {
  DrillCut done;
  if (!isSound(volume, tool, move)) return done;
  const HeadSweep head(volume, tool, move);
  Box box = head.box();
  if (!box.min().allFinite() || !box.max().allFinite()) return done;
  if (box.sizes().maxCoeff() > kWideHead) box = box.intersection(volume.extent());
  const std::vector<VoxelIndex> blocks = cubesNear(head, box, VolumeBlock::kSize, [&](const VoxelIndex& block) {
    const SparseVolume::View view = volume.view(block);
    return view.block || view.isFull;
  });
  std::vector<BlockCut> cuts(blocks.size());
  const auto cutOne = [&](std::size_t i) { cuts[i] = cutBlock(volume, blocks[i], head); };
  if (blocks.size() < kFewBlocks) {
    for (std::size_t i = 0; i < blocks.size(); ++i) cutOne(i);
  } else {
    tbb::parallel_for(std::size_t{0}, blocks.size(), cutOne);
  }
  Vec3 push = Vec3::Zero();
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (!cuts[i].isChanged) continue;
    done.removed += cuts[i].removed;
    push += cuts[i].push;
    volume.setContent(blocks[i], std::move(cuts[i].content));
    done.changedBlocks.push_back(blocks[i]);
  }
  done.removed *= std::pow(volume.voxel(), 3);
  if (push.norm() > 0.0) done.push = push.normalized();
  return done;
}

std::vector<VoxelIndex> cubesOfMove(const SparseVolume& grid, const Box& within, int edge, const DrillBit& tool,
                                    const DrillMove& move) {
  if (!isSound(grid, tool, move)) return {};
  const HeadSweep head(grid, tool, move);
  const Box box = head.box();
  if (!box.min().allFinite() || !box.max().allFinite()) return {};
  return cubesNear(head, box.intersection(within), edge, [](const VoxelIndex&) { return true; });
}

double countedMaterial(const SparseVolume& volume) {
  double sum = 0.0;
  volume.forEach([&](const VoxelIndex&, const SparseVolume::Content& content) {
    if (!content.block) sum += static_cast<double>(VolumeBlock::kCount);
    if (content.block)
      for (const std::int16_t depth : content.block->depths) sum += share(depth);
  });
  return sum * std::pow(volume.voxel(), 3);
}

}  // namespace handwheel
