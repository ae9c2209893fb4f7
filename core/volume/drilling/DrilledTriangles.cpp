// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrilledTriangles.h"

#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/Weld.h"
#include "volume/repair/BoundaryCaps.h"
#include "volume/repair/DepthWindow.h"
#include "volume/repair/WindingNumberFill.h"
#include "volume/surface/VolumeToSurface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace handwheel {
namespace {

constexpr int kJoinTries = 4;
const Vec3 kJoinStep(0.37e-3, 0.61e-3, 0.83e-3);  // voxels, along no axis and no diagonal
constexpr std::size_t kPosesPerPoll = 256;

using BlockKey = std::array<int, 3>;

VoxelIndex besideBlock(const VoxelIndex& block, int k) {
  return block + VoxelIndex(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
}

BlockKey blockKeyOf(const VoxelIndex& block) {
  return {block.x(), block.y(), block.z()};
}

// The blocks and those beside them, also at edges and corners.
std::set<BlockKey> withBlocksBeside(const std::vector<VoxelIndex>& blocks) {
  std::set<BlockKey> all;
  for (const VoxelIndex& block : blocks)
    for (int k = 0; k < 27; ++k) all.insert(blockKeyOf(besideBlock(block, k)));
  return all;
}

// Returns the material removed from a full block. A block at the boundary of the region always has samples, as the
// surface passes between it and the empty outside.
SparseVolume::Content takenOf(const SparseVolume::Content& left, bool isAtEnd) {
  if (!left.block && left.isFull) return {};
  if (!left.block && !isAtEnd) return {nullptr, true};
  const std::shared_ptr<VolumeBlock> samples = samplesOf(left);
  for (std::int16_t& depth : samples->depths) depth = static_cast<std::int16_t>(-depth);
  return {samples, false};
}

// A part as its voxels were made of it. What closes it comes last: cones with tips that no other triangle has, and
// lids of one triangle.
struct ClosedPart {
  TriangleSoup soup;
  std::size_t closing = 0;  // triangles
  std::vector<Vec3> tips;
  std::vector<TrianglePoints> lids;
};

ClosedPart closedAsForVoxels(const TriangleSoup& triangles, const SparseVolume& grid, Progress progress) {
  ClosedPart closed;
  closed.soup = weld(triangles, progress);
  const std::size_t points = closed.soup.points.size(), own = closed.soup.triangles.size();
  TriangleSoup inVoxels = closed.soup;
  for (Vec3& p : inVoxels.points) p = (p - grid.origin()) / grid.voxel();
  closeBoundaries(inVoxels, WindingNumberFill::kWide, progress);
  for (std::size_t i = points; i < inVoxels.points.size(); ++i)
    closed.tips.push_back(grid.origin() + grid.voxel() * inVoxels.points[i]);
  closed.soup.points.insert(closed.soup.points.end(), closed.tips.begin(), closed.tips.end());
  closed.soup.triangles = std::move(inVoxels.triangles);
  closed.closing = closed.soup.triangles.size() - own;
  for (std::size_t i = own; i < closed.soup.triangles.size(); ++i) {
    const auto& [a, b, c] = closed.soup.triangles[i];
    if (std::max({a, b, c}) < points)
      closed.lids.push_back({closed.soup.points[a], closed.soup.points[b], closed.soup.points[c]});
  }
  return closed;
}

using Position = std::array<double, 3>;

Position positionOf(const Vec3& p, NumberType numbers) {
  const Vec3 q = rounded(p, numbers);
  return {q.x(), q.y(), q.z()};
}

std::set<Position> positionsOf(const TrianglePoints& t, NumberType numbers) {
  return {positionOf(t[0], numbers), positionOf(t[1], numbers), positionOf(t[2], numbers)};
}

// Returns how many of the first faces of a mesh close the part, in the precision of the file.
std::size_t closingFaces(const HalfEdgeMesh& mesh, std::size_t faces, const ClosedPart& closed, NumberType numbers) {
  if (closed.closing == 0) return 0;
  std::set<Position> tips;
  for (const Vec3& tip : closed.tips) tips.insert(positionOf(tip, numbers));
  std::set<std::set<Position>> lids;
  for (const TrianglePoints& lid : closed.lids) lids.insert(positionsOf(lid, numbers));
  std::size_t count = 0;
  for (Face f = 0; f < faces; ++f) {
    const std::set<Position> corners = positionsOf(mesh.points(f), numbers);
    count += lids.contains(corners) ||
             std::any_of(corners.begin(), corners.end(), [&](const Position& p) { return tips.contains(p); });
  }
  return count;
}

}  // namespace

TriangleSoup surfaceOfSweep(const HybridPart& part, const DrillRecord& hole, Progress progress) {
  const std::set<BlockKey> blocks = withBlocksBeside(part.cutBlocks());
  SparseVolume left(part.left().origin(), part.left().voxel());
  for (const BlockKey& key : blocks) left.setContent({key[0], key[1], key[2]}, {nullptr, true});
  DrillRun run(left, hole.setup);
  for (std::size_t i = 0; i < hole.poses.size() && !blocks.empty(); ++i) {
    if (!pollProgress(i, hole.poses.size(), progress.part(0.0, 0.7), kPosesPerPoll)) return {};
    move(run, hole.poses[i]);
    run.takeChangedBlocks();
  }
  SparseVolume taken(left.origin(), left.voxel());
  for (const BlockKey& key : blocks) {
    const VoxelIndex block(key[0], key[1], key[2]);
    bool isAtEnd = false;
    for (int k = 0; k < 27 && !isAtEnd; ++k) isAtEnd = !blocks.contains(blockKeyOf(besideBlock(block, k)));
    taken.setContent(block, takenOf(left.content(block), isAtEnd));
  }
  return surfaceOf(taken, progress.part(0.7, 1.0));
}

DrilledTriangles drilledTriangles(const TriangleSoup& triangles, const HybridPart& part, const DrillRecord& hole,
                                  NumberType numbers, Progress progress) {
  TriangleSoup head = surfaceOfSweep(part, hole, progress.part(0.0, 0.4));
  const ClosedPart closed = closedAsForVoxels(triangles, part.left(), progress.part(0.4, 0.45));
  DrilledTriangles done;
  for (int i = 0; i < kJoinTries && !progress.cancelled(); ++i) {
    const double from = 0.45 + 0.55 * i / kJoinTries;
    static_cast<Subtraction&>(done) =
        subtractSolid(closed.soup, head, numbers, progress.part(from, from + 0.55 / kJoinTries));
    if (done.problem != SubtractionProblem::Unsound) break;
    for (Vec3& p : head.points) p += part.left().voxel() * kJoinStep;
  }
  if (done.problem != SubtractionProblem::None) return done;
  done.kept -= closingFaces(done.mesh, done.kept, closed, numbers);
  done.closing = closed.closing;
  return done;
}

}  // namespace handwheel
