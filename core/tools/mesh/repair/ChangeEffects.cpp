// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/repair/ChangeEffects.h"

#include "mesh/structure/FaceComponents.h"

#include <algorithm>

namespace handwheel {
namespace {

// The connected parts of a mesh of which another version has no face any more. 0 if cancelled.
std::size_t countGone(const HalfEdgeMesh& before, const HalfEdgeMesh& after, Progress progress) {
  const PositionTriangles byPosition(before, progress.part(0.0, 0.5));
  if (progress.cancelled()) return 0;
  const FaceComponents components(before, byPosition, progress.part(0.5, 1.0));
  if (progress.cancelled()) return 0;
  std::vector<bool> isLeft(components.count(), false);
  for (Face f = 0; f < before.faceSlots(); ++f)
    if (before.isLive(f) && after.isLive(f)) isLeft[components.of(f)] = true;
  return static_cast<std::size_t>(std::count(isLeft.begin(), isLeft.end(), false));
}

}  // namespace

std::set<PointKey> cutOffCorners(const HalfEdgeMesh& before, const FaceSelection& oldDebris,
                                 const InspectedMesh& after) {
  const auto wasDebris = [&](Face f) { return oldDebris.contains(f); };
  const auto isOld = [&](Vertex v) { return v < before.vertexSlots() && before.position(v) == after.mesh.position(v); };
  const auto hasOld = [&](Face f) {
    const Triangle t = after.mesh.triangle(f);
    return std::any_of(t.begin(), t.end(), isOld);
  };
  std::set<PointKey> corners;
  for (const Component& piece : after.defects->components) {
    if (!piece.debris || std::any_of(piece.faces.begin(), piece.faces.end(), wasDebris) ||
        std::none_of(piece.faces.begin(), piece.faces.end(), hasOld))
      continue;
    for (const Face f : piece.faces)
      for (const Vec3& p : after.mesh.points(f)) corners.insert(positionKey(p));
  }
  return corners;
}

ChangeEffects effectsOf(const MeshChange& change, const HalfEdgeMesh& before, const HalfEdgeMesh& after,
                        bool areCrossingsKnown, Progress progress) {
  ChangeEffects effects;
  // The list of defects need not wait until the whole surface has been searched again.
  if (change.crossed || (change.isFix && areCrossingsKnown))
    effects.crossings = intersectionsChange(before, after, progress.part(0.0, 0.5));
  if (change.isFix) {
    effects.loops = countClosed(before, after, progress.part(0.5, 0.65));
    effects.removed = farthestRemovedVertex(before, after, progress.part(0.65, 0.8));
  }
  if (change.isDeletion) effects.piecesGone = countGone(before, after, progress.part(0.8, 1.0));
  effects.facesGone = before.liveFaceCount() - std::min(before.liveFaceCount(), after.liveFaceCount());
  return effects;
}

}  // namespace handwheel
