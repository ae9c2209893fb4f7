// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/Defects.h"

#include "base/Tolerance.h"
#include "mesh/BorderVertices.h"
#include "mesh/EdgeTable.h"
#include "mesh/FaceComponents.h"
#include "mesh/NonManifoldVertices.h"
#include "mesh/PositionTriangles.h"
#include "proximity/SelfIntersection.h"

#include <algorithm>

namespace handwheel {
namespace {

void findDuplicates(const std::vector<Triangle>& triangles, Defects& defects) {
  std::vector<std::pair<Triangle, Face>> sorted;
  for (Face f = 0; f < triangles.size(); ++f) {
    if (hasRepeatedVertex(triangles[f])) continue;
    Triangle t = triangles[f];
    std::sort(t.begin(), t.end());
    sorted.emplace_back(t, f);
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first == sorted[i - 1].first) defects.duplicateFaces.push_back(sorted[i].second);
  }
}

void findNonManifold(const PositionTriangles& byPosition, Defects& defects) {
  const std::vector<Vertex>& first = byPosition.classes.representative;
  const EdgeTable edges(byPosition.triangles, first.size());
  edges.forEachEdge([&](std::uint32_t low, std::uint32_t high, std::span<const EdgeTable::Entry> run) {
    if (run.size() > 2) defects.nonManifoldEdges.emplace_back(first[low], first[high]);
  });
  for (std::uint32_t c : findNonManifoldVertices(byPosition.triangles, first.size())) {
    defects.nonManifoldVertices.push_back(first[c]);
  }
}

}  // namespace

std::vector<Component> findComponents(const HalfEdgeMesh& mesh) {
  const FaceComponents parts(mesh, PositionTriangles(mesh));
  std::vector<Component> components(parts.count());
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    Component& c = components[parts.of(f)];
    const TrianglePoints p = mesh.points(f);
    c.faces.push_back(f);
    c.area += 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
  }
  std::stable_sort(components.begin(), components.end(),
                   [](const Component& a, const Component& b) { return a.area > b.area; });
  for (Component& c : components) {
    c.debris = c.area < tolerance::kDebrisArea * components.front().area &&
               static_cast<double>(c.faces.size()) <
                   tolerance::kDebrisFaces * static_cast<double>(components.front().faces.size());
  }
  return components;
}

Defects findDefects(const HalfEdgeMesh& mesh) {
  Defects defects;
  defects.loops = findBoundaryLoops(mesh);
  const PositionTriangles byPosition(mesh);
  findNonManifold(byPosition, defects);
  findDuplicates(byPosition.triangles, defects);
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (mesh.isLive(f) && isDegenerate(mesh.points(f))) defects.degenerateFaces.push_back(f);
  }
  defects.nearVertices = nearBorderVertices(mesh);
  defects.components = findComponents(mesh);
  return defects;
}

std::optional<std::vector<std::pair<Face, Face>>> findSelfIntersections(const HalfEdgeMesh& mesh, Progress progress) {
  const HalfEdgeMesh::Compact compact = mesh.compact();
  auto pairs = selfIntersections(compact.soup.points, compact.soup.triangles, progress);
  if (!pairs) return std::nullopt;
  for (auto& [a, b] : *pairs) {
    a = compact.faceOf[a];
    b = compact.faceOf[b];
  }
  return pairs;
}

}  // namespace handwheel
