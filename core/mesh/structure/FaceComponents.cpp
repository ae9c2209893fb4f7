// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/FaceComponents.h"

#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/DisjointSets.h"
#include "mesh/structure/EdgeTable.h"

namespace handwheel {

FaceComponents::FaceComponents(const HalfEdgeMesh& mesh, const PositionTriangles& byPosition, Progress progress) {
  number(byPosition.triangles, byPosition.classes.representative.size(), &mesh, progress);
}

FaceComponents::FaceComponents(const std::vector<Triangle>& triangles, std::size_t points, Progress progress) {
  number(triangles, points, nullptr, progress);
}

// mesh: whose faces count where they are live; null where all do.
void FaceComponents::number(const std::vector<Triangle>& triangles, std::size_t points, const HalfEdgeMesh* mesh,
                            Progress progress) {
  m_of.assign(triangles.size(), kNone);
  DisjointSets sets(points);
  for (Face f = 0; f < triangles.size(); ++f) {
    if (!pollProgress(f, triangles.size(), progress.part(0.0, 0.5))) return;
    const Triangle& t = triangles[f];
    if (hasRepeatedVertex(t)) continue;
    sets.join(t[0], t[1]);
    sets.join(t[1], t[2]);
  }
  std::vector<std::uint32_t> numbers(points, kNone);
  for (Face f = 0; f < triangles.size(); ++f) {
    if (!pollProgress(f, triangles.size(), progress.part(0.5, 1.0))) return;
    if (mesh && !mesh->isLive(f)) continue;
    std::uint32_t& n = numbers[sets.root(triangles[f][0])];
    if (n == kNone) n = static_cast<std::uint32_t>(m_count++);
    m_of[f] = n;
  }
}

}  // namespace handwheel
