// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/RemovedPart.h"

#include "base/Tolerance.h"
#include "mesh/defects/Defects.h"
#include "mesh/search/SurfaceDistance.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/MeshBounds.h"

#include <vector>

namespace handwheel {
namespace {

// By vertex slot. Of no use once cancelled.
std::vector<bool> usedVertices(const HalfEdgeMesh& mesh, const Progress& progress) {
  std::vector<bool> used(mesh.vertexSlots(), false);
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!pollProgress(f, mesh.faceSlots(), progress)) return used;
    if (!mesh.isLive(f)) continue;
    for (const Vertex v : mesh.triangle(f)) used[v] = true;
  }
  return used;
}

// Without those of debris.
std::vector<Vertex> goneVertices(const HalfEdgeMesh& before, const HalfEdgeMesh& after, const Progress& progress) {
  const std::vector<bool> are = usedVertices(after, progress.part(0.0, 0.3));
  std::vector<bool> were = usedVertices(before, progress.part(0.3, 0.6));
  std::vector<Vertex> gone;
  for (Vertex v = 0; v < were.size(); ++v) {
    if (!pollProgress(v, were.size(), progress.part(0.6, 0.7))) return {};
    were[v] = were[v] && !(v < are.size() && are[v] && after.position(v) == before.position(v));
    if (were[v]) gone.push_back(v);
  }
  if (gone.empty()) return gone;
  for (const Component& piece : findComponents(before, progress.part(0.7, 1.0))) {
    if (!piece.debris) continue;
    for (const Face f : piece.faces)
      for (const Vertex v : before.triangle(f)) were[v] = false;
  }
  std::erase_if(gone, [&](Vertex v) { return !were[v]; });
  return gone;
}

}  // namespace

std::optional<RemovedPart> removedPart(const HalfEdgeMesh& before, const HalfEdgeMesh& after, Progress progress) {
  const std::vector<Vertex> gone = goneVertices(before, after, progress.part(0.0, 0.2));
  if (gone.empty() || progress.cancelled()) return std::nullopt;
  const SurfaceDistance surface(after, progress.part(0.2, 0.6));
  double distance = tolerance::kRemovedPart * diagonalOf(before);
  std::optional<RemovedPart> farthest;
  for (std::size_t i = 0; i < gone.size(); ++i) {
    if (!pollProgress(i, gone.size(), progress.part(0.6, 1.0), kSearchesPerPoll)) return std::nullopt;
    const Vec3& p = before.position(gone[i]);
    const auto nearest = surface.from(p);
    if (!nearest || nearest->distance <= distance) continue;
    distance = nearest->distance;
    farthest = {distance, p};
  }
  return farthest;
}

}  // namespace handwheel
