// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/defects/NonManifoldEdges.h"

#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/PositionTriangles.h"

namespace handwheel {
namespace {

// Calls visit(classes, low, high, half-edges) for each edge that has more than two faces in the file.
template <class Visit>
void forEachNonManifoldEdge(const HalfEdgeMesh& mesh, Progress progress, Visit visit) {
  const PositionTriangles byPosition(mesh, progress.part(0.0, 0.4));
  const EdgeTable edges(byPosition.triangles, byPosition.classes.representative.size(), progress.part(0.4, 0.8));
  const auto visitEdge = [&](std::uint32_t low, std::uint32_t high, std::span<const EdgeTable::Entry> run) {
    if (run.size() > 2) visit(byPosition.classes, low, high, run);
  };
  edges.forEachEdge(visitEdge, progress.part(0.8, 1.0));
}

// The fans at positions of these classes.
std::map<std::uint32_t, Fans> fansIn(const HalfEdgeMesh& mesh, const std::vector<std::uint32_t>& classOf,
                                     const std::vector<bool>& wanted, Progress progress) {
  std::map<std::uint32_t, Fans> found;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    if (!pollProgress(h, mesh.halfEdgeSlots(), progress)) break;
    if (!mesh.isProper(HalfEdgeMesh::face(h))) continue;
    const Vertex v = mesh.from(h);
    if (!wanted[classOf[v]]) continue;
    std::vector<HalfEdge>& fan = found[classOf[v]][v];
    if (fan.empty()) fan = mesh.fan(h);
  }
  return found;
}

}  // namespace

std::map<std::uint32_t, Fans> nonManifoldFans(const HalfEdgeMesh& mesh, Progress progress) {
  std::vector<std::uint32_t> classOf;
  std::vector<bool> isAtEdge;
  const auto mark = [&](const PointClasses& classes, std::uint32_t low, std::uint32_t high, auto) {
    if (classOf.empty()) classOf = classes.classOf;
    isAtEdge.resize(classes.representative.size());
    isAtEdge[low] = isAtEdge[high] = true;
  };
  forEachNonManifoldEdge(mesh, progress.part(0.0, 0.8), mark);
  return isAtEdge.empty() ? std::map<std::uint32_t, Fans>() : fansIn(mesh, classOf, isAtEdge, progress.part(0.8, 1.0));
}

std::map<std::uint32_t, Fans> fansAt(const HalfEdgeMesh& mesh, const std::vector<Vertex>& vertices, Progress progress) {
  const PositionTriangles byPosition(mesh, progress.part(0.0, 0.8));
  std::vector<bool> wanted(byPosition.classes.representative.size(), false);
  if (progress.cancelled()) return {};
  for (const Vertex v : vertices) wanted[byPosition.classes.classOf[v]] = true;
  std::map<std::uint32_t, Fans> found = fansIn(mesh, byPosition.classes.classOf, wanted, progress.part(0.8, 1.0));
  std::erase_if(found, [](const auto& at) { return at.second.size() < 2; });
  return found;
}

std::vector<HalfEdge> surplusEdges(const HalfEdgeMesh& mesh, Progress progress) {
  std::vector<HalfEdge> surplus;
  forEachNonManifoldEdge(mesh, progress,
                         [&](const PointClasses&, std::uint32_t, std::uint32_t, std::span<const EdgeTable::Entry> run) {
                           bool first = true;
                           for (const EdgeTable::Entry& e : run) {
                             if (!mesh.hasOpposite(e.halfEdge) || mesh.opposite(e.halfEdge) < e.halfEdge) continue;
                             if (!first) surplus.push_back(e.halfEdge);
                             first = false;
                           }
                         });
  return surplus;
}

}  // namespace handwheel
