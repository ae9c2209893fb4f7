// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeBoolean.h"

#include "volume/VolumeFilters.h"
#include "volume/VolumeResampling.h"
#include "volume/repair/DepthWindow.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace handwheel {
namespace {

SparseVolume::Content opposite(const SparseVolume::Content& content) {
  if (!content.block) return {nullptr, !content.isFull};
  auto turned = std::make_shared<VolumeBlock>();
  std::transform(content.block->depths.begin(), content.block->depths.end(), turned->depths.begin(),
                 [](std::int16_t depth) { return static_cast<std::int16_t>(-std::max(depth, VolumeBlock::kEmpty)); });
  return {std::move(turned), false};
}

// Returns the union of two blocks.
SparseVolume::Content united(const SparseVolume::Content& a, const SparseVolume::Content& b) {
  if (!a.block) return a.isFull ? a : b;
  if (!b.block) return b.isFull ? b : a;
  auto made = std::make_shared<VolumeBlock>();
  std::transform(a.block->depths.begin(), a.block->depths.end(), b.block->depths.begin(), made->depths.begin(),
                 [](std::int16_t x, std::int16_t y) { return std::max(x, y); });
  return contentOf(std::move(made));
}
SparseVolume::Content intersected(const SparseVolume::Content& a, const SparseVolume::Content& b) {
  if (!a.block) return a.isFull ? b : a;
  if (!b.block) return b.isFull ? a : b;
  auto made = std::make_shared<VolumeBlock>();
  std::transform(a.block->depths.begin(), a.block->depths.end(), b.block->depths.begin(), made->depths.begin(),
                 [](std::int16_t x, std::int16_t y) { return std::min(x, y); });
  return contentOf(std::move(made));
}

SparseVolume::Content contentOfBoth(const SparseVolume::Content& a, const SparseVolume::Content& b, VolumeBoolean how) {
  if (how == VolumeBoolean::Unite) return united(a, b);
  if (how == VolumeBoolean::Intersect) return intersected(a, b);
  // Avoids a copy of blocks away from the first.
  return !a.block && !a.isFull ? a : intersected(a, opposite(b));
}

}  // namespace

Result<SparseVolume> combined(const SparseVolume& first, const SparseVolume& second, VolumeBoolean how,
                              Progress progress) {
  const Result<SparseVolume> other = resampled(second, first.origin(), first.voxel(), progress.part(0.0, 0.5));
  if (!other) return other.error();
  std::vector<VoxelIndex> blocks;
  const SparseVolume& deciding = how == VolumeBoolean::Intersect ? first : *other;
  deciding.forEach([&](const VoxelIndex& at, const SparseVolume::Content&) { blocks.push_back(at); });
  SparseVolume made = first;
  std::vector<SparseVolume::Content> contents(blocks.size());
  const Progress combining = progress.part(0.5, 1.0);
  std::atomic<std::size_t> done{0};
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
    if (progress.cancelled()) return;
    contents[i] = contentOfBoth(first.content(blocks[i]), other->content(blocks[i]), how);
    combining.set(static_cast<double>(++done) / static_cast<double>(blocks.size()));
  });
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  for (std::size_t i = 0; i < blocks.size(); ++i) made.setContent(blocks[i], std::move(contents[i]));
  dropFar(made, blocks);
  return made;
}

}  // namespace handwheel
