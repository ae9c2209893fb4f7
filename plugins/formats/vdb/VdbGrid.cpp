// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vdb/VdbGrid.h"

#include "volume/VolumeFilters.h"
#include "volume/VolumeSerialization.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

using openvdb::Coord;
using openvdb::FloatGrid;

constexpr int kLeaf = VolumeBlock::kSize;
static_assert(openvdb::FloatTree::LeafNodeType::DIM == kLeaf);
constexpr std::size_t kMostFullBlocks = std::size_t{1} << 25;

Error vdbError(const char* reason) {
  return {ErrorCode::LibraryFailed, {reason}, {}, {}};
}

bool isFogGrid(const FloatGrid& grid) {
  return grid.getGridClass() == openvdb::GRID_FOG_VOLUME ||
         (grid.getGridClass() != openvdb::GRID_LEVEL_SET && grid.background() <= 0.0f);
}

// The first level set, or else the first grid of floats; null where there is none.
FloatGrid::ConstPtr chosenGrid(const openvdb::GridPtrVec& grids) {
  FloatGrid::ConstPtr found;
  for (const openvdb::GridBase::Ptr& each : grids) {
    const auto grid = openvdb::gridPtrCast<FloatGrid>(each);
    if (grid && (!found || (isFogGrid(*found) && !isFogGrid(*grid)))) found = grid;
  }
  return found;
}

// The volume without blocks; none where voxels are no cubes along the axes.
std::optional<SparseVolume> emptyOf(const FloatGrid& grid) {
  if (!grid.transform().isLinear()) return {};
  const openvdb::Vec3d first = grid.indexToWorld(Coord(0, 0, 0));
  const Vec3 origin(first.x(), first.y(), first.z());
  double voxel = 0.0;
  for (int k = 0; k < 3; ++k) {
    Coord one(0, 0, 0);
    one[k] = 1;
    const openvdb::Vec3d next = grid.indexToWorld(one);
    const Vec3 step = Vec3(next.x(), next.y(), next.z()) - origin;
    if (k == 0) voxel = step.norm();
    if ((step - voxel * Vec3::Unit(k)).norm() > 1e-6 * voxel) return {};
  }
  if (!origin.allFinite() || !(voxel > 1e-9 && voxel < 1e9) || origin.cwiseAbs().maxCoeff() > 1e12) return {};
  return SparseVolume(origin, voxel);
}

VoxelIndex blockAt(const Coord& voxel) {
  return SparseVolume::blockOf(VoxelIndex(voxel.x(), voxel.y(), voxel.z()));
}

bool isNearOrigin(const Coord& voxel) {
  constexpr int kMost = SparseVolume::kMostVoxels - 8;
  // Both ends, as the least integer has no absolute value.
  return std::max({voxel.x(), voxel.y(), voxel.z()}) < kMost && std::min({voxel.x(), voxel.y(), voxel.z()}) > -kMost;
}

// Depths in voxels of values of a grid.
struct DepthOfValue {
  double factor, offset, least;  // beyond the least depth it is the largest depth

  std::int16_t operator()(float value) const {
    if (!std::isfinite(value)) return VolumeBlock::kEmpty;
    const double depth = factor * (static_cast<double>(value) - offset);
    return depthSample(std::abs(depth) >= least ? std::copysign(1e3, depth) : depth);
  }
};

Status addLeaves(const FloatGrid& grid, const DepthOfValue& depthOf, SparseVolume& volume) {
  for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf) {
    if (!isNearOrigin(leaf->origin())) return vdbError("it is too large");
    auto block = std::make_shared<VolumeBlock>();
    for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i)
      block->depths[static_cast<std::size_t>(i)] =
          depthOf(leaf->getValue(leaf->coordToOffset(Coord(i & 7, i >> 3 & 7, i >> 6))));
    volume.setContent(blockAt(leaf->origin()), contentOf(std::move(block)));
  }
  return Done{};
}

