// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/FaceComponents.h"

#include "mesh/DisjointSets.h"
#include "mesh/PositionTriangles.h"

namespace handwheel {

FaceComponents::FaceComponents(const HalfEdgeMesh& mesh) : m_of(mesh.faceSlots(), kNone) {
  const auto [classes, triangles] = PositionTriangles(mesh);
  DisjointSets sets(classes.representative.size());
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    sets.join(triangles[f][0], triangles[f][1]);
    sets.join(triangles[f][1], triangles[f][2]);
  }
  std::vector<std::uint32_t> number(classes.representative.size(), kNone);
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    std::uint32_t& n = number[sets.root(triangles[f][0])];
    if (n == kNone) n = static_cast<std::uint32_t>(m_count++);
    m_of[f] = n;
  }
}

}  // namespace handwheel
