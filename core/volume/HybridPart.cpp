// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/HybridPart.h"

#include "volume/SurfaceToVolume.h"
#include "volume/VolumeSampler.h"
#include "volume/repair/ClosedSurfaceInVoxels.h"
#include "volume/repair/WindingNumberFill.h"
#include "volume/surface/SurfaceTile.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace handwheel {
namespace {

static_assert(HybridPart::kTile == SurfaceTile::kSide);
constexpr double kHybridFar = 2.0 * SparseVolume::kMostVoxels;  // beyond all triangles, voxels

std::array<int, 3> hybridKey(const VoxelIndex& at) {
  return {at.z(), at.y(), at.x()};
}

VoxelIndex hybridIndex(const std::array<int, 3>& key) {
  return {key[2], key[1], key[0]};
}

VoxelIndex hybridTile(const Vec3& voxel) {
  return (voxel / HybridPart::kTile).array().floor().matrix().cast<int>();
}

}  // namespace

struct HybridPart::Tile {
  std::array<SparseVolume::Content, SurfaceTile::kAllBlocks> blocks;
  std::size_t near = 0, lost = 0;  // see m_near and m_lost

  // Beside a surface that is smooth at the scale of a voxel there is a neighbour on its other side. Voxels at the
  // tile's own sides have neighbours in other tiles: they are left out.
  void countLost(const VoxelIndex& first);
};

