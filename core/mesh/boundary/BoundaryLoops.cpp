// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/BoundaryLoops.h"

#include "mesh/boundary/SheetBoundaries.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/PositionTriangles.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

namespace handwheel {
namespace {

struct ByPosition {
  bool operator()(const Vec3& a, const Vec3& b) const {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  }
};

// Cuts a closed chain wherever it returns to a position, innermost pieces first.
std::vector<std::vector<HalfEdge>> splitAtPinches(const HalfEdgeMesh& mesh, const std::vector<HalfEdge>& chain) {
  std::vector<std::vector<HalfEdge>> pieces;
  std::vector<HalfEdge> open;
  std::map<Vec3, std::size_t, ByPosition> at;  // index in the open chain of each start position
  for (HalfEdge h : chain) {
    at[mesh.position(mesh.from(h))] = open.size();
    open.push_back(h);
    const auto met = at.find(mesh.position(mesh.to(h)));
    if (met == at.end()) continue;
    const auto begin = open.begin() + static_cast<std::ptrdiff_t>(met->second);
    pieces.emplace_back(begin, open.end());
    for (HalfEdge g : pieces.back()) {
      if (g != pieces.back().front()) at.erase(mesh.position(mesh.from(g)));
    }
    at.erase(met);
    open.erase(begin, open.end());
  }
  return pieces;
}

double rmsFromBestPlane(const std::vector<Vec3>& points, const Vec3& centre) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) covariance += (p - centre) * (p - centre).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance / static_cast<double>(points.size()),
                                                              Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
}

void measure(const HalfEdgeMesh& mesh, BoundaryLoop& loop) {
  const std::vector<Vec3> points = loopPoints(mesh, loop);
  for (std::size_t i = 0; i < points.size(); ++i) {
    loop.length += (points[(i + 1) % points.size()] - points[i]).norm();
    loop.centre += points[i] / static_cast<double>(points.size());
    loop.box.extend(points[i]);
    loop.borderEdges += mesh.isBorder(loop.halfEdges[i]);
  }
  Vec3 twice = Vec3::Zero();  // the vector area (Newell)
  for (std::size_t i = 0; i < points.size(); ++i)
    twice += (points[i] - loop.centre).cross(points[(i + 1) % points.size()] - loop.centre);
  loop.area = 0.5 * twice.norm();
  loop.planarity = loop.length > 0.0 ? rmsFromBestPlane(points, loop.centre) / loop.length : 0.0;
}

}  // namespace

Vertex keyOf(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) {
  Vertex smallest = kNone;
  for (const HalfEdge h : loop.halfEdges) smallest = std::min(smallest, mesh.from(h));
  return smallest;
}

std::vector<Vec3> loopPoints(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) {
  std::vector<Vec3> points;
  points.reserve(loop.halfEdges.size());
  for (HalfEdge h : loop.halfEdges) points.push_back(mesh.position(mesh.from(h)));
  return points;
}

std::vector<BoundaryLoop> findBoundaryLoops(const HalfEdgeMesh& mesh, Progress progress) {
  const PositionTriangles byPosition(mesh, progress.part(0.0, 0.5));
  if (progress.cancelled()) return {};
  return findBoundaryLoops(mesh, byPosition, progress.part(0.5, 1.0));
}

std::vector<BoundaryLoop> findBoundaryLoops(const HalfEdgeMesh& mesh, const PositionTriangles& byPosition,
                                            Progress progress) {
  // Vertices that share a position count as the first of them.
  const auto number = [&](HalfEdge h) {
    return byPosition.classes.representative[byPosition.classes.classOf[mesh.from(h)]];
  };
  std::vector<std::pair<Vertex, BoundaryLoop>> found;  // with the smallest number
  std::vector<bool> seen(mesh.halfEdgeSlots(), false);
  for (HalfEdge start = 0; start < mesh.halfEdgeSlots(); ++start) {
    if (!pollProgress(start, mesh.halfEdgeSlots(), progress.part(0.0, 0.5))) return {};
    if (seen[start] || !mesh.isBorder(start)) continue;
    std::vector<HalfEdge> chain;
    for (HalfEdge h = start; !seen[h]; h = mesh.nextOpen(h)) {
      seen[h] = true;
      chain.push_back(h);
    }
    for (std::vector<HalfEdge>& piece : splitAtPinches(mesh, chain)) {
      BoundaryLoop loop;
      loop.halfEdges = std::move(piece);
      measure(mesh, loop);
      if (loop.borderEdges == 0) continue;
      const auto smallest = std::min_element(loop.halfEdges.begin(), loop.halfEdges.end(),
                                             [&](HalfEdge a, HalfEdge b) { return number(a) < number(b); });
      std::rotate(loop.halfEdges.begin(), smallest, loop.halfEdges.end());
      const Vertex key = number(loop.halfEdges.front());
      found.emplace_back(key, std::move(loop));
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });

  std::vector<BoundaryLoop> loops;
  for (auto& [key, loop] : found) {
    loop.id = static_cast<int>(loops.size());
    loops.push_back(std::move(loop));
  }
  markSheetBoundaries(mesh, loops, progress.part(0.5, 1.0));
  if (progress.cancelled()) return {};
  return loops;
}

}  // namespace handwheel
