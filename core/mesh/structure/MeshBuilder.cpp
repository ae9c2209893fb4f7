// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/MeshBuilder.h"

#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/EdgePairing.h"
#include "mesh/structure/Orientation.h"
#include "mesh/structure/Weld.h"

#include <map>
#include <numeric>

namespace handwheel {
namespace {

// Gives every fan of faces a vertex of its own. Works on a mesh whose opposites are set and whose corners still hold
// the old vertices; classOf tells which vertices share a position.
class FanVertices {
 public:
  FanVertices(HalfEdgeMesh& mesh, const PointClasses& classes, Progress progress)
      : m_mesh(mesh),
        m_classes(classes),
        m_progress(progress),
        m_taken(mesh.vertexSlots(), false),
        m_seen(mesh.halfEdgeSlots(), false) {}

  // Vertices that had to be added or changed hands because a position has more than one fan.
  std::vector<Vertex> assign() {
    std::vector<std::vector<HalfEdge>> homeless;  // fans whose vertices were all taken
    for (HalfEdge h = 0; h < m_mesh.halfEdgeSlots(); ++h) {
      if (!pollProgress(h, m_mesh.halfEdgeSlots(), m_progress)) return {};
      if (m_seen[h] || !m_mesh.isProper(HalfEdgeMesh::face(h))) continue;
      std::vector<HalfEdge> fan = m_mesh.fan(h);
      for (HalfEdge g : fan) m_seen[g] = true;
      if (!settle(fan)) homeless.push_back(std::move(fan));
    }
    const std::map<std::uint32_t, std::vector<Vertex>> spare = spareVertices(homeless);
    std::map<std::uint32_t, std::size_t> used;
    std::vector<Vertex> added;
    for (const auto& fan : homeless) {
      const std::uint32_t c = classOf(fan);
      const std::vector<Vertex>& free = spare.at(c);
      if (used[c] < free.size()) {
        take(fan, free[used[c]++]);
        continue;
      }
      // A copy: the position lies in the array that addVertex() grows.
      const Vec3 p = m_mesh.position(m_mesh.from(fan.front()));
      added.push_back(m_mesh.addVertex(p));
      for (HalfEdge g : fan) m_mesh.setCorner(g, added.back());
    }
    return added;
  }

 private:
  std::uint32_t classOf(const std::vector<HalfEdge>& fan) const { return m_classes.classOf[m_mesh.from(fan.front())]; }

  // Keeps the first vertex that the fan's corners use and no other fan has taken.
  bool settle(const std::vector<HalfEdge>& fan) {
    for (HalfEdge g : fan) {
      if (!m_taken[m_mesh.from(g)]) {
        take(fan, m_mesh.from(g));
        return true;
      }
    }
    return false;
  }

  void take(const std::vector<HalfEdge>& fan, Vertex v) {
    m_taken[v] = true;
    for (HalfEdge g : fan) m_mesh.setCorner(g, v);
  }

  // The vertices that no fan has taken, at the positions of these fans.
  std::map<std::uint32_t, std::vector<Vertex>> spareVertices(const std::vector<std::vector<HalfEdge>>& fans) const {
    std::map<std::uint32_t, std::vector<Vertex>> spare;
    for (const auto& fan : fans) spare[classOf(fan)];
    if (spare.empty()) return spare;
    for (Vertex v = 0; v < m_taken.size(); ++v) {
      if (m_taken[v]) continue;
      const auto at = spare.find(m_classes.classOf[v]);
      if (at != spare.end()) at->second.push_back(v);
    }
    return spare;
  }

