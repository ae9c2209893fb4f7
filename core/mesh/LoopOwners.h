// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/BoundaryLoops.h"
#include "mesh/PlaceKey.h"

#include <map>
#include <set>
#include <vector>

namespace handwheel {

// Remembers which loop each border edge of a mesh belongs to: by the edge's face and its corner opposite, which survive
// the turning of faces, the moving of vertices and changes elsewhere; and by where its ends are, which survives the
// flipping and renumbering of faces.
class LoopOwners {
 public:
  LoopOwners(const HalfEdgeMesh& mesh, const std::vector<BoundaryLoop>& loops);

  // The loops of the remembered mesh that this loop of a later version runs along; sorted.
  std::set<int> of(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) const;

 private:
  std::map<std::pair<Face, Vertex>, int> m_byFace;
  std::map<EdgeKey, int> m_byPlace;
};

}  // namespace handwheel
