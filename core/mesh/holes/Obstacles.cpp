// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/Obstacles.h"

#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/Weld.h"
#include "proximity/SelfIntersection.h"

#include <algorithm>

namespace handwheel {
namespace {

TriangleHierarchy hierarchyOf(const HalfEdgeMesh& mesh, Progress progress) {
  TriangleSoup soup = mesh.compact().soup;
  // Faces without area cannot be crossed and are ignored.
  std::size_t kept = 0;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    if (!pollProgress(f, soup.triangles.size(), progress)) return {};
    const Triangle t = soup.triangles[f];
    if (!isDegenerate({soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]})) soup.triangles[kept++] = t;
  }
  soup.triangles.resize(kept);
  return {soup.points, soup.triangles, progress};
}

// Tests between two polls of the cancel flag: each of many flat triangles around one vertex takes long.
constexpr std::size_t kTrianglesPerPoll = 256;

}  // namespace

Obstacles::Obstacles(const HalfEdgeMesh& mesh, Progress progress) : m_hierarchy(hierarchyOf(mesh, progress)) {}

// Visits triangles near the box until the visit returns false. Returns false if it did.
template <class Visit>
bool Obstacles::forEachNear(const Box& box, Visit visit) const {
  return m_hierarchy.forEachInBox(box, [&](std::uint32_t i) { return visit(m_hierarchy.corners(i)); }) &&
         m_patches.forEachInBox(box, visit);
}

bool Obstacles::hits(const TrianglePoints& t) const {
  return !forEachNear(boxOf(t), [&](const TrianglePoints& other) { return !trianglesMeet(t, other); });
}

bool Obstacles::hits(const Patch& patch, Progress progress) const {
  const Progress around = progress.part(0.0, 0.5);
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    if (!pollProgress(i, patch.triangles.size(), around, kTrianglesPerPoll) || hits(corners(patch, patch.triangles[i])))
      return true;
  }
  const auto pairs = selfIntersections(patch.points, patch.triangles, progress.part(0.5, 1.0), 1);
  return pairs && !pairs->empty();
}

bool Obstacles::hasVertexAt(const Vec3& p) const {
  return !forEachNear(Box(p, p), [&](const TrianglePoints& t) { return std::find(t.begin(), t.end(), p) == t.end(); });
}

void Obstacles::add(const Patch& patch) {
  for (const Triangle& t : patch.triangles) m_patches.add(corners(patch, t));
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> Obstacles::edgesAmong(const std::vector<Vec3>& points) const {
  std::vector<Vec3> all = points;
  std::vector<Triangle> triangles;
  for (const Vec3& p : points) {
    forEachNear(Box(p, p), [&](const TrianglePoints& t) {
      const auto n = static_cast<std::uint32_t>(all.size());
      all.insert(all.end(), t.begin(), t.end());
      triangles.push_back({n, n + 1, n + 2});
      return true;
    });
  }
  const PointClasses classes = classifyPoints(all);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) {
      // The loop's points come first, so a class with a loop point is represented by it.
      const std::uint32_t a = classes.representative[classes.classOf[t[k]]];
      const std::uint32_t b = classes.representative[classes.classOf[t[(k + 1) % 3]]];
      if (a < points.size() && b < points.size()) edges.emplace_back(std::minmax(a, b));
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace handwheel