  HalfEdgeMesh& m_mesh;
  const PointClasses& m_classes;
  Progress m_progress;
  std::vector<bool> m_taken;
  std::vector<bool> m_seen;
};

// Reverses triangles where neighbours disagree, in the mesh and in the list over positions.
std::vector<Face> orient(HalfEdgeMesh& mesh, std::vector<Triangle>& triangles, const EdgeTable& edges,
                         Progress progress) {
  const std::vector<bool> turn = trianglesToReverse(edges, triangles, progress);
  std::vector<Face> reversedFaces;
  if (progress.cancelled()) return reversedFaces;
  for (Face f = 0; f < triangles.size(); ++f) {
    if (!turn[f]) continue;
    triangles[f] = reversed(triangles[f]);
    mesh.setTriangle(f, reversed(mesh.triangle(f)));
    reversedFaces.push_back(f);
  }
  return reversedFaces;
}

enum class Directions { Agreeing, AsGiven };

// The result is incomplete once cancelled.
BuildReport link(HalfEdgeMesh& mesh, const PointClasses& classes, std::span<const Vec3> points, Directions directions,
                 Progress progress) {
  BuildReport report;
  report.weldedPoints = points.size() - classes.representative.size();
  // Triangles over the first vertex at each position; dead slots look like triangles with a repeated vertex.
  std::vector<Triangle> triangles(mesh.faceSlots(), Triangle{0, 0, 0});
  for (Face f = 0; f < triangles.size(); ++f) {
    if (!pollProgress(f, triangles.size(), progress.part(0.0, 0.1))) return report;
    if (!mesh.isLive(f)) continue;
    for (int k = 0; k < 3; ++k) triangles[f][k] = classes.representative[classes.classOf[mesh.triangle(f)[k]]];
  }
  EdgeTable edges(triangles, points.size(), progress.part(0.1, 0.3));
  if (progress.cancelled()) return report;
  if (directions == Directions::Agreeing)
    report.reversedFaces = orient(mesh, triangles, edges, progress.part(0.3, 0.45));
  if (!report.reversedFaces.empty()) edges = EdgeTable(triangles, points.size(), progress.part(0.45, 0.6));
  if (progress.cancelled()) return report;

  const PairedEdges paired = pairEdges(edges, triangles, points, progress.part(0.6, 0.7));
  report.nonManifoldEdges = paired.nonManifoldEdges;
  report.unpairedHalfEdges = paired.seams;
  if (progress.cancelled()) return report;
  for (Face f = 0; f < triangles.size(); ++f) {
    if (!pollProgress(f, triangles.size(), progress.part(0.7, 0.8))) return report;
    if (!mesh.isLive(f)) continue;
    // A face that welding made degenerate connects nothing, as its corners show.
    if (hasRepeatedVertex(triangles[f])) mesh.setTriangle(f, triangles[f]);
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) mesh.setOpposite(h, paired.opposite[h]);
  }
  report.splitVertices = FanVertices(mesh, classes, progress.part(0.8, 1.0)).assign();
  progress.set(1.0);
  return report;
}

BuildReport relinkAs(HalfEdgeMesh& mesh, Directions directions, Progress progress) {
  std::vector<Vec3> points(mesh.vertexSlots());
  for (Vertex v = 0; v < points.size(); ++v) points[v] = mesh.position(v);
  const PointClasses classes = classifyPoints(points, progress.part(0.0, 0.2));
  if (progress.cancelled()) return {};
  HalfEdgeMesh linked = mesh;
  BuildReport report = link(linked, classes, points, directions, progress.part(0.2, 1.0));
  if (progress.cancelled()) return {};
  mesh = std::move(linked);
  return report;
}

}  // namespace

BuildReport relink(HalfEdgeMesh& mesh, Progress progress) {
  return relinkAs(mesh, Directions::Agreeing, progress);
}

void reverseFaces(HalfEdgeMesh& mesh, std::span<const Face> faces, Progress progress) {
  HalfEdgeMesh turned = mesh;
  for (const Face f : faces) turned.setTriangle(f, reversed(turned.triangle(f)));
  relinkAs(turned, Directions::AsGiven, progress);
  if (!progress.cancelled()) mesh = std::move(turned);
}

BuiltMesh buildMesh(const TriangleSoup& soup, Progress progress) {
  BuiltMesh built;
  const TriangleSoup welded = weld(soup, progress.part(0.0, 0.2));
  if (progress.cancelled()) return built;
  for (const Vec3& p : welded.points) built.mesh.addVertex(p);
  for (const Triangle& t : welded.triangles) {
    if (!pollProgress(built.mesh.faceSlots(), welded.triangles.size(), progress.part(0.2, 0.3))) return {};
    built.mesh.addFace(t);
  }
  PointClasses each;  // no two of them share a position
  each.classOf.resize(welded.points.size());
  std::iota(each.classOf.begin(), each.classOf.end(), 0u);
  each.representative = each.classOf;
  built.report = link(built.mesh, each, welded.points, Directions::Agreeing, progress.part(0.3, 1.0));
  if (progress.cancelled()) return {};
  built.report.weldedPoints = soup.points.size() - welded.points.size();
  return built;
}

}  // namespace handwheel
