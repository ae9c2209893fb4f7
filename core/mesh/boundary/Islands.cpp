// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/Islands.h"

#include "mesh/search/PointInPolygonTester.h"
#include "mesh/selection/RegionGrowing.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr std::size_t kMostCountedLoops = 2000;  // each is compared with each

constexpr double kBulge = 0.25;  // tolerated height above and below the hole's points, as a share of its width

// The space over and under a hole, within its outline.
class HoleSpace {
 public:
  HoleSpace(const HalfEdgeMesh& mesh, const BoundaryLoop& hole) : m_centre(hole.centre) {
    const std::vector<Vec3> points = loopPoints(mesh, hole);
    Vec3 normal = Vec3::Zero();  // twice the area that the loop encloses (Newell)
    const double size = hole.box.diagonal().norm();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3 a = (points[i] - m_centre) / size, b = (points[(i + 1) % points.size()] - m_centre) / size;
      normal += a.cross(b);
    }
    if (!(normal.norm() > 0.0)) return;
    m_normal = normal.normalized();
    m_right = m_normal.unitOrthogonal();
    m_up = m_normal.cross(m_right);
    std::vector<PointInPolygonTester::Vec2> outline;
    Eigen::AlignedBox2d across;
    for (const Vec3& p : points) {
      const double height = (p - m_centre).dot(m_normal);
      m_low = std::min(m_low, height);
      m_high = std::max(m_high, height);
      outline.push_back(projected(p));
      across.extend(outline.back());
    }
    const double bulge = kBulge * across.diagonal().norm();
    m_low -= bulge;
    m_high += bulge;
    m_outline.emplace(outline);
  }

  bool contains(const Vec3& p) const {
    if (!m_outline) return false;
    const double height = (p - m_centre).dot(m_normal);
    return height >= m_low && height <= m_high && m_outline->contains(projected(p));
  }

 private:
  PointInPolygonTester::Vec2 projected(const Vec3& p) const {
    return {(p - m_centre).dot(m_right), (p - m_centre).dot(m_up)};
  }

  Vec3 m_centre, m_normal, m_right, m_up;
  double m_low = 0.0, m_high = 0.0;
  std::optional<PointInPolygonTester> m_outline;  // none: the loop encloses nothing
};

bool liesIn(const HoleSpace& space, const HalfEdgeMesh& mesh, const FaceSelection& faces) {
  bool all = true;
  faces.forEach([&](Face f) {
    for (const Vec3& p : mesh.points(f)) all = all && space.contains(p);
  });
  return all;
}

struct Islands {
  FaceSelection faces;
  std::vector<FaceSelection> pieces;
};

Islands islandsOf(const HalfEdgeMesh& mesh, const BoundaryLoop& hole, std::span<const BoundaryLoop> loops,
                  Progress progress) {
  Islands islands;
  if (hole.isSheetBoundary) return islands;
  const HoleSpace space(mesh, hole);
  for (const BoundaryLoop& loop : loops) {
    if (progress.cancelled()) return {};
    if (loop.halfEdges == hole.halfEdges) continue;
    const bool lies = std::all_of(loop.halfEdges.begin(), loop.halfEdges.end(),
                                  [&](HalfEdge h) { return space.contains(mesh.position(mesh.from(h))); });
    const Face seed = HalfEdgeMesh::face(loop.halfEdges.front());
    if (!lies || islands.faces.contains(seed)) continue;
    const auto piece = connectedFaces(mesh, {&seed, 1}, {.progress = progress});
    if (!piece || piece->contains(HalfEdgeMesh::face(hole.halfEdges.front())) || !liesIn(space, mesh, *piece)) continue;
    const Face own = HalfEdgeMesh::face(hole.halfEdges.front());
    const auto around = connectedFaces(mesh, {&own, 1}, {.faces = piece->count() + 1, .progress = progress});
    if (!around || around->count() <= piece->count()) continue;
    islands.faces.add(*piece);
    islands.pieces.push_back(*piece);
  }
  return islands;
}

}  // namespace

FaceSelection findIslands(const HalfEdgeMesh& mesh, const BoundaryLoop& hole, std::span<const BoundaryLoop> loops,
                          Progress progress) {
  return islandsOf(mesh, hole, loops, progress).faces;
}

std::vector<const BoundaryLoop*> islandBoundaries(const HalfEdgeMesh& mesh, const BoundaryLoop& hole,
                                                  std::span<const BoundaryLoop> loops, Progress progress) {
  std::vector<const BoundaryLoop*> found;
  for (const FaceSelection& piece : islandsOf(mesh, hole, loops, progress).pieces) {
    const BoundaryLoop* longest = nullptr;
    for (const BoundaryLoop& loop : loops) {
      if (!piece.contains(HalfEdgeMesh::face(loop.halfEdges.front()))) continue;
      if (!longest || loop.length > longest->length) longest = &loop;
    }
    found.push_back(longest);
  }
  return found;
}

void countIslands(const HalfEdgeMesh& mesh, std::span<BoundaryLoop> loops, Progress progress) {
  if (loops.size() < 2 || loops.size() > kMostCountedLoops) return;
  for (BoundaryLoop& loop : loops) loop.islands = islandsOf(mesh, loop, loops, progress).pieces.size();
}

}  // namespace handwheel