void HybridPart::Tile::countLost(const VoxelIndex& first) {
  constexpr int kBeside = static_cast<int>(0.75 * VolumeBlock::kUnit);
  SparseVolume own;
  for (int b = 0; b < SurfaceTile::kAllBlocks; ++b)
    own.setContent(SparseVolume::blockOf(first) + SurfaceTile::blockAt(b), blocks[static_cast<std::size_t>(b)]);
  const VolumeSampler sampler(own);
  for (int b = 0; b < SurfaceTile::kAllBlocks; ++b) {
    const SparseVolume::Block& block = blocks[static_cast<std::size_t>(b)].block;
    for (int i = 0; block && i < static_cast<int>(VolumeBlock::kCount); ++i) {
      const int depth = block->depths[static_cast<std::size_t>(i)];
      const VoxelIndex in = VolumeBlock::kSize * SurfaceTile::blockAt(b) + VoxelIndex(i & 7, i >> 3 & 7, i >> 6);
      if (std::abs(depth) > kBeside || in.minCoeff() == 0 || in.maxCoeff() == kTile - 1) continue;
      bool isOther = false;
      for (int k = 0; k < 27 && !isOther; ++k) {
        const VoxelIndex beside = first + in + VoxelIndex(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
        isOther = (sampler.sample(beside) > 0) != (depth > 0);
      }
      ++near;
      if (!isOther) ++lost;
    }
  }
}

Result<HybridPart> HybridPart::of(const TriangleSoup& soup, double voxel, Progress progress) {
  const Result<ClosedSurfaceInVoxels> prepared =
      closedInGrid(soup, voxel, WindingNumberFill::kWide, {}, progress.part(0.0, 0.5));
  if (!prepared) return prepared.error();
  if (progress.cancelled())
    return Error{ErrorCode::Cancelled, {}, {}, {}};  // then the closed surface may be half of it
  if (!(prepared->enclosed() > 0.0)) return prepared->nothingInside();
  HybridPart part;
  part.m_triangles = std::make_shared<const TriangleHierarchy>(prepared->closed.points, prepared->closed.triangles,
                                                               progress.part(0.5, 1.0));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  part.m_left = part.m_before = prepared->grid;
  part.m_extent = Box(Vec3::Zero(), VolumeBlock::kSize * prepared->blocks().cast<double>());
  part.m_isSimple = prepared->caps.wide.empty();
  return part;
}

bool HybridPart::isExact() const {
  return m_isSimple && static_cast<double>(m_lost) <= (1.0 - kLeastKept) * static_cast<double>(m_near);
}

void HybridPart::make(std::span<const VoxelIndex> tiles) {
  Eigen::AlignedBox3i kept = m_held;
  for (const VoxelIndex& tile : tiles) {
    kept.extend(VoxelIndex(tile - VoxelIndex::Ones()));
    kept.extend(VoxelIndex(tile + VoxelIndex::Ones()));
  }
  if (kept.min() != m_kept.min() || kept.max() != m_kept.max()) giveBackBut(kept);
  add(tiles);
}

void HybridPart::makeAlso(std::span<const VoxelIndex> tiles) {
  const Eigen::AlignedBox3i all = tilesIn(m_extent);
  std::vector<VoxelIndex> ofPart;
  for (const VoxelIndex& tile : tiles)
    if (all.contains(tile)) ofPart.push_back(tile);
  add(ofPart);
}

bool HybridPart::hold(const Box& box) {
  Eigen::AlignedBox3i held;
  if (!box.isEmpty() && box.min().allFinite() && box.max().allFinite()) {
    const Vec3 origin = m_before.origin();
    const Box voxels((box.min() - origin) / m_before.voxel(), (box.max() - origin) / m_before.voxel());
    held = tilesIn(voxels.intersection(m_extent));
  }
  if (held.min() == m_held.min() && held.max() == m_held.max()) return false;
  m_held = held;
  std::vector<VoxelIndex> tiles;
  for (int z = held.min().z(); z <= held.max().z(); ++z)
    for (int y = held.min().y(); y <= held.max().y(); ++y)
      for (int x = held.min().x(); x <= held.max().x(); ++x) tiles.emplace_back(x, y, z);
  add(tiles);
  return true;
}

Eigen::AlignedBox3i HybridPart::tilesIn(const Box& voxels) const {
  if (voxels.isEmpty()) return {};
  return {hybridTile(voxels.min()), hybridTile(voxels.max())};
}

void HybridPart::keep(std::span<const VoxelIndex> blocks) {
  for (const VoxelIndex& block : blocks)
    if (m_cut.insert(hybridKey(block)).second && m_before.view(block).block) ++m_originals;
  count();
}

std::vector<VoxelIndex> HybridPart::cutBlocks() const {
  std::vector<VoxelIndex> blocks;
  for (const Key& key : m_cut) blocks.push_back(hybridIndex(key));
  return blocks;
}

double HybridPart::depthBefore(const Vec3& point) {
  const Vec3 at = (point - m_before.origin()) / m_before.voxel();
  if (at.allFinite() && m_extent.contains(at)) {
    // The eight samples around it.
    std::vector<VoxelIndex> tiles;
    for (int k = 0; k < 8; ++k) {
      const VoxelIndex tile = hybridTile(at.array().floor().matrix() + Vec3(k & 1, k >> 1 & 1, k >> 2));
      if (std::find(tiles.begin(), tiles.end(), tile) == tiles.end()) tiles.push_back(tile);
    }
    add(tiles);
  }
  return VolumeSampler(m_before).depthAt(point).depth;
}

void HybridPart::add(std::span<const VoxelIndex> tiles) {
  std::vector<VoxelIndex> fresh;
  for (const VoxelIndex& tile : tiles)
    if (m_tiles.insert(hybridKey(tile)).second) fresh.push_back(tile);
  if (fresh.empty()) return;
  for (const VoxelIndex& tile : fresh) makeRows(tile);
  std::vector<Tile> made(fresh.size());
  tbb::parallel_for(std::size_t{0}, fresh.size(), [&](std::size_t i) { made[i] = madeTile(fresh[i]); });
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    if (m_judged.insert(hybridKey(fresh[i])).second) {
      m_near += made[i].near;
      m_lost += made[i].lost;
    }
    for (int b = 0; b < SurfaceTile::kAllBlocks; ++b) {
      const VoxelIndex block = SurfaceTile::kBlocks * fresh[i] + SurfaceTile::blockAt(b);
      const SparseVolume::Content& content = made[i].blocks[static_cast<std::size_t>(b)];
      const bool isCut = m_cut.contains(hybridKey(block));
      if (content.block) ++m_figures.blocksMade;
      if (content.block && isCut) ++m_originals;
      m_before.setContent(block, content);
      if (!isCut) m_left.setContent(block, content);
    }
  }
  count();
}

