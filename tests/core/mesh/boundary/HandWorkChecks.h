// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "MeshChecks.h"
#include "mesh/boundary/FaceJoining.h"
#include "mesh/structure/MeshValidator.h"

#include <string>

namespace handwheel::test {

inline FaceLocator nearFaces(const HalfEdgeMesh& mesh) {
  return {mesh, std::make_shared<FaceHierarchy>(mesh)};
}

// Returns a border half-edge that starts at this position, or kNone.
inline HalfEdge borderAt(const HalfEdgeMesh& mesh, const Vec3& p) {
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
    if (mesh.isBorder(h) && mesh.position(mesh.from(h)) == p) return h;
  return kNone;
}

// Returns the damage that a manual edit did to a mesh, or an empty string if there is none.
inline std::string worse(const HalfEdgeMesh& before, const HalfEdgeMesh& after) {
  if (const std::string broken = validate(after); !broken.empty()) return broken;
  const Edges was = countEdges(before), is = countEdges(after);
  if (is.nonManifold > was.nonManifold) return "an edge with more than two faces";
  if (is.inconsistent > was.inconsistent) return "neighbours that disagree";
  if (meetingPairs(after) > meetingPairs(before)) return "faces that cross";
  return {};
}

// Returns true if all faces except the changed ones are live as before and have the same corner positions.
inline bool othersStay(const HalfEdgeMesh& before, const HalfEdgeMesh& after, const std::vector<Face>& changed) {
  for (Face f = 0; f < before.faceSlots(); ++f) {
    if (std::find(changed.begin(), changed.end(), f) != changed.end()) continue;
    if (before.isLive(f) != after.isLive(f)) return false;
    if (!before.isLive(f)) continue;
    for (std::size_t k = 0; k < 3; ++k)
      if (!sameBits(before.points(f)[k], after.points(f)[k])) return false;
  }
  return true;
}

}  // namespace handwheel::test
