// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/SolidUnion.h"

#include "mesh/repair/intersections/SelfIntersectionRemoval.h"
#include "mesh/structure/PositionTriangles.h"

#include <utility>
#include <vector>

namespace handwheel {

std::size_t uniteSolids(HalfEdgeMesh& mesh, NumberType numbers, Progress progress) {
  std::vector<Face> faces;
  for (const auto& [a, b] : selfIntersectingPairs(mesh, numbers, progress.part(0.0, 0.2)))
    faces.insert(faces.end(), {a, b});
  if (faces.empty() || progress.cancelled()) return 0;
  HalfEdgeMesh united = mesh;
  const IntersectionRemoval done =
      removeAllSelfIntersections(united, faces, numbers, progress.part(0.2, 0.9), Uniting::AllSolids);
  if (!done.changed || done.innerFaces == 0) return 0;
  const std::size_t before = countBadEdges(mesh, progress.part(0.9, 0.95));
  if (countBadEdges(united, progress.part(0.95, 1.0)) > before || progress.cancelled()) return 0;
  mesh = std::move(united);
  return done.innerFaces;
}

}  // namespace handwheel
