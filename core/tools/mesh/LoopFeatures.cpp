// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/LoopFeatures.h"

namespace handwheel {

LoopSnapField loopFeatures(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, SnapOffer offer,
                           Progress progress) {
  struct Rim {
    std::vector<Vec3> points;
    std::vector<std::uint32_t> vertices;
  };
  std::vector<Rim> kept(loops.size());
  std::vector<SnapLoop> rims;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (const HalfEdge h : loops[i].halfEdges) {
      kept[i].vertices.push_back(mesh.from(h));
      kept[i].points.push_back(mesh.position(mesh.from(h)));
    }
    rims.push_back({static_cast<std::uint32_t>(i), kept[i].points, kept[i].vertices, loops[i].halfEdges});
  }
  return snapSceneOf(rims, offer, progress);
}

}  // namespace handwheel
