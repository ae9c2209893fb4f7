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

// What a change of a mesh brought about besides its purpose.
struct ChangeEffects {
  std::optional<IntersectionsChange> crossings;  // where they are asked for
  LoopCounts loops;                              // of a fix
  std::size_t piecesGone = 0;                    // connected parts of which nothing is left; of a deletion
  std::size_t facesGone = 0;
  std::set<PointKey> cutOff;                     // of a fix; set from cutOffCorners() when the result is inspected
  std::optional<FarthestRemovedVertex> removed;  // of a fix
};

// The corners of the pieces of a result that count as debris only since a change cut them from a larger body, of which
// they have a vertex still. oldDebris: the faces that were debris before.
std::set<PointKey> cutOffCorners(const HalfEdgeMesh& before, const FaceSelection& oldDebris,
                                 const InspectedMesh& after);

// areCrossingsKnown: of the mesh before; then a fix says those of the result. Incomplete if cancelled.
ChangeEffects effectsOf(const MeshChange& change, const HalfEdgeMesh& before, const HalfEdgeMesh& after,
                        bool areCrossingsKnown, Progress progress = {});

}  // namespace handwheel
