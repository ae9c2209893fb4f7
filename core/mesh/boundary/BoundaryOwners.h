// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/structure/PositionKey.h"

#include <map>
#include <set>
#include <vector>

namespace handwheel {

// Maps border edges to boundary loops across edits of the mesh. An edge is identified by its face and its corner
// opposite, which survive reversing faces, moving vertices and changes elsewhere, and by the positions of its ends,
// which survive flips and renumbering of faces.
class BoundaryOwners {
 public:
  BoundaryOwners(const HalfEdgeMesh& mesh, const std::vector<BoundaryLoop>& loops);

  // Returns the sorted ids of the original loops along which a loop of a later version runs.
  std::set<int> of(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) const;

 private:
  std::map<std::pair<Face, Vertex>, int> m_byFace;
  std::map<EdgeKey, int> m_byPosition;
};

}  // namespace handwheel
