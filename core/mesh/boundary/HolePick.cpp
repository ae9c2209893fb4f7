// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/HolePick.h"

#include "mesh/search/PointInPolygonTester.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

using Vec2 = Eigen::Vector2d;

// The loops around one line of sight, which is projected to (0, 0).
class LoopsInSight {
 public:
  LoopsInSight(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, const FaceHierarchy& faces,
               const PickRay& pickRay)
      : m_mesh(mesh),
        m_loops(loops),
        m_faces(faces),
        m_pickRay(pickRay),
        m_plane(pickRay.eye, pickRay.ray.origin, pickRay.ray.direction) {}

  std::optional<std::size_t> nearest() const {
    std::vector<Candidate> near;
    for (std::size_t i = 0; i < m_loops.size(); ++i)
      if (mayMatter(m_loops[i])) collectEdges(i, near);
    std::sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.pixels < b.pixels; });
    for (const Candidate& c : near)
      if (!m_faces.isHidden(c.point, m_pickRay.eye, m_plane.forward(), kPickHidingDepth * m_pickRay.pixelAt(c.point)))
        return c.loop;
    return std::nullopt;
  }

  std::optional<std::size_t> lookedThrough() const {
    const auto hit = m_faces.firstHit(m_pickRay.ray);
    std::optional<std::size_t> best;
    double least = 0.0;
    for (std::size_t i = 0; i < m_loops.size(); ++i) {
      const BoundaryLoop& loop = m_loops[i];
      if (loop.isSheetBoundary || !mayMatter(loop)) continue;
      if (hit && m_plane.depth(loop.centre) >= m_plane.depth(hit->point)) continue;
      const std::optional<double> area = areaAround(loop);
      if (!area || (best && *area >= least)) continue;
      best = i;
      least = *area;
    }
    return best;
  }

 private:
  struct Candidate {
    std::size_t loop;
    double pixels;  // from the line of sight
    Vec3 point;
  };

  // Returns false for loops completely beside the line of sight.
  bool mayMatter(const BoundaryLoop& loop) const {
    const Vec3 middle = loop.box.center(), r = middle - m_pickRay.ray.origin;
    const double aside = (r - m_plane.forward() * r.dot(m_plane.forward())).norm();
    const double reach = 0.5 * loop.box.diagonal().norm();
    const Vec3 farthest = middle + reach * m_plane.forward();
    return aside <= reach + kHolePickRadius * m_pickRay.pixelAt(farthest);
  }

  const Vec3& point(const BoundaryLoop& loop, std::size_t i) const {
    return m_mesh.position(m_mesh.from(loop.halfEdges[i]));
  }

  void collectEdges(std::size_t at, std::vector<Candidate>& near) const {
    const BoundaryLoop& loop = m_loops[at];
    const std::size_t n = loop.halfEdges.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 &a = point(loop, i), &b = point(loop, (i + 1) % n);
      const auto projectedA = m_plane.projected(a), projectedB = m_plane.projected(b);
      if (!projectedA || !projectedB) continue;
      const Vec2 along = *projectedB - *projectedA;
      const double squared = along.squaredNorm();
      const double t = squared > 0.0 ? std::clamp(-projectedA->dot(along) / squared, 0.0, 1.0) : 0.0;
      // In perspective the nearer half of an edge appears longer.
      const double nearA = m_pickRay.eye ? m_plane.depth(a) : 1.0, nearB = m_pickRay.eye ? m_plane.depth(b) : 1.0;
      const Vec3 p = a + t * nearA / (t * nearA + (1.0 - t) * nearB) * (b - a);
      const double apart = (*projectedA + t * along).norm() * (m_pickRay.eye ? m_plane.depth(p) : 1.0);
      if (const double pixels = apart / m_pickRay.pixelAt(p); pixels <= kHolePickRadius)
        near.push_back({at, pixels, p});
    }
  }

  // Returns the projected area of the loop; nothing if the line of sight does not pass through it.
  std::optional<double> areaAround(const BoundaryLoop& loop) const {
    std::vector<Vec2> polygon;
    for (std::size_t i = 0; i < loop.halfEdges.size(); ++i) {
      const auto projected = m_plane.projected(point(loop, i));
      if (!projected || !projected->allFinite()) return std::nullopt;
      polygon.push_back(*projected);
    }
    if (!PointInPolygonTester(polygon).contains(Vec2::Zero())) return std::nullopt;
    double doubled = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 a = polygon[i] - polygon[0], b = polygon[(i + 1) % polygon.size()] - polygon[0];
      doubled += a.x() * b.y() - b.x() * a.y();
    }
    return std::abs(doubled);
  }

  const HalfEdgeMesh& m_mesh;
  std::span<const BoundaryLoop> m_loops;
  const FaceHierarchy& m_faces;
  const PickRay& m_pickRay;
  PickRayPlane m_plane;
};

}  // namespace

std::optional<std::size_t> pickHole(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops,
                                    const FaceHierarchy& faces, const PickRay& pickRay) {
  if (!pickRay.ray.isUsable()) return std::nullopt;
  const LoopsInSight inSight(mesh, loops, faces, pickRay);
  const std::optional<std::size_t> near = inSight.nearest();
  return near ? near : inSight.lookedThrough();
}

}  // namespace handwheel
