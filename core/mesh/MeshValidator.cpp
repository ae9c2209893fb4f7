// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/MeshValidator.h"

namespace handwheel {
namespace {

std::string checkFace(const HalfEdgeMesh& mesh, Face f) {
  const std::string name = "face " + std::to_string(f);
  if (!mesh.isLive(f)) {
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      if (mesh.hasOpposite(h)) return name + " is dead but has a neighbour";
    }
    return {};
  }
  for (Vertex v : mesh.triangle(f)) {
    if (v >= mesh.vertexSlots()) return name + " has a corner out of range";
    if (!mesh.position(v).allFinite()) return name + " has a corner that is not finite";
  }
  return {};
}

std::string checkHalfEdge(const HalfEdgeMesh& mesh, HalfEdge h) {
  if (!mesh.hasOpposite(h)) return {};
  const std::string name = "half-edge " + std::to_string(h);
  const HalfEdge o = mesh.opposite(h);
  if (o >= mesh.halfEdgeSlots()) return name + " has an opposite out of range";
  if (mesh.opposite(o) != h) return name + " is not the opposite of its opposite";
  if (!mesh.isProper(HalfEdgeMesh::face(h))) return name + " of a face without extent has an opposite";
  if (mesh.from(h) != mesh.to(o) || mesh.to(h) != mesh.from(o)) return name + " and its opposite join other vertices";
  if (HalfEdgeMesh::face(h) == HalfEdgeMesh::face(o)) return name + " is opposite to its own face";
  return {};
}

std::string checkFans(const HalfEdgeMesh& mesh) {
  std::vector<bool> seen(mesh.halfEdgeSlots(), false);
  std::vector<bool> hasFan(mesh.vertexSlots(), false);
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    if (seen[h] || !mesh.isProper(HalfEdgeMesh::face(h))) continue;
    const Vertex v = mesh.from(h);
    if (hasFan[v]) return "vertex " + std::to_string(v) + " has more than one fan";
    hasFan[v] = true;
    for (HalfEdge g : mesh.fan(h)) {
      if (mesh.from(g) != v) return "the fan of vertex " + std::to_string(v) + " has another vertex in it";
      seen[g] = true;
    }
  }
  return {};
}

}  // namespace

std::string validate(const HalfEdgeMesh& mesh) {
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (std::string broken = checkFace(mesh, f); !broken.empty()) return broken;
  }
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    if (std::string broken = checkHalfEdge(mesh, h); !broken.empty()) return broken;
  }
  return checkFans(mesh);
}

}  // namespace handwheel
