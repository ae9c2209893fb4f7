// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeSurface.h"

#include "volume/VolumeToSurface.h"

#include <tbb/parallel_for.h>

#include <atomic>
#include <vector>

namespace handwheel {
namespace {

VolumeSurface::Key pieceOf(const VoxelIndex& block) {
  return {block.z() >> 3, block.y() >> 3, block.x() >> 3};
}

}  // namespace

VolumeSurface::VolumeSurface(const SparseVolume& volume, Progress progress) {
  std::map<Key, std::vector<VoxelIndex>> blocks;
  for (const VoxelIndex& block : blocksWithCells(volume)) blocks[pieceOf(block)].push_back(block);
  using Entry = std::pair<const Key, std::vector<VoxelIndex>>;
  std::vector<const Entry*> entries;
  for (const Entry& entry : blocks) entries.push_back(&entry);
  std::vector<Piece> made(entries.size());
  std::atomic<std::size_t> done{0};
  tbb::parallel_for(std::size_t{0}, entries.size(), [&](std::size_t i) {
    if (progress.cancelled()) return;
    made[i] = std::make_shared<const TriangleSoup>(surfaceOf(volume, entries[i]->second));
    progress.set(static_cast<double>(++done) / static_cast<double>(entries.size()));
  });
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (made[i] && !made[i]->triangles.empty()) m_pieces[entries[i]->first] = std::move(made[i]);
}

std::size_t VolumeSurface::triangleCount() const {
  std::size_t count = 0;
  for (const auto& [key, piece] : m_pieces) count += piece->triangles.size();
  return count;
}

}  // namespace handwheel
