// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/Defects.h"

#include "mesh/BorderVertices.h"
#include "mesh/EdgeTable.h"
#include "mesh/FaceComponents.h"
#include "mesh/NonManifoldVertices.h"
#include "mesh/PositionTriangles.h"
#include "proximity/SelfIntersection.h"

#include <algorithm>
#include <functional>

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

void findDegenerate(const HalfEdgeMesh& mesh, Defects& defects) {
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    const TrianglePoints p = mesh.points(f);
    defects.box.extend(p[0]).extend(p[1]).extend(p[2]);
    if (isDegenerate(p)) defects.degenerateFaces.push_back(f);
  }
}

std::vector<Component> components(const HalfEdgeMesh& mesh, const PositionTriangles& byPosition) {
  const FaceComponents parts(mesh, byPosition);
  std::vector<Component> found(parts.count());
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    const TrianglePoints p = mesh.points(f);
    Component& c = found[parts.of(f)];
    ++c.faceCount;
    c.area += 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
  }
  if (found.empty()) return found;
  const Component largest = *std::max_element(found.begin(), found.end(),
                                              [](const Component& a, const Component& b) { return a.area < b.area; });
  for (Component& c : found) {
    c.debris = c.area < tolerance::kDebrisArea * largest.area &&
               static_cast<double>(c.faceCount) < tolerance::kDebrisFaces * static_cast<double>(largest.faceCount);
  }
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (mesh.isLive(f) && found[parts.of(f)].debris) found[parts.of(f)].faces.push_back(f);
  }
  std::stable_sort(found.begin(), found.end(), [](const Component& a, const Component& b) { return a.area > b.area; });
  return found;
}

}  // namespace

std::vector<Component> findComponents(const HalfEdgeMesh& mesh) {
  return components(mesh, PositionTriangles(mesh));
}

Defects findDefects(const HalfEdgeMesh& mesh, double nearWeld, Progress progress) {
  Defects defects;
  const PositionTriangles byPosition(mesh);
  const std::function<void()> steps[] = {
      [&] { defects.loops = findBoundaryLoops(mesh, byPosition); },
      [&] { findNonManifold(byPosition, defects); },
      [&] { findDuplicates(byPosition.triangles, defects); },
      [&] { findDegenerate(mesh, defects); },
      [&] { defects.nearVertices = nearBorderVertices(mesh, {}, nearWeld); },
      [&] { defects.components = components(mesh, byPosition); },
  };
  double done = 1.0;  // the triangles by position
  for (const auto& step : steps) {
    progress.set(done++ / (1.0 + static_cast<double>(std::size(steps))));
    if (progress.cancelled()) break;
    step();
  }
  return defects;
}

InspectedMesh inspected(HalfEdgeMesh mesh, double nearWeld, Progress progress) {
  auto defects = std::make_shared<const Defects>(findDefects(mesh, nearWeld, progress));
  return {std::move(mesh), std::move(defects)};
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
