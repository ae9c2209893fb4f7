// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/LinePicking.h"

#include "mesh/boundary/HolePick.h"

#include <algorithm>

namespace handwheel {

namespace {

// Returns the parameter 0…1 of the point of the segment nearest to the cursor on the screen.
double nearestOnSegment(const Vec2& a, const Vec2& b, const Vec2& cursor) {
  const Vec2 along = b - a;
  const double squared = along.squaredNorm();
  return squared > 0 ? std::clamp((cursor - a).dot(along) / squared, 0.0, 1.0) : 0.0;
}

// Returns the point of the segment that appears at the share t of its picture; under perspective the farther half is
// shorter.
Vec3 pointAt(const CameraNavigation& view, const Vec3& a, const Vec3& b, double t) {
  const double near = t * view.unitsPerPixelAt(a), far = (1.0 - t) * view.unitsPerPixelAt(b);
  return a + near / (near + far) * (b - a);
}

}  // namespace

void findNearLine(std::span<const Vec3> points, bool closed, std::uint64_t element, const CameraNavigation& view,
                  const Vec2& cursor, std::vector<LayerHit>& found) {
  const std::size_t n = points.size();
  for (std::size_t i = closed ? 0 : 1; i < n; ++i) {
    const Vec3 &p = points[(i + n - 1) % n], &q = points[i];
    if (!view.isBeforeEye(p) || !view.isBeforeEye(q)) continue;
    const Vec2 a = view.toScreen(p), b = view.toScreen(q);
    const double t = nearestOnSegment(a, b, cursor);
    const double distance = (a + t * (b - a) - cursor).norm();
    if (distance <= kHolePickRadius) found.push_back({element, pointAt(view, p, q, t), distance});
  }
}

}  // namespace handwheel
