// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/FaceComponents.h"

#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/DisjointSets.h"

namespace handwheel {

FaceComponents::FaceComponents(const HalfEdgeMesh& mesh, const PositionTriangles& byPosition, Progress progress)
    : m_of(mesh.faceSlots(), kNone) {
  const auto& [classes, triangles] = byPosition;
  DisjointSets sets(classes.representative.size());
  for (Face f = 0; f < triangles.size(); ++f) {
    if (!pollProgress(f, triangles.size(), progress.part(0.0, 0.5))) return;
    const Triangle& t = triangles[f];
    sets.join(t[0], t[1]);
    sets.join(t[1], t[2]);
  }
  std::vector<std::uint32_t> number(classes.representative.size(), kNone);
  for (Face f = 0; f < triangles.size(); ++f) {
    if (!pollProgress(f, triangles.size(), progress.part(0.5, 1.0))) return;
    if (!mesh.isLive(f)) continue;
    std::uint32_t& n = number[sets.root(triangles[f][0])];
    if (n == kNone) n = static_cast<std::uint32_t>(m_count++);
    m_of[f] = n;
  }
}

}  // namespace handwheel
