// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/Picking.h"

#include "mesh/boundary/HolePick.h"

#include <algorithm>
#include <limits>

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

// The point of the segment that appears at the share t of its picture; under perspective the farther half is shorter.
Vec3 pointAt(const CameraNavigation& view, const Vec3& a, const Vec3& b, double t) {
  const double near = t * view.unitsPerPixelAt(a), far = (1.0 - t) * view.unitsPerPixelAt(b);
  return a + near / (near + far) * (b - a);
}

void collectNearSegments(const LoopMark& loop, const CameraNavigation& view, const Vec2& cursor,
                         std::vector<LoopCandidate>& found) {
  const std::size_t n = loop.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 &p = loop.points[(i + n - 1) % n], &q = loop.points[i];
    if (!view.isBeforeEye(p) || !view.isBeforeEye(q)) continue;
    const Vec2 a = view.toScreen(p), b = view.toScreen(q);
    const double t = nearestOnSegment(a, b, cursor);
    const double distance = (a + t * (b - a) - cursor).norm();
    if (distance <= kHolePickRadius) found.push_back({loop.id, distance, pointAt(view, p, q, t)});
  }
}

bool isHidden(const Pickable& pickable, const CameraNavigation& view, const Vec3& p) {
  if (pickable.clip.isClippedAway(p)) return true;
  const ViewRay ray = view.rayAt(view.toScreen(p), pickable.bounds());
  const auto hit = firstSurface(pickable, ray.origin, ray.direction);
  return hit && hit->distance < (p - ray.origin).dot(ray.direction) - kHidingDepth * view.unitsPerPixelAt(p);
}

// The stretch of a ray that is not clipped away; from > to when there is none.
struct Stretch {
  double from = 0.0;
  double to = std::numeric_limits<double>::infinity();
};

Stretch unclipped(const ClipPlane& clip, const Vec3& origin, const Vec3& direction) {
  Stretch s;
  if (!clip.on) return s;
  const double room = clip.offset - clip.normal.dot(origin), slope = clip.normal.dot(direction);
  if (slope > 0) s.to = room / slope;
  if (slope < 0) s.from = std::max(room / slope, 0.0);
  if (slope == 0 && room < 0) s.to = -1.0;
  return s;
}

}  // namespace

PickIndex::PickIndex(const HalfEdgeMesh& mesh) {
  HalfEdgeMesh::Compact compact = mesh.compact();
  m_hierarchy = TriangleHierarchy(compact.soup.points, compact.soup.triangles);
  m_faceOf = std::move(compact.faceOf);
}

std::optional<PickIndex::Hit> PickIndex::firstHit(const Vec3& origin, const Vec3& direction) const {
  const auto hit = m_hierarchy.firstHit(origin, direction);
  if (!hit) return std::nullopt;
  return Hit{m_faceOf[hit->triangle], hit->distance};
}

Vec3 PickIndex::normalNear(const Vec3& p) const {
  const auto nearest = m_hierarchy.nearest(p);
  if (!nearest) return Vec3::Zero();
  const auto [a, b, c] = m_hierarchy.corners(nearest->triangle);
  return (b - a).cross(c - a).normalized();
}

Box Pickable::bounds() const {
  Box box;
  if (mesh) box.extend(mesh->bounds());
  for (const PickPart& part : parts) {
    if (part.index->bounds().isEmpty()) continue;
    for (const Vec3& corner : cornersOf(part.index->bounds())) box.extend(part.pose * corner);
  }
  return box;
}

std::optional<SurfaceHit> firstSurface(const Pickable& pickable, const Vec3& origin, const Vec3& direction) {
  const Stretch stretch = unclipped(pickable.clip, origin, direction);
  const Vec3 start = origin + stretch.from * direction;
  SurfaceHit best;
  best.distance = stretch.to;
  bool isHit = false;
  const auto consider = [&](const std::optional<PickIndex::Hit>& hit, const PickPart* part) {
    if (!hit || stretch.from + hit->distance > best.distance) return;
    best = {part ? kNone : hit->face, part, start + hit->distance * direction, stretch.from + hit->distance};
    isHit = true;
  };
  if (pickable.mesh) consider(pickable.mesh->firstHit(start, direction), nullptr);
  for (const PickPart& part : pickable.parts) {
    const Pose inverse = part.pose.inverse();
    consider(part.index->firstHit(inverse * start, inverse.linear() * direction), &part);
  }
  if (!isHit) return std::nullopt;
  return best;
}

Pick pickAlong(const Pickable& pickable, const Vec3& origin, const Vec3& direction) {
  const auto hit = firstSurface(pickable, origin, direction);
  if (!hit) return {};
  return {-1, hit->face, hit->point, hit->part ? hit->part->name : std::string()};
}

Pick pickAt(const Pickable& pickable, const CameraNavigation& view, const Vec2& cursor) {
  std::vector<LoopCandidate> near;
  for (const LoopMark& loop : pickable.loops) collectNearSegments(loop, view, cursor, near);
  std::sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.distance < b.distance; });

  for (const LoopCandidate& c : near) {
    if (!isHidden(pickable, view, c.point)) return {c.loop, kNone, c.point, {}};
  }
  const ViewRay ray = view.rayAt(cursor, pickable.bounds());
  return pickAlong(pickable, ray.origin, ray.direction);
}

}  // namespace handwheel