// Adds the inside of tiles with one value.
Status addTiles(const FloatGrid& grid, const DepthOfValue& depthOf, SparseVolume& volume) {
  std::size_t blocks = 0;
  auto tile = grid.tree().cbeginValueAll();
  tile.setMaxDepth(openvdb::FloatTree::ValueAllCIter::LEAF_DEPTH - 1);
  for (; tile; ++tile) {
    if (depthOf(tile.getValue()) < 0) continue;
    openvdb::CoordBBox box;
    if (!tile.getBoundingBox(box)) continue;
    if (!isNearOrigin(box.min()) || !isNearOrigin(box.max())) return vdbError("it is too large");
    const VoxelIndex low = blockAt(box.min()), high = blockAt(box.max());
    blocks += static_cast<std::size_t>((high - low + VoxelIndex::Ones()).cast<double>().prod());
    if (blocks > kMostFullBlocks) return vdbError("it is too large");
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x) volume.setContent({x, y, z}, {nullptr, true});
  }
  return Done{};
}

}  // namespace

Result<VdbVolume> volumeOfGrids(const openvdb::GridPtrVec& grids) {
  const FloatGrid::ConstPtr grid = chosenGrid(grids);
  if (!grid) return vdbError("it has no grid of floats");
  std::optional<SparseVolume> volume = emptyOf(*grid);
  if (!volume) return vdbError("its voxels are not cubes along the axes");
  const bool isFog = isFogGrid(*grid);
  const double band = std::abs(static_cast<double>(grid->background())) / volume->voxel();
  // A fog rises from 0 to 1 within some voxels: steep enough to show the side, but not the depth.
  const DepthOfValue depthOf =
      isFog ? DepthOfValue{6.0, 0.5, 3.5} : DepthOfValue{-1.0 / volume->voxel(), 0.0, band > 0.0 ? 0.999 * band : 1e3};
  if (const Status added = addTiles(*grid, depthOf, *volume); !added) return added.error();
  if (const Status added = addLeaves(*grid, depthOf, *volume); !added) return added.error();
  if (!closeOff(*volume, kMostFullBlocks)) return vdbError("it is too large");
  constexpr double kDeepEnough = 2.9;  // voxels
  if (isFog) makeDistances(*volume, volume->blocks(), DepthWindow::Beside::Corrected);
  if (!isFog && band < kDeepEnough) makeDistances(*volume, volume->blocks(), DepthWindow::Beside::Kept);
  if (volume->isEmpty()) return vdbError("it bounds no material");
  return VdbVolume{std::move(*volume), isFog, grids.size() - 1};
}

FloatGrid::Ptr gridOf(const SparseVolume& volume) {
  constexpr double kBandVoxels = 3.0;
  const auto background = static_cast<float>(kBandVoxels * volume.voxel());
  const FloatGrid::Ptr grid = FloatGrid::create(background);
  const openvdb::math::Transform::Ptr transform = openvdb::math::Transform::createLinearTransform(volume.voxel());
  transform->postTranslate(openvdb::Vec3d(volume.origin().x(), volume.origin().y(), volume.origin().z()));
  grid->setTransform(transform);
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  grid->setName("surface");
  grid->setCreator("Handwheel");
  volume.forEach([&](const VoxelIndex& at, const SparseVolume::Content& content) {
    const Coord first(kLeaf * at.x(), kLeaf * at.y(), kLeaf * at.z());
    if (!content.block) {
      grid->tree().addTile(1, first, -background, false);
      return;
    }
    auto* const leaf = grid->tree().touchLeaf(first);
    for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
      const double depth = content.block->depths[static_cast<std::size_t>(i)] / VolumeBlock::kUnit;
      const auto value = static_cast<float>(std::clamp(-depth, -kBandVoxels, kBandVoxels) * volume.voxel());
      const openvdb::Index offset = leaf->coordToOffset(Coord(i & 7, i >> 3 & 7, i >> 6));
      leaf->setValueOnly(offset, value);
      leaf->setActiveState(offset, std::abs(depth) < kBandVoxels);
    }
  });
  return grid;
}

}  // namespace handwheel
