// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/DepthWindow.h"

#include "volume/repair/Eikonal.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace handwheel {
namespace {

constexpr std::array<int, 3> kAxisSteps{1, DepthWindow::kSide, DepthWindow::kSide* DepthWindow::kSide};
constexpr std::size_t kWindowCount = static_cast<std::size_t>(DepthWindow::kSide) * kAxisSteps[2];
using Depths = std::array<float, kWindowCount>;

// Replaces depths by their means along an axis. These are all but the first and the last ones, more than a block needs,
// in loops of constant length, which compilers vectorise. At the ends of the axis, which do not affect the block, the
// neighbours are those of another row.
template <int kStep>
void averageAlong(Depths& depths, int reach) {
  constexpr std::size_t kFirst = DepthWindow::kMargin * kStep;
  const float share = 1.0f / static_cast<float>(2 * reach + 1);
  Depths sums{};
  for (int k = -reach; k <= reach; ++k) {
    const std::size_t from = kFirst + static_cast<std::size_t>(k * kStep);
    for (std::size_t i = 0; i < kWindowCount - 2 * kFirst; ++i) sums[kFirst + i] += depths[from + i];
  }
  for (std::size_t i = kFirst; i < kWindowCount - kFirst; ++i) depths[i] = share * sums[i];
}

}  // namespace

DepthWindow::DepthWindow(const SparseVolume& volume, const VoxelIndex& block) {
  constexpr int n = VolumeBlock::kSize;
  for (int k = 0; k < 27; ++k) {
    const VoxelIndex step(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1), first = n * step;
    const SparseVolume::View view = volume.view(block + step);
    const auto uniform = static_cast<float>(view.isFull ? kLimit : -kLimit);
    const VoxelIndex low = first.cwiseMax(-kMargin);
    const VoxelIndex high = (first + VoxelIndex::Constant(n)).cwiseMin(n + kMargin);
    for (int z = low.z(); z < high.z(); ++z)
      for (int y = low.y(); y < high.y(); ++y)
        for (int x = low.x(); x < high.x(); ++x)
          m_depths[index(x, y, z)] =
              view.block ? static_cast<float>(view.block->depths[VolumeBlock::at(x & 7, y & 7, z & 7)]) *
                               static_cast<float>(1.0 / VolumeBlock::kUnit)
                         : uniform;
  }
}

void DepthWindow::average(int reach) {
  averageAlong<1>(m_depths, reach);
  averageAlong<kSide>(m_depths, reach);
  averageAlong<kSide * kSide>(m_depths, reach);
}

namespace {

// Fast marching outwards from the voxels beside the surface, layer by layer, within a window without its outermost
// voxels, which only affect depths beyond the stored ones.
class Marching {
 public:
  Marching(const Depths& depths, DepthWindow::Beside beside) : m_depths(depths), m_beside(beside) {
    m_distances.fill(kUnknown);
    constexpr std::size_t n = DepthWindow::kSide, border = n * n + n;
    // Finds the voxels beside the surface, in loops like those of the means: most are not beside it.
    std::array<std::uint8_t, kWindowCount> isInside, isBeside{};
    for (std::size_t i = 0; i < kWindowCount; ++i) isInside[i] = m_depths[i] > 0.0f ? 1 : 0;
    for (std::size_t i = border; i < kWindowCount - border; ++i) {
      const std::uint8_t here = isInside[i];
      isBeside[i] = static_cast<std::uint8_t>((here ^ isInside[i - 1]) | (here ^ isInside[i + 1]) |
                                              (here ^ isInside[i - n]) | (here ^ isInside[i + n]) |
                                              (here ^ isInside[i - n * n]) | (here ^ isInside[i + n * n]));
    }
    m_state.fill(kOutside);
    for (std::size_t z = 1; z < n - 1; ++z)
      for (std::size_t y = 1; y < n - 1; ++y) {
        const std::size_t row = (z * n + y) * n;
        std::fill_n(m_state.begin() + static_cast<std::ptrdiff_t>(row) + 1, n - 2, kFree);
        for (std::size_t index = row + 1; index < row + n - 1; ++index)
          if (isBeside[index] != 0) begin(index);
      }
  }

