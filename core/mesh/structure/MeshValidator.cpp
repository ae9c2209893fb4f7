// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/MeshValidator.h"

#include "mesh/structure/CancelPolling.h"

namespace handwheel {
namespace {

const std::string kCancelled = "the check was cancelled";

std::string checkFace(const HalfEdgeMesh& mesh, Face f) {
  const auto broken = [f](const char* how) { return "face " + std::to_string(f) + how; };
  if (!mesh.isLive(f)) {
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      if (mesh.hasOpposite(h)) return broken(" is dead but has a neighbour");
    }
    return {};
  }
  for (Vertex v : mesh.triangle(f)) {
    if (v >= mesh.vertexSlots()) return broken(" has a corner out of range");
    if (!mesh.position(v).allFinite()) return broken(" has a corner that is not finite");
  }
  return {};
}

std::string checkHalfEdge(const HalfEdgeMesh& mesh, HalfEdge h) {
  if (!mesh.hasOpposite(h)) return {};
  const auto broken = [h](const char* how) { return "half-edge " + std::to_string(h) + how; };
  const HalfEdge o = mesh.opposite(h);
  if (o >= mesh.halfEdgeSlots()) return broken(" has an opposite out of range");
  if (mesh.opposite(o) != h) return broken(" is not the opposite of its opposite");
  if (!mesh.isProper(HalfEdgeMesh::face(h))) return broken(" of a face without extent has an opposite");
  if (mesh.from(h) != mesh.to(o) || mesh.to(h) != mesh.from(o)) return broken(" and its opposite join other vertices");
  if (HalfEdgeMesh::face(h) == HalfEdgeMesh::face(o)) return broken(" is opposite to its own face");
  return {};
}

// Walks once around the vertex from which h leaves, without allocating; false when another vertex is met.
bool walkFan(const HalfEdgeMesh& mesh, HalfEdge h, std::vector<bool>& seen) {
  const Vertex v = mesh.from(h);
  bool isOne = true;
  const auto visit = [&](HalfEdge g) {
    seen[g] = true;
    isOne = isOne && mesh.from(g) == v;
  };
  HalfEdge g = h;
  do {
    visit(g);
    const HalfEdge back = HalfEdgeMesh::previous(g);
    g = mesh.hasOpposite(back) ? mesh.opposite(back) : kNone;
  } while (g != kNone && g != h);
  if (g == h) return isOne;
  for (g = h; mesh.hasOpposite(g); visit(g)) g = HalfEdgeMesh::next(mesh.opposite(g));
  return isOne;
}

std::string checkFans(const HalfEdgeMesh& mesh, Progress progress) {
  std::vector<bool> seen(mesh.halfEdgeSlots(), false);
  std::vector<bool> hasFan(mesh.vertexSlots(), false);
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    if (!pollProgress(h, mesh.halfEdgeSlots(), progress)) return kCancelled;
    if (seen[h] || !mesh.isProper(HalfEdgeMesh::face(h))) continue;
    const Vertex v = mesh.from(h);
    if (hasFan[v]) return "vertex " + std::to_string(v) + " has more than one fan";
    hasFan[v] = true;
    if (!walkFan(mesh, h, seen)) return "the fan of vertex " + std::to_string(v) + " has another vertex in it";
  }
  return {};
}

}  // namespace

std::string validate(const HalfEdgeMesh& mesh, Progress progress) {
  std::size_t live = 0;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!pollProgress(f, mesh.faceSlots(), progress.part(0.0, 0.2))) return kCancelled;
    if (std::string broken = checkFace(mesh, f); !broken.empty()) return broken;
    live += mesh.isLive(f);
  }
  if (live != mesh.liveFaceCount()) return "the number of live faces is not that of the slots";
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    if (!pollProgress(h, mesh.halfEdgeSlots(), progress.part(0.2, 0.5))) return kCancelled;
    if (std::string broken = checkHalfEdge(mesh, h); !broken.empty()) return broken;
  }
  return checkFans(mesh, progress.part(0.5, 1.0));
}

}  // namespace handwheel
