// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/Cleaning.h"

#include "base/Tolerance.h"
#include "mesh/BorderVertices.h"
#include "mesh/Defects.h"
#include "mesh/EdgeOperations.h"
#include "mesh/EdgeTable.h"
#include "mesh/MeshBuilder.h"
#include "mesh/PositionTriangles.h"

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

// A face that shares each of its edges with nobody or with more than one other, and some with each.
bool hangsLoose(const std::array<int, 3>& facesAtEdge) {
  const auto free = std::count(facesAtEdge.begin(), facesAtEdge.end(), 1);
  const auto joined = std::count(facesAtEdge.begin(), facesAtEdge.end(), 2);
  return joined == 0 && free > 0 && free < 3;
}

}  // namespace

std::size_t removeDegenerateFaces(HalfEdgeMesh& mesh) {
  std::size_t removed = 0;
  std::vector<Face> needles;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    if (!mesh.isProper(f)) {
      mesh.removeFace(f);
      ++removed;
    } else if (isDegenerate(mesh.points(f))) {
      needles.push_back(f);
    }
  }
  // Needles may lie side by side; flipping one can free the next.
  for (bool progress = true; progress && !needles.empty();) {
    progress = false;
    std::vector<Face> left;
    for (Face f : needles) {
      const bool flipped = flipEdge(mesh, longestEdge(mesh, f));
      removed += flipped;
      progress |= flipped;
      if (!flipped) left.push_back(f);
    }
    needles.swap(left);
  }
  for (Face f : needles) mesh.removeFace(f);
  removed += needles.size();
  if (removed > 0) relink(mesh);
  return removed;
}

std::size_t removeFlaps(HalfEdgeMesh& mesh) {
  const double limit = tolerance::kFlap * modelDiagonal(mesh);
  const PositionTriangles byPosition(mesh);
  std::vector<std::array<int, 3>> facesAtEdge(mesh.faceSlots());
  const EdgeTable edges(byPosition.triangles, byPosition.classes.representative.size());
  edges.forEachEdge([&](std::uint32_t, std::uint32_t, std::span<const EdgeTable::Entry> run) {
    for (const EdgeTable::Entry& e : run) facesAtEdge[e.halfEdge / 3][e.halfEdge % 3] = static_cast<int>(run.size());
  });
  std::size_t removed = 0;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isProper(f) || !hangsLoose(facesAtEdge[f])) continue;
    const HalfEdge h = longestEdge(mesh, f);
    if ((mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm() > limit) continue;
    mesh.removeFace(f);
    ++removed;
  }
  if (removed > 0) relink(mesh);
  return removed;
}

std::size_t removeDebris(HalfEdgeMesh& mesh) {
  std::size_t removed = 0;
  for (const Component& part : findComponents(mesh)) {
    if (!part.debris) continue;
    for (Face f : part.faces) mesh.removeFace(f);
    removed += part.faces.size();
  }
  return removed;
}

}  // namespace handwheel