  const Depths& run() {
    while (!m_layer.empty()) {
      m_next.clear();
      for (const std::uint16_t index : m_layer)
        for (const int step : kAxisSteps)
          for (const int to : {index - step, index + step})
            if (m_state[static_cast<std::size_t>(to)] == kFree) {
              m_state[static_cast<std::size_t>(to)] = kKnown;
              m_next.push_back(static_cast<std::uint16_t>(to));
            }
      m_found.clear();
      for (const std::uint16_t index : m_next) m_found.push_back(eikonalDistance(nearest(index)));
      m_layer.clear();
      for (std::size_t i = 0; i < m_next.size(); ++i) {
        m_distances[m_next[i]] = m_found[i];
        if (m_found[i] < static_cast<float>(DepthWindow::kLimit)) m_layer.push_back(m_next[i]);
      }
    }
    return m_distances;
  }

 private:
  enum State : std::uint8_t { kOutside, kFree, kKnown };
  static constexpr float kUnknown = 1e3f;
  static constexpr float kLeastSlope = 0.7f;  // in thin walls differences underestimate the slope

  // Starts at a voxel beside the surface, with its depth corrected by the slope.
  void begin(std::size_t index) {
    const float depth = m_depths[index];
    const bool isKept = m_beside == DepthWindow::Beside::Kept;
    m_distances[index] = std::abs(depth) / (isKept ? 1.0f : std::max(kLeastSlope, slopeAt(index)));
    m_state[index] = kKnown;
    m_layer.push_back(static_cast<std::uint16_t>(index));
  }

  // Along each axis the steepest step across the surface, else the mean of both steps.
  float slopeAt(std::size_t index) const {
    const float depth = m_depths[index];
    float squares = 0.0f;
    for (const int step : kAxisSteps) {
      const float a = m_depths[index - static_cast<std::size_t>(step)],
                  b = m_depths[index + static_cast<std::size_t>(step)];
      const bool crossesA = (a > 0.0f) != (depth > 0.0f), crossesB = (b > 0.0f) != (depth > 0.0f);
      float steepest = crossesA ? std::abs(depth - a) : 0.0f;
      if (crossesB) steepest = std::max(steepest, std::abs(depth - b));
      if (!crossesA && !crossesB) steepest = 0.5f * std::abs(b - a);
      squares += steepest * steepest;
    }
    return std::sqrt(squares);
  }

  std::array<float, 3> nearest(std::size_t index) const {
    std::array<float, 3> least;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto step = static_cast<std::size_t>(kAxisSteps[k]);
      least[k] = std::min(m_distances[index - step], m_distances[index + step]);
    }
    return least;
  }

  const Depths& m_depths;
  const DepthWindow::Beside m_beside;
  Depths m_distances;
  std::array<std::uint8_t, std::tuple_size_v<Depths>> m_state;
  std::vector<std::uint16_t> m_layer, m_next;
  std::vector<float> m_found;
};

}  // namespace

bool DepthWindow::hasSurface() const {
  const bool isInside = m_depths.front() > 0.0f;
  return std::any_of(m_depths.begin(), m_depths.end(), [&](float depth) { return (depth > 0.0f) != isInside; });
}

void DepthWindow::redistance(Beside beside) {
  constexpr auto kMost = static_cast<float>(kLimit);
  if (!hasSurface()) {
    m_depths.fill(m_depths.front() > 0.0f ? kMost : -kMost);
    return;
  }
  Marching marching(m_depths, beside);
  const Depths& distances = marching.run();
  for (std::size_t i = 0; i < m_depths.size(); ++i)
    m_depths[i] = std::copysign(std::min(distances[i], kMost), m_depths[i]);
}

SparseVolume::Content contentOf(std::shared_ptr<VolumeBlock> block) {
  const auto& depths = block->depths;
  const std::int16_t first = depths.front();
  const bool isAtLimit = first == VolumeBlock::kFull || first == VolumeBlock::kEmpty;
  if (isAtLimit && std::all_of(depths.begin(), depths.end(), [&](std::int16_t d) { return d == first; }))
    return {nullptr, first == VolumeBlock::kFull};
  return {std::move(block), false};
}

std::shared_ptr<VolumeBlock> samplesOf(const SparseVolume::Content& content) {
  if (content.block) return std::make_shared<VolumeBlock>(*content.block);
  auto block = std::make_shared<VolumeBlock>();
  block->depths.fill(content.isFull ? VolumeBlock::kFull : VolumeBlock::kEmpty);
  return block;
}

}  // namespace handwheel
