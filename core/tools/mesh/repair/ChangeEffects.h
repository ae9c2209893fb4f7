// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/defects/Defects.h"
#include "mesh/repair/FarthestRemovedVertex.h"
#include "mesh/repair/OutcomeCounts.h"
#include "mesh/search/LocalIntersections.h"
#include "mesh/selection/FaceSelection.h"
#include "mesh/structure/PositionKey.h"
#include "tools/mesh/MeshServices.h"

namespace handwheel {

// The side effects of a change of a mesh.
struct ChangeEffects {
  std::optional<IntersectionsChange> crossings;  // change of the self-intersections; none: not requested
  LoopCounts loops;                              // boundary loops closed by a fix
  std::size_t piecesGone = 0;                    // number of connected parts that a deletion removed entirely
  std::size_t facesGone = 0;
  std::set<PointKey>
      cutOff;  // corners of the pieces that a fix cut off; set from cutOffCorners() when the result has been inspected
  std::optional<FarthestRemovedVertex> removed;  // the farthest vertex that a fix removed
};

// Returns the corners of the pieces of a result that count as debris only because a change cut them from a larger body;
// each such piece still has a vertex of that body. oldDebris: the faces that were debris before the change.
std::set<PointKey> cutOffCorners(const HalfEdgeMesh& before, const FaceSelection& oldDebris,
                                 const InspectedMesh& after);

// Finds the effects of a change. areCrossingsKnown: true if the self-intersections of the mesh before the change are
// known; a fix then also reports those of the result. The effects are incomplete if cancelled.
ChangeEffects effectsOf(const MeshChange& change, const HalfEdgeMesh& before, const HalfEdgeMesh& after,
                        bool areCrossingsKnown, Progress progress = {});

}  // namespace handwheel
