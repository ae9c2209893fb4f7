// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/DepthWindow.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace handwheel {
namespace {

constexpr std::array<int, 3> kSteps{1, DepthWindow::kSide, DepthWindow::kSide* DepthWindow::kSide};

// Whether a neighbour along an axis lies within the window. place: index of a depth.
bool hasNeighbour(int place, int axis, int direction) {
  static_assert(DepthWindow::kSide == 16);  // four bits of the index for each axis
  const int at = (place >> 4 * axis & 15) + direction;
  return at >= 0 && at < DepthWindow::kSide;
}

// The distance at a place whose neighbours along the axes have these distances: |gradient| = 1, by the axes whose
// neighbours are nearer (Rouy, Tourin 1992).
float eikonal(std::array<float, 3> d) {
  std::sort(d.begin(), d.end());
  float x = d[0] + 1.0f;
  if (x > d[1]) {
    const float sum = d[0] + d[1], difference = d[0] - d[1];
    x = 0.5f * (sum + std::sqrt(std::max(0.0f, 2.0f - difference * difference)));
    if (x > d[2]) {
      const float all = d[0] + d[1] + d[2], squares = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
      x = (all + std::sqrt(std::max(0.0f, all * all - 3.0f * (squares - 1.0f)))) / 3.0f;
    }
  }
  return x;
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

// Along one axis after the other: the mean over a cube is that of means.
void DepthWindow::average(int reach) {
  const float share = 1.0f / static_cast<float>(2 * reach + 1);
  for (const int step : kSteps) {
    const Depths before = m_depths;
    for (int place = 0; place < static_cast<int>(before.size()); ++place) {
      const int at = place / step % kSide;
      if (at < reach || at >= kSide - reach) continue;
      float sum = 0.0f;
      for (int k = -reach; k <= reach; ++k) sum += before[static_cast<std::size_t>(place + k * step)];
      m_depths[static_cast<std::size_t>(place)] = share * sum;
    }
  }
}

void DepthWindow::redistance(Beside beside) {
  constexpr float kUnknown = 1e3f, kWaiting = 2e3f, kMost = static_cast<float>(kLimit);
  constexpr float kLeastSlope = 0.7f;  // in thin walls differences say less than the slope is
  const bool isInside = m_depths.front() > 0.0f;
  if (std::all_of(m_depths.begin(), m_depths.end(), [&](float depth) { return (depth > 0.0f) == isInside; })) {
    m_depths.fill(isInside ? kMost : -kMost);
    return;
  }
  Depths distances;
  distances.fill(kUnknown);
  std::vector<int> layer, next, previous;
  const int count = static_cast<int>(m_depths.size());
  for (int place = 0; place < count; ++place) {
    const float depth = m_depths[static_cast<std::size_t>(place)];
    bool isBeside = false;
    float slope = 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
      float steepest = 0.0f;
      for (const int direction : {-1, 1}) {
        if (!hasNeighbour(place, axis, direction)) continue;
        const float other =
            m_depths[static_cast<std::size_t>(place + direction * kSteps[static_cast<std::size_t>(axis)])];
        if ((other > 0.0f) == (depth > 0.0f)) continue;
        isBeside = true;
        steepest = std::max(steepest, std::abs(depth - other));
      }
      if (steepest == 0.0f && hasNeighbour(place, axis, -1) && hasNeighbour(place, axis, 1)) {
        const auto step = kSteps[static_cast<std::size_t>(axis)];
        steepest = 0.5f * std::abs(m_depths[static_cast<std::size_t>(place + step)] -
                                   m_depths[static_cast<std::size_t>(place - step)]);
      }
      slope += steepest * steepest;
    }
    if (!isBeside) continue;
    const float known = beside == Beside::Kept ? 1.0f : std::max(kLeastSlope, std::sqrt(slope));
    distances[static_cast<std::size_t>(place)] = std::abs(depth) / known;
    layer.push_back(place);
  }
  while (!layer.empty()) {
    next.clear();
    for (const int place : layer)
      for (int axis = 0; axis < 3; ++axis)
        for (const int direction : {-1, 1}) {
          if (!hasNeighbour(place, axis, direction)) continue;
          const int to = place + direction * kSteps[static_cast<std::size_t>(axis)];
          if (distances[static_cast<std::size_t>(to)] != kUnknown) continue;
          distances[static_cast<std::size_t>(to)] = kWaiting;
          next.push_back(to);
        }
    std::vector<float> found(next.size());
    for (std::size_t i = 0; i < next.size(); ++i) {
      std::array<float, 3> nearest{kUnknown, kUnknown, kUnknown};
      for (int axis = 0; axis < 3; ++axis)
        for (const int direction : {-1, 1})
          if (hasNeighbour(next[i], axis, direction))
            nearest[static_cast<std::size_t>(axis)] = std::min(
                nearest[static_cast<std::size_t>(axis)],
                distances[static_cast<std::size_t>(next[i] + direction * kSteps[static_cast<std::size_t>(axis)])]);
      found[i] = eikonal(nearest);
    }
    previous.clear();
    for (std::size_t i = 0; i < next.size(); ++i) {
      distances[static_cast<std::size_t>(next[i])] = found[i];
      if (found[i] < kMost) previous.push_back(next[i]);
    }
    layer.swap(previous);
  }
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
