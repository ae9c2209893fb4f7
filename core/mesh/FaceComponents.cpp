// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/FaceComponents.h"

#include "mesh/DisjointSets.h"
#include "mesh/Weld.h"

namespace handwheel {

FaceComponents::FaceComponents(const HalfEdgeMesh& mesh) : m_of(mesh.faceSlots(), kNone) {
  std::vector<Vec3> points(mesh.vertexSlots());
  for (Vertex v = 0; v < points.size(); ++v) points[v] = mesh.position(v);
  const PointClasses classes = classifyPoints(points);

  DisjointSets sets(classes.representative.size());
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    const Triangle& t = mesh.triangle(f);
    sets.join(classes.classOf[t[0]], classes.classOf[t[1]]);
    sets.join(classes.classOf[t[1]], classes.classOf[t[2]]);
  }
  std::vector<std::uint32_t> number(classes.representative.size(), kNone);
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    std::uint32_t& n = number[sets.root(classes.classOf[mesh.triangle(f)[0]])];
    if (n == kNone) n = static_cast<std::uint32_t>(m_count++);
    m_of[f] = n;
  }
}

}  // namespace handwheel
