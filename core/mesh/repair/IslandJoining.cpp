// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/IslandJoining.h"

#include "mesh/boundary/IslandBridges.h"
#include "mesh/boundary/Islands.h"

#include <algorithm>
#include <optional>

namespace handwheel {
namespace {

constexpr std::size_t kMostComparedLoops = 2000;  // each is compared with each
// Steps of WorkBudget for the search structures of a patch.
constexpr std::size_t kStepsPerFace = 2;
constexpr std::size_t kMostIslands = 100;  // in one hole; each bridge is a pass over the mesh

std::optional<BoundaryLoop> loopWith(const HalfEdgeMesh& mesh, HalfEdge h, Progress progress) {
  for (BoundaryLoop& loop : findBoundaryLoops(mesh, progress)) {
    if (std::find(loop.halfEdges.begin(), loop.halfEdges.end(), h) != loop.halfEdges.end()) return std::move(loop);
  }
  return std::nullopt;
}

// Bridges the islands one after the other, from the largest. Returns false if a bridge or the patch is not possible.
bool join(HalfEdgeMesh& mesh, const BoundaryLoop& hole, std::vector<const BoundaryLoop*> islands,
          const FillOptions& options, const Progress& progress) {
  std::stable_sort(islands.begin(), islands.end(),
                   [](const BoundaryLoop* a, const BoundaryLoop* b) { return a->length > b->length; });
  BoundaryLoop around = hole;
  progress.spend(kStepsPerFace * mesh.faceSlots());
  for (const BoundaryLoop* island : islands) {
    progress.spend(mesh.faceSlots());
    if (progress.cancelled() || !bridgeIsland(mesh, around, *island)) return false;
    // The edges at the bridge are inner ones now; others of the hole stay.
    const auto stays =
        std::find_if(hole.halfEdges.begin(), hole.halfEdges.end(), [&](HalfEdge h) { return mesh.isBorder(h); });
    if (stays == hole.halfEdges.end()) return false;
    const std::optional<BoundaryLoop> common = loopWith(mesh, *stays, progress);
    if (!common) return false;
    around = *common;
  }
  return HoleFiller(mesh, progress).propose(around, options, progress).failure == FillFailure::None;
}

}  // namespace

std::vector<std::size_t> joinIslands(HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops,
                                     const IslandChoice& choice, const FillOptions& options, Progress progress) {
  std::vector<std::size_t> joined;
  if (loops.size() < 2 || loops.size() > kMostComparedLoops) return joined;
  const HalfEdgeMesh before = mesh;
  for (std::size_t i = 0; i < loops.size() && !progress.cancelled(); ++i) {
    progress.set(static_cast<double>(i) / static_cast<double>(loops.size()));
    const BoundaryLoop& hole = loops[i];
    if (hole.isSheetBoundary || !choice.isHole(hole)) continue;
    const Progress now = progress.part(1.0, 1.0);
    std::vector<const BoundaryLoop*> islands = islandBoundaries(before, hole, loops, now);
    std::erase_if(islands, [&](const BoundaryLoop* island) {
      const auto number = static_cast<std::size_t>(island - loops.data());
      return !choice.isIsland(*island) || std::find(joined.begin(), joined.end(), number) != joined.end();
    });
    if (islands.empty() || islands.size() > kMostIslands) continue;
    HalfEdgeMesh trial = mesh;
    if (!join(trial, hole, islands, options, now)) continue;
    mesh = std::move(trial);
    for (const BoundaryLoop* island : islands) joined.push_back(static_cast<std::size_t>(island - loops.data()));
  }
  return joined;
}

}  // namespace handwheel
