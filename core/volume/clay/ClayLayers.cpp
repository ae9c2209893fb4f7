// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/clay/ClayLayers.h"

#include "volume/VolumeDifference.h"
#include "volume/clay/DabBlocks.h"
#include "volume/repair/DepthWindow.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace handwheel {
namespace {

constexpr int kDeepestSample = ClayLayerChange::kDeepestSample;

using BlockDepths = std::array<float, VolumeBlock::kCount>;

// The slope of depths at a voxel of a block, by its neighbours within the block.
float slopeAt(const BlockDepths& depths, int x, int y, int z) {
  constexpr int kLast = VolumeBlock::kSize - 1;
  const std::array<int, 3> at{x, y, z}, strides{1, VolumeBlock::kSize, VolumeBlock::kSize * VolumeBlock::kSize};
  const int index = static_cast<int>(VolumeBlock::at(x, y, z));
  float squares = 0.0f;
  for (std::size_t k = 0; k < 3; ++k) {
    const int low = at[k] > 0 ? -strides[k] : 0, high = at[k] < kLast ? strides[k] : 0;
    const float difference =
        depths[static_cast<std::size_t>(index + high)] - depths[static_cast<std::size_t>(index + low)];
    const float slope = difference * static_cast<float>(strides[k]) / static_cast<float>(high - low);
    squares += slope * slope;
  }
  return std::sqrt(squares);
}

// A share of what a layer changes, added to the depths of a block. Sums of distances are not distances where the
// surfaces are at an angle to each other: dividing by their slope makes them distances again, to first order. The slope
// is compared with that of the depths below the layer and of its own, by their shares: at edges and in thin walls
// differences underestimate it, and the result for a share near 0 or 1 must approach these depths.
SparseVolume::Content withShare(const SparseVolume::Content& below, const ClayLayerChange::Distances& layer,
                                double share) {
  constexpr float kMostFactor = 4.0f, kNoSlope = 0.01f;
  constexpr auto kLimit = static_cast<float>(DepthWindow::kLimit);
  std::shared_ptr<VolumeBlock> block = samplesOf(below);
  const auto part = static_cast<float>(share);
  BlockDepths before, own, depths;  // below the layer; of the layer where it was made; the sum
  for (std::size_t i = 0; i < VolumeBlock::kCount; ++i) {
    const std::int16_t sample = block->depths[i];
    float depth = static_cast<float>(sample) * static_cast<float>(1.0 / VolumeBlock::kUnit);
    // If the surface below is beyond the stored depths, its distance is taken from when the layer was made.
    if (std::abs(static_cast<int>(sample)) >= kDeepestSample)
      depth = std::copysign(std::max(ClayLayerChange::kKnownDepth, std::abs(layer.base[i])), depth);
    before[i] = depth;
    own[i] = layer.base[i] + layer.change[i];
    depths[i] = depth + part * layer.change[i];
  }
  // Beyond the stored depths it is 1.
  const auto slopeOf = [](const BlockDepths& of, int x, int y, int z) {
    return std::abs(of[VolumeBlock::at(x, y, z)]) < kLimit ? slopeAt(of, x, y, z) : 1.0f;
  };
  for (int z = 0; z < VolumeBlock::kSize; ++z)
    for (int y = 0; y < VolumeBlock::kSize; ++y)
      for (int x = 0; x < VolumeBlock::kSize; ++x) {
        const std::size_t i = VolumeBlock::at(x, y, z);
        // Blocks that the layer does not change are not touched. Changed blocks never become full or empty, so that a
        // surface lies between them and any neighbours.
        if (layer.change[i] == 0.0f) continue;
        float depth = depths[i];
        if (std::abs(depth) < kLimit) {
          const float wanted = (1.0f - part) * slopeOf(before, x, y, z) + part * slopeOf(own, x, y, z);
          const float factor = (wanted + kNoSlope) / (slopeAt(depths, x, y, z) + kNoSlope);
          depth *= std::clamp(factor, 1.0f / kMostFactor, kMostFactor);
        }
        const int sample = depthSample(static_cast<double>(depth));
        block->depths[i] = static_cast<std::int16_t>(std::clamp(sample, -kDeepestSample, kDeepestSample));
      }
  return contentOf(std::move(block));
}

}  // namespace

void ClayLayers::add(std::string name, const SparseVolume& visible) {
  assert(m_layers.size() < kMostLayers);
  m_layers.push_back({std::move(name), 1.0, true, std::make_shared<const ClayLayerChange>(visible, visible)});
}

void ClayLayers::setShare(std::size_t layer, double strength, bool isOn) {
  assert(strength >= 0.0 && strength <= 1.0);
  m_layers[layer].strength = strength;
  m_layers[layer].isOn = isOn;
}

void ClayLayers::remove(std::size_t layer) {
  m_layers.erase(m_layers.begin() + static_cast<std::ptrdiff_t>(layer));
}

void ClayLayers::mergeDown(std::size_t layer) {
  SparseVolume both = visible(layer + 1);
  if (layer == 0) {
    m_root = std::move(both);
  } else {
    ClayLayer& below = m_layers[layer - 1];
    below.change = std::make_shared<const ClayLayerChange>(visible(layer - 1), both);
    below.strength = 1.0;
    below.isOn = true;
  }
  remove(layer);
}

void ClayLayers::record(const SparseVolume& before, const SparseVolume& after) {
  assert(canBeSculpted());
  const std::size_t below = m_layers.size() - 1;
  const ClayLayerChange& change = *m_layers[below].change;
  // The visible volume is the volume below wherever the layer changes nothing. Blocks that are already in its base are
  // shared, so that no stroke stores those before it again.
  SparseVolume base = before;
  replace(base, change.blocks(), [&](const VoxelIndex& block) {
    SparseVolume::Content content = visibleContent(block, below);
    return isSameContent(viewOf(content), change.base().view(block)) ? change.base().content(block) : content;
  });
  m_layers[below].change = std::make_shared<const ClayLayerChange>(base, after);
}

SparseVolume::Content ClayLayers::visibleContent(const VoxelIndex& block, std::size_t layers) const {
  SparseVolume::Content content = m_root.content(block);
  for (std::size_t k = 0; k < layers; ++k) {
    const ClayLayerChange& change = *m_layers[k].change;
    const double share = m_layers[k].share();
    if (share == 0.0 || !change.changes(block)) continue;
    if (share == 1.0 && isSameContent(viewOf(content), change.base().view(block))) {
      content = change.top().content(block);
    } else {
      content = withShare(content, *change.distances(block), share);
    }
  }
  return content;
}

SparseVolume ClayLayers::visible(std::size_t layers) const {
  std::vector<VoxelIndex> blocks;
  for (std::size_t k = 0; k < layers; ++k) {
    const std::vector<VoxelIndex>& changed = m_layers[k].change->blocks();
    blocks.insert(blocks.end(), changed.begin(), changed.end());
  }
  std::sort(blocks.begin(), blocks.end(), isBlockBefore);
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  SparseVolume volume = m_root;
  replace(volume, blocks, [&](const VoxelIndex& block) { return visibleContent(block, layers); });
  return volume;
}

std::vector<VoxelIndex> ClayLayers::show(const std::vector<VoxelIndex>& blocks, SparseVolume& volume) const {
  return replace(volume, blocks, [&](const VoxelIndex& block) { return visibleContent(block, m_layers.size()); });
}

std::size_t ClayLayers::bytes() const {
  std::size_t bytes = sizeof *this;
  for (const ClayLayer& layer : m_layers) bytes += sizeof layer + layer.name.size() + layer.change->bytes();
  return bytes;
}

}  // namespace handwheel
