// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/PositionTriangles.h"

#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/EdgeTable.h"

namespace handwheel {
namespace {

PointClasses classesOf(const HalfEdgeMesh& mesh, Progress progress) {
  std::vector<Vec3> points(mesh.vertexSlots());
  for (Vertex v = 0; v < points.size(); ++v) points[v] = mesh.position(v);
  return classifyPoints(points, progress);
}

}  // namespace

PositionTriangles::PositionTriangles(const HalfEdgeMesh& mesh, Progress progress)
    : classes(classesOf(mesh, progress.part(0.0, 0.6))), triangles(mesh.faceSlots(), Triangle{0, 0, 0}) {
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!pollProgress(f, mesh.faceSlots(), progress.part(0.6, 1.0))) return;
    if (!mesh.isLive(f)) continue;
    for (int k = 0; k < 3; ++k) triangles[f][k] = classes.classOf[mesh.triangle(f)[k]];
  }
}

std::size_t countBadEdges(const HalfEdgeMesh& mesh, Progress progress) {
  const PositionTriangles byPosition(mesh, progress.part(0.0, 0.5));
  const EdgeTable edges(byPosition.triangles, byPosition.classes.representative.size(), progress.part(0.5, 1.0));
  std::size_t bad = 0;
  edges.forEachEdge(
      [&](std::uint32_t, std::uint32_t, std::span<const EdgeTable::Entry> run) { bad += run.size() != 2; });
  return bad;
}

}  // namespace handwheel
