// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/BoundarySnapFeatures.h"

namespace handwheel {

LoopSnapField boundarySnapFeatures(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, SnapOffer offer,
                                   Progress progress) {
  struct Loop {
    std::vector<Vec3> points;
    std::vector<std::uint32_t> vertices;
  };
  std::vector<Loop> kept(loops.size());
  std::vector<SnapLoop> snapLoops;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (const HalfEdge h : loops[i].halfEdges) {
      kept[i].vertices.push_back(mesh.from(h));
      kept[i].points.push_back(mesh.position(mesh.from(h)));
    }
    snapLoops.push_back({static_cast<std::uint32_t>(i), kept[i].points, kept[i].vertices, loops[i].halfEdges});
  }
  return snapSceneOf(snapLoops, offer, progress);
}

}  // namespace handwheel
