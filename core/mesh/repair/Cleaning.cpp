// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/Cleaning.h"

#include "base/Tolerance.h"
#include "mesh/boundary/BoundaryVertices.h"
#include "mesh/defects/Defects.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/EdgeOperations.h"
#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/PositionTriangles.h"

#include <algorithm>
#include <array>

namespace handwheel {
namespace {

// The half-edge opposite the middle vertex of a needle: its longest edge.
HalfEdge longestEdge(const HalfEdgeMesh& mesh, Face f) {
  const auto length = [&](HalfEdge h) {
    return (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).squaredNorm();
  };
  HalfEdge longest = 3 * f;
  for (HalfEdge h = 3 * f + 1; h < 3 * f + 3; ++h) {
    if (length(h) > length(longest)) longest = h;
  }
  return longest;
}

// Flips needles that have a neighbour at their longest edge. They may be adjacent: flipping one can free those around
// it, which are then examined again.
void flipAway(HalfEdgeMesh& mesh, const std::vector<Face>& needles) {
  const FaceSelection chosen(needles);
  std::vector<Face> waiting(needles.rbegin(), needles.rend());
  while (!waiting.empty()) {
    const Face f = waiting.back();
    waiting.pop_back();
    if (!chosen.contains(f) || !isDegenerate(mesh.points(f))) continue;
    const HalfEdge h = longestEdge(mesh, f);
    const HalfEdge across = mesh.opposite(h);
    if (!flipEdge(mesh, h)) continue;
    for (Face changed : {f, HalfEdgeMesh::face(across)}) {
      for (HalfEdge g = 3 * changed; g < 3 * changed + 3; ++g) {
        if (mesh.hasOpposite(g)) waiting.push_back(HalfEdgeMesh::face(mesh.opposite(g)));
      }
    }
  }
}

// Returns those of these degenerate faces that are chosen, or connected with a chosen one.
std::vector<Face> connectedWith(const HalfEdgeMesh& mesh, const std::vector<Face>& faces, const FaceSelection& chosen) {
  const FaceSelection all(faces);
  FaceSelection found;
  std::vector<Face> left;
  for (const Face f : faces) {
    if (chosen.contains(f)) left.push_back(f);
  }
  while (!left.empty()) {
    const Face f = left.back();
    left.pop_back();
    if (!all.contains(f) || !found.add(f)) continue;
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      if (mesh.hasOpposite(h)) left.push_back(HalfEdgeMesh::face(mesh.opposite(h)));
    }
  }
  return found.faces();
}

// Returns true if each edge of a face is open or shared with several others, and both cases occur.
bool hangsLoose(const std::array<int, 3>& facesAtEdge) {
  const auto free = std::count(facesAtEdge.begin(), facesAtEdge.end(), 1);
  const auto joined = std::count(facesAtEdge.begin(), facesAtEdge.end(), 2);
  return joined == 0 && free > 0 && free < 3;
}

}  // namespace

std::size_t removeDegenerateFaces(HalfEdgeMesh& mesh, Progress progress, const FaceSelection* only) {
  std::size_t removed = 0;
  std::vector<Face> needles;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!pollProgress(f, mesh.faceSlots(), progress.part(0.0, 0.5))) return removed;
    if (!mesh.isLive(f)) continue;
    if (!mesh.isProper(f)) {
      if (only && !only->contains(f)) continue;
      mesh.removeFace(f);
      ++removed;
    } else if (isDegenerate(mesh.points(f))) {
      needles.push_back(f);
    }
  }
  if (only) needles = connectedWith(mesh, needles, *only);
  flipAway(mesh, needles);
  removed += needles.size();
  for (Face f : needles) {
    if (isDegenerate(mesh.points(f))) mesh.removeFace(f);
  }
  if (removed > 0) relink(mesh, progress.part(0.5, 1.0));
  return removed;
}

std::size_t removeFlaps(HalfEdgeMesh& mesh, Progress progress) {
  const double limit = tolerance::kFlap * modelDiagonal(mesh);
  const PositionTriangles byPosition(mesh, progress.part(0.0, 0.2));
  std::vector<std::array<int, 3>> facesAtEdge(mesh.faceSlots());
  const EdgeTable edges(byPosition.triangles, byPosition.classes.representative.size(), progress.part(0.2, 0.4));
  const auto countFaces = [&](std::uint32_t, std::uint32_t, std::span<const EdgeTable::Entry> run) {
    for (const EdgeTable::Entry& e : run) facesAtEdge[e.halfEdge / 3][e.halfEdge % 3] = static_cast<int>(run.size());
  };
  edges.forEachEdge(countFaces, progress.part(0.4, 0.5));
  // A group that consists only of such leaves is a separate part.
  std::vector<bool> onSurface(mesh.faceSlots(), false);
  const auto findSurface = [&](std::uint32_t, std::uint32_t, std::span<const EdgeTable::Entry> run) {
    const auto isLoose = [&](const EdgeTable::Entry& e) { return hangsLoose(facesAtEdge[e.halfEdge / 3]); };
    if (std::all_of(run.begin(), run.end(), isLoose)) return;
    for (const EdgeTable::Entry& e : run) onSurface[e.halfEdge / 3] = true;
  };
  edges.forEachEdge(findSurface, progress.part(0.5, 0.6));
  std::size_t removed = 0;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!pollProgress(f, mesh.faceSlots(), progress.part(0.6, 0.7))) return removed;
    if (!mesh.isProper(f) || !hangsLoose(facesAtEdge[f]) || !onSurface[f]) continue;
    const HalfEdge h = longestEdge(mesh, f);
    if ((mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm() > limit) continue;
    mesh.removeFace(f);
    ++removed;
  }
  if (removed > 0) relink(mesh, progress.part(0.7, 1.0));
  return removed;
}

std::size_t removeDebris(HalfEdgeMesh& mesh, Progress progress) {
  std::size_t removed = 0;
  for (const Component& part : findComponents(mesh, progress)) {
    if (!part.debris) continue;
    for (Face f : part.faces) mesh.removeFace(f);
    removed += part.faces.size();
  }
  return removed;
}

std::size_t removeNewDebris(HalfEdgeMesh& mesh, const HalfEdgeMesh& before, Progress progress) {
  const auto isNew = [&](Vertex v) { return v >= before.vertexSlots(); };
  const auto isOwn = [&](Face f) {
    const Triangle t = mesh.triangle(f);
    return f >= before.faceSlots() && std::all_of(t.begin(), t.end(), isNew) && mesh.hasOpposite(3 * f) &&
           mesh.hasOpposite(3 * f + 1) && mesh.hasOpposite(3 * f + 2);
  };
  if (mesh.faceSlots() == before.faceSlots()) return 0;
  std::size_t removed = 0;
  for (const Component& part : findComponents(mesh, progress)) {
    if (!part.debris || !std::all_of(part.faces.begin(), part.faces.end(), isOwn)) continue;
    for (const Face f : part.faces) mesh.removeFace(f);
    removed += part.faces.size();
  }
  return removed;
}

}  // namespace handwheel
