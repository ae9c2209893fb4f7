// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/FarthestRemovedVertex.h"

#include "base/Tolerance.h"
#include "mesh/defects/Defects.h"
#include "mesh/search/SurfaceDistance.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/MeshBounds.h"

#include <algorithm>
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

// Returns the removed vertices of "before" that are not within a distance of a remaining one, without those of debris.
std::vector<Vertex> goneVertices(const HalfEdgeMesh& before, const HalfEdgeMesh& after, double distance,
                                 const Progress& progress) {
  const std::vector<bool> are = usedVertices(after, progress.part(0.0, 0.25));
  const auto isLeft = [&](Vertex v) { return v < are.size() && are[v] && after.position(v) == before.position(v); };
  std::vector<bool> isGone = usedVertices(before, progress.part(0.25, 0.5));
  for (Vertex v = 0; v < isGone.size(); ++v) isGone[v] = isGone[v] && !isLeft(v);
  for (Face f = 0; f < before.faceSlots(); ++f) {
    if (!pollProgress(f, before.faceSlots(), progress.part(0.5, 0.7))) return {};
    if (!before.isLive(f)) continue;
    const Triangle t = before.triangle(f);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex v = t[i];
      if (!isGone[v]) continue;
      for (const Vertex w : {t[(i + 1) % 3], t[(i + 2) % 3]})
        if (isLeft(w) && (before.position(w) - before.position(v)).norm() <= distance) isGone[v] = false;
    }
  }
  if (std::find(isGone.begin(), isGone.end(), true) == isGone.end()) return {};
  for (const Component& piece : findComponents(before, progress.part(0.7, 1.0))) {
    if (!piece.debris) continue;
    for (const Face f : piece.faces)
      for (const Vertex v : before.triangle(f)) isGone[v] = false;
  }
  std::vector<Vertex> gone;
  for (Vertex v = 0; v < isGone.size(); ++v)
    if (isGone[v]) gone.push_back(v);
  return gone;
}

}  // namespace

std::optional<FarthestRemovedVertex> farthestRemovedVertex(const HalfEdgeMesh& before, const HalfEdgeMesh& after,
                                                           Progress progress) {
  double distance = tolerance::kRemovedPart * diagonalOf(before);
  const std::vector<Vertex> gone = goneVertices(before, after, distance, progress.part(0.0, 0.2));
  if (gone.empty() || progress.cancelled()) return std::nullopt;
  const SurfaceDistance surface(after, progress.part(0.2, 0.6));
  std::optional<FarthestRemovedVertex> farthest;
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
