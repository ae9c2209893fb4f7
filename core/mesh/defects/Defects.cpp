// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/defects/Defects.h"

#include "mesh/boundary/Islands.h"
#include "mesh/boundary/Stitching.h"
#include "mesh/defects/DuplicateFaces.h"
#include "mesh/defects/InsideOutShells.h"
#include "mesh/defects/NonManifoldVertices.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/FaceComponents.h"
#include "mesh/structure/OrientationReversal.h"
#include "mesh/structure/PositionTriangles.h"
#include "proximity/SelfIntersection.h"

#include <algorithm>
#include <functional>

namespace handwheel {
namespace {

// Non-manifold edges and vertices, inconsistent faces, one-sided edges, and duplicates.
void findCrowded(const PositionTriangles& byPosition, Defects& defects, Progress progress) {
  const std::vector<Vertex>& first = byPosition.classes.representative;
  const EdgeTable edges(byPosition.triangles, first.size(), progress.part(0.0, 0.4));
  const auto findEdge = [&](std::uint32_t low, std::uint32_t high, std::span<const EdgeTable::Entry> run) {
    if (run.size() > 2) defects.nonManifoldEdges.emplace_back(first[low], first[high]);
  };
  edges.forEachEdge(findEdge, progress.part(0.4, 0.5));
  OrientationFaults faults = findOrientationFaults(edges, byPosition.triangles, progress.part(0.5, 0.5));
  defects.inconsistentFaces = std::move(faults.trianglesToReverse);
  for (const auto& [low, high] : faults.nonOrientableEdges)
    defects.nonOrientableEdges.emplace_back(first[low], first[high]);
  for (const FaceGroup& group : equalFaces(byPosition.triangles, edges, progress.part(0.5, 0.6))) {
    defects.duplicateFaces.insert(defects.duplicateFaces.end(), group.faces.begin() + 1, group.faces.end());
  }
  for (std::uint32_t c : findNonManifoldVertices(byPosition.triangles, first.size(), progress.part(0.6, 1.0))) {
    defects.nonManifoldVertices.push_back(first[c]);
  }
}

void findDegenerate(const HalfEdgeMesh& mesh, Defects& defects, Progress progress) {
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!pollProgress(f, mesh.faceSlots(), progress)) return;
    if (!mesh.isLive(f)) continue;
    const TrianglePoints p = mesh.points(f);
    defects.box.extend(p[0]).extend(p[1]).extend(p[2]);
    if (isDegenerate(p)) defects.degenerateFaces.push_back(f);
  }
}

std::vector<Component> components(const HalfEdgeMesh& mesh, const PositionTriangles& byPosition, Progress progress) {
  const FaceComponents parts(mesh, byPosition, progress.part(0.0, 0.5));
  if (progress.cancelled()) return {};
  std::vector<Component> found(parts.count());
  std::vector<Vec3> origins(parts.count());
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!pollProgress(f, mesh.faceSlots(), progress.part(0.5, 1.0))) return {};
    if (!mesh.isLive(f)) continue;
    const TrianglePoints p = mesh.points(f);
    Component& c = found[parts.of(f)];
    if (c.faceCount++ == 0) origins[parts.of(f)] = p[0];  // nearby, for the digits of a part far from the origin
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
    c.area += 0.5 * normal.norm();
    c.volume += (p[0] - origins[parts.of(f)]).dot(normal) / 6.0;
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

MeshState Defects::state(std::optional<std::size_t> selfIntersectingPairs) const {
  return {!components.empty() && loops.empty(), nonManifoldEdges.empty() && nonManifoldVertices.empty(),
          nonOrientableEdges.empty() && inconsistentFaces.empty() && insideOut.empty(), selfIntersectingPairs,
          components.size()};
}

std::size_t countDebris(std::span<const Component> components) {
  return static_cast<std::size_t>(
      std::count_if(components.begin(), components.end(), [](const Component& c) { return c.debris; }));
}

std::vector<Component> findComponents(const HalfEdgeMesh& mesh, Progress progress) {
  const PositionTriangles byPosition(mesh, progress.part(0.0, 0.5));
  if (progress.cancelled()) return {};
  return components(mesh, byPosition, progress.part(0.5, 1.0));
}

std::vector<Face> findInconsistentFaces(const HalfEdgeMesh& mesh, Progress progress) {
  const PositionTriangles byPosition(mesh, progress.part(0.0, 0.4));
  if (progress.cancelled()) return {};
  const EdgeTable edges(byPosition.triangles, byPosition.classes.representative.size(), progress.part(0.4, 0.7));
  if (progress.cancelled()) return {};
  std::vector<Face> found =
      findOrientationFaults(edges, byPosition.triangles, progress.part(0.7, 1.0)).trianglesToReverse;
  return progress.cancelled() ? std::vector<Face>() : found;
}

Defects findDefects(const HalfEdgeMesh& mesh, double nearWeld, Progress progress) {
  Defects defects;
  std::optional<PositionTriangles> byPosition;
  const std::function<void(Progress)> steps[] = {
      [&](Progress p) { byPosition.emplace(mesh, p); },
      [&](Progress p) { defects.loops = findBoundaryLoops(mesh, *byPosition, p); },
      [&](Progress p) { findCrowded(*byPosition, defects, p); },
      [&](Progress p) { findDegenerate(mesh, defects, p); },
      [&](Progress p) {
        ShellFaults faults = findShellFaults(mesh, p);
        defects.insideOut = std::move(faults.insideOut);
        defects.nestedBodies = faults.nestedBodies;
      },
      [&](Progress p) { defects.nearVertices = stitchablePairs(mesh, nearWeld, p); },
      [&](Progress p) { defects.components = components(mesh, *byPosition, p); },
      [&](Progress p) {
        if (defects.components.size() > 1) countIslands(mesh, defects.loops, p);
      },
  };
  const double share = 1.0 / static_cast<double>(std::size(steps));
  double done = 0.0;
  for (const auto& step : steps) {
    step(progress.part(done, done + share));
    progress.set(done += share);
    if (progress.cancelled()) break;
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
