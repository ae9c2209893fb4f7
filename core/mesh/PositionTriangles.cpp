// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/PositionTriangles.h"

namespace handwheel {
namespace {

PointClasses classesOf(const HalfEdgeMesh& mesh) {
  std::vector<Vec3> points(mesh.vertexSlots());
  for (Vertex v = 0; v < points.size(); ++v) points[v] = mesh.position(v);
  return classifyPoints(points);
}

}  // namespace

PositionTriangles::PositionTriangles(const HalfEdgeMesh& mesh)
    : classes(classesOf(mesh)), triangles(mesh.faceSlots(), Triangle{0, 0, 0}) {
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    for (int k = 0; k < 3; ++k) triangles[f][k] = classes.classOf[mesh.triangle(f)[k]];
  }
}

}  // namespace handwheel
