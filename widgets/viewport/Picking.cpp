// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/Picking.h"

#include <algorithm>
#include <limits>

namespace handwheel {

namespace {

// A line lies on the surface and is drawn this many pixels before it; the surface must be nearer than that to hide it.
constexpr double kHidingDepth = 4.0;

bool isHidden(const Pickable& pickable, const CameraNavigation& view, const Vec3& p) {
  if (pickable.clip.isClippedAway(p)) return true;
  const ViewRay ray = view.rayAt(view.toScreen(p), pickable.bounds());
  const Pick hit = pickAlong(pickable, ray.origin, ray.direction);
  return !hit.isNothing() &&
         hit.distance < (p - ray.origin).dot(ray.direction) - kHidingDepth * view.unitsPerPixelAt(p);
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

Box Pickable::bounds() const {
  Box box;
  for (const ViewLayer* layer : layers) box.extend(layer->bounds());
  return box;
}

Pick pickAlong(const Pickable& pickable, const Vec3& origin, const Vec3& direction) {
  const Stretch stretch = unclipped(pickable.clip, origin, direction);
  const Vec3 start = origin + stretch.from * direction;
  Pick best;
  double least = stretch.to;
  for (const ViewLayer* layer : pickable.layers) {
    const auto hit = layer->firstHit(start, direction);
    if (!hit || stretch.from + hit->distance > least) continue;
    least = stretch.from + hit->distance;
    best = {layer, hit->element, hit->point, least};
  }
  return best;
}

Pick pickAt(const Pickable& pickable, const CameraNavigation& view, const Vec2& cursor) {
  std::vector<Pick> near;
  std::vector<LayerHit> found;
  for (const ViewLayer* layer : pickable.layers) {
    found.clear();
    layer->findNear(view, cursor, found);
    for (const LayerHit& hit : found) near.push_back({layer, hit.element, hit.point, hit.distance, true});
  }
  std::sort(near.begin(), near.end(), [](const Pick& a, const Pick& b) { return a.distance < b.distance; });
  for (const Pick& each : near) {
    if (!isHidden(pickable, view, each.point)) return each;
  }
  const ViewRay ray = view.rayAt(cursor, pickable.bounds());
  return pickAlong(pickable, ray.origin, ray.direction);
}

}  // namespace handwheel
