// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/ModifiedVertices.h"

#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/Weld.h"

namespace handwheel {
namespace {

bool isTurned(const TrianglePoints& was, const TrianglePoints& is) {
  return was[0] == is[0] && was[1] == is[2] && was[2] == is[1] && was != is;
}

}  // namespace

std::size_t countReversedFaces(const HalfEdgeMesh& before, const HalfEdgeMesh& after, Progress progress) {
  std::size_t reversed = 0;
  for (Face f = 0; f < before.faceSlots(); ++f) {
    if (!pollProgress(f, before.faceSlots(), progress)) return reversed;
    if (before.isLive(f) && after.isLive(f)) reversed += isTurned(before.points(f), after.points(f));
  }
  return reversed;
}

std::vector<Vertex> modifiedVertices(const HalfEdgeMesh& before, const HalfEdgeMesh& after, std::vector<Vec3> positions,
                                     Progress progress) {
  for (Vertex v = 0; v < before.vertexSlots(); ++v) {
    if (after.position(v) != before.position(v)) positions.push_back(before.position(v));
  }
  if (positions.empty()) return {};
  std::vector<Vec3> points = positions;
  for (Vertex v = 0; v < before.vertexSlots(); ++v) points.push_back(before.position(v));
  const PointClasses classes = classifyPoints(points, progress);
  if (progress.cancelled()) return {};
  std::vector<Vertex> vertices;
  for (Vertex v = 0; v < before.vertexSlots(); ++v) {
    if (classes.representative[classes.classOf[positions.size() + v]] < positions.size()) vertices.push_back(v);
  }
  return vertices;
}

}  // namespace handwheel
