// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/SolidUnion.h"

#include "mesh/defects/InsideOutShells.h"
#include "mesh/repair/intersections/SelfIntersectionRemoval.h"
#include "mesh/structure/PositionTriangles.h"

#include <utility>
#include <vector>

namespace handwheel {

namespace {

// Returns their number.
std::size_t removeNestedBodies(HalfEdgeMesh& mesh, Progress progress) {
  const std::vector<std::vector<Face>> nested = findNestedBodies(mesh, progress);
  for (const std::vector<Face>& body : nested)
    for (Face f : body) mesh.removeFace(f);
  return nested.size();
}

}  // namespace

std::size_t uniteSolids(HalfEdgeMesh& mesh, NumberType numbers, Progress progress) {
  HalfEdgeMesh united = mesh;
  const IntersectionRemoval done = uniteIntersecting(united, numbers, progress.part(0.0, 0.7));
  if (progress.cancelled()) return 0;
  const std::size_t removed = done.innerFaces + done.joinedFaces;
  if (!done.changed || removed == 0)
    return done.intersectionsBefore == 0 ? removeNestedBodies(mesh, progress.part(0.7, 1.0)) : 0;
  const std::size_t nested = removeNestedBodies(united, progress.part(0.9, 0.92));
  const std::size_t before = countBadEdges(mesh, progress.part(0.92, 0.96));
  if (countBadEdges(united, progress.part(0.96, 1.0)) > before || progress.cancelled()) return 0;
  mesh = std::move(united);
  return removed + nested;
}

}  // namespace handwheel
