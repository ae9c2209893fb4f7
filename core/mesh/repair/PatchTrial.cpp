// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/PatchTrial.h"

#include "mesh/holes/HoleFiller.h"
#include "mesh/repair/intersections/SelfIntersectionRemoval.h"
#include "mesh/structure/PositionTriangles.h"

#include <algorithm>

namespace handwheel {

PatchTrial tryPatches(const Submesh& part, const HalfEdgeMesh& mesh, std::span<const PatchAtLoop> patches,
                      NumberType numbers, const Progress& progress) {
  PatchTrial trial;
  trial.changed = part.mesh();
  std::vector<Face> newFaces;
  for (const PatchAtLoop& at : patches) {
    BoundaryLoop loop = *at.loop;
    for (HalfEdge& h : loop.halfEdges) {
      h = part.halfEdgeOf(mesh, h);
      if (h == kNone || part.mesh().hasOpposite(h)) trial.isOutside = true;
    }
    if (trial.isOutside) return trial;
    for (std::size_t i = 0; i < at.patch->triangles.size(); ++i)
      newFaces.push_back(static_cast<Face>(trial.changed.faceSlots() + i));
    insertPatch(trial.changed, loop, *at.patch);
  }
  if (!areFinite(trial.changed, newFaces)) return trial;
  for (const Face f : intersectionCluster(trial.changed, newFaces, numbers, progress))
    trial.reach.extend(boxOf(trial.changed.points(f)));
  const std::size_t crossings = countSelfIntersections(part.mesh(), numbers, progress);
  const IntersectionRemoval report = removeSelfIntersections(trial.changed, newFaces, numbers, crossings, progress);
  progress.spend(part.faceCount());
  if (report.intersectionsAfter > crossings) return trial;
  const std::size_t before = countBadEdges(part.mesh(), progress), after = countBadEdges(trial.changed, progress);
  if (progress.cancelled() || after >= before) return trial;
  trial.reach.extend(part.changesIn(trial.changed));
  trial.cutFaces = report.changed ? report.cutFaces : 0;
  trial.fewerCrossings = crossings - report.intersectionsAfter;
  trial.fewerBadEdges = before - after;
  trial.isSound = true;
  return trial;
}

bool areFinite(const HalfEdgeMesh& mesh, std::span<const Face> faces) {
  return std::all_of(faces.begin(), faces.end(), [&](Face f) {
    const TrianglePoints p = mesh.points(f);
    return p[0].allFinite() && p[1].allFinite() && p[2].allFinite();
  });
}

}  // namespace handwheel