void HybridPart::giveBackBut(const Eigen::AlignedBox3i& kept) {
  m_kept = kept;
  for (auto it = m_tiles.begin(); it != m_tiles.end();) {
    if (kept.contains(hybridIndex(*it))) {
      ++it;
      continue;
    }
    giveBack(hybridIndex(*it));
    it = m_tiles.erase(it);
  }
  std::erase_if(m_rows, [&](const auto& rows) {
    return !kept.contains(VoxelIndex(kept.min().x(), rows.first[1], rows.first[0]));
  });
}

void HybridPart::giveBack(const VoxelIndex& tile) {
  for (int b = 0; b < SurfaceTile::kAllBlocks; ++b) {
    const VoxelIndex block = SurfaceTile::kBlocks * tile + SurfaceTile::blockAt(b);
    const bool isCut = m_cut.contains(hybridKey(block));
    if (isCut && m_before.view(block).block) --m_originals;
    m_before.setContent(block, {});
    if (!isCut) m_left.setContent(block, {});
  }
}

void HybridPart::makeRows(const VoxelIndex& tile) {
  std::shared_ptr<const ScanlineCrossings>& rows = m_rows[{tile.z(), tile.y()}];
  if (rows) return;
  const Eigen::Vector2i first = kTile * tile.tail<2>(), last = first + Eigen::Vector2i::Constant(kTile - 1);
  const Box along(Vec3(-kHybridFar, first.x(), first.y()), Vec3(kHybridFar, last.x(), last.y()));
  rows = std::make_shared<ScanlineCrossings>(trianglesIn(along), Progress(), Eigen::AlignedBox2i(first, last));
  m_isSimple = m_isSimple && rows->isSimple();
}

HybridPart::Tile HybridPart::madeTile(const VoxelIndex& tile) const {
  const ScanlineCrossings& rows = *m_rows.at({tile.z(), tile.y()});
  const VoxelIndex first = kTile * tile;
  const Vec3 low = first.cast<double>(), reach = Vec3::Constant(SurfaceTile::kBand);
  const TriangleSoup near = trianglesIn(Box(low - reach, low + Vec3::Constant(kTile - 1) + reach));
  SurfaceTile distances(first);
  for (const Triangle& t : near.triangles) distances.add({near, t});
  Tile made;
  for (int b = 0; b < SurfaceTile::kAllBlocks; ++b) {
    const VoxelIndex inTile = VolumeBlock::kSize * SurfaceTile::blockAt(b);
    SparseVolume::Content& content = made.blocks[static_cast<std::size_t>(b)];
    if (!near.triangles.empty()) content.block = distances.signedBlock(inTile, rows);
    content.isFull = !content.block && rows.isInside(first + inTile);
  }
  if (!near.triangles.empty()) made.countLost(first);
  return made;
}

// Sorted by index, so that a tile is identical to the last bit to the one of the whole volume.
TriangleSoup HybridPart::trianglesIn(const Box& box) const {
  std::vector<std::uint32_t> numbers;
  m_triangles->forEachInBox(box, [&](std::uint32_t triangle) {
    numbers.push_back(triangle);
    return true;
  });
  std::sort(numbers.begin(), numbers.end());
  TriangleSoup soup;
  for (const std::uint32_t number : numbers) {
    const auto n = static_cast<std::uint32_t>(soup.points.size());
    for (const Vec3& p : m_triangles->corners(number)) soup.points.push_back(p);
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  return soup;
}

std::size_t HybridPart::bytes() const {
  constexpr std::size_t kKey = sizeof(Key) + 48;  // with its node in a set
  // Shared blocks are counted once.
  std::size_t sum = m_left.bytes() + m_before.bytes() - (m_before.blockCount() - m_originals) * sizeof(VolumeBlock);
  for (const auto& [key, rows] : m_rows) sum += rows->bytes();
  return sum + m_cut.size() * kKey;
}

void HybridPart::count() {
  m_figures.mostBlocks = std::max(m_figures.mostBlocks, blockCount());
  m_figures.mostBytes = std::max(m_figures.mostBytes, bytes());
}

}  // namespace handwheel
