// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/Picking.h"

#include <algorithm>

namespace handwheel {

namespace {

// A loop lies on the surface and is drawn this many pixels before it; the surface must be nearer than that to hide it.
constexpr double kHidingDepth = 4.0;

struct LoopCandidate {
  int loop;
  double distance;  // from the cursor, pixels
  Vec3 point;
};

// Where the segment comes nearest to the cursor on the screen, 0…1.
double nearestOnSegment(const Vec2& a, const Vec2& b, const Vec2& cursor) {
  const Vec2 along = b - a;
  const double squared = along.squaredNorm();
  return squared > 0 ? std::clamp((cursor - a).dot(along) / squared, 0.0, 1.0) : 0.0;
}

void collectNearSegments(const LoopMark& loop, const CameraNavigation& view, const Vec2& cursor,
                         std::vector<LoopCandidate>& found) {
  const std::size_t n = loop.points.size();
  if (n == 0) return;
  Vec2 a = view.toScreen(loop.points[n - 1]);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 b = view.toScreen(loop.points[i]);
    const double t = nearestOnSegment(a, b, cursor);
    const double distance = (a + t * (b - a) - cursor).norm();
    if (distance <= kLoopPickRadius) {
      const Vec3& p = loop.points[(i + n - 1) % n];
      found.push_back({loop.id, distance, p + t * (loop.points[i] - p)});
    }
    a = b;
  }
}

// A point before the whole model from which a ray along the view meets p.
Vec3 rayOrigin(const PickIndex& index, const CameraNavigation& view, const Vec3& p) {
  const Box& box = index.bounds();
  const double front = view.depth(box.center()) + box.diagonal().norm();
  return p + (front - view.depth(p)) * view.camera().towardsViewer();
}

bool isHidden(const PickIndex& index, const CameraNavigation& view, const Vec3& p) {
  const auto hit = index.firstHit(rayOrigin(index, view, p), -view.camera().towardsViewer());
  return hit && view.depth(hit->point) > view.depth(p) + kHidingDepth * view.unitsPerPixel();
}

}  // namespace

PickIndex::PickIndex(const HalfEdgeMesh& mesh) {
  HalfEdgeMesh::Compact compact = mesh.compact();
  m_hierarchy = TriangleHierarchy(compact.soup.points, compact.soup.triangles);
  m_faceOf = std::move(compact.faceOf);
  m_bounds = m_hierarchy.bounds();
}

std::optional<PickIndex::Hit> PickIndex::firstHit(const Vec3& origin, const Vec3& direction) const {
  const auto hit = m_hierarchy.firstHit(origin, direction);
  if (!hit) return std::nullopt;
  return Hit{m_faceOf[hit->triangle], origin + hit->distance * direction};
}

Pick pickAt(const PickIndex& index, const std::vector<LoopMark>& loops, const CameraNavigation& view,
            const Vec2& cursor) {
  std::vector<LoopCandidate> near;
  for (const LoopMark& loop : loops) collectNearSegments(loop, view, cursor, near);
  std::sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.distance < b.distance; });

  for (const LoopCandidate& c : near) {
    if (!isHidden(index, view, c.point)) return {c.loop, kNone, c.point};
  }
  const Vec3 origin = rayOrigin(index, view, view.fromScreen(cursor));
  const auto hit = index.firstHit(origin, -view.camera().towardsViewer());
  return hit ? Pick{-1, hit->face, hit->point} : Pick{};
}

}  // namespace handwheel
