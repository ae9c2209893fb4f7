// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/BodyVisibility.h"

#include "document/scene/BodyDisplay.h"
#include "viewport/Viewport.h"
#include "viewport/camera/CameraNavigation.h"
#include "viewport/surface/PartsLayer.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr std::size_t kSightPoints = 60;
constexpr double kSightDepth = 2.0;  // pixels; what is less in front does not cover

}  // namespace

BodyVisibility visibilityOf(const Body& body, const Viewport& view) {
  const Vec2 size(view.width(), view.height());
  const CameraNavigation navigation(view.camera(), size);
  const std::vector<Vec3>& points = body.geometry->surface()->points;
  const std::size_t step = points.size() / kSightPoints + 1;
  const Box whole = view.bounds();
  BodyVisibility visibility = BodyVisibility::Outside;
  for (std::size_t i = 0; i < points.size(); i += step) {
    const Vec3 point = body.pose * points[i];
    if (!navigation.isBeforeEye(point)) continue;
    const Vec2 pixel = navigation.toScreen(point);
    if ((pixel.array() < 0.0).any() || (pixel.array() > size.array()).any()) continue;
    const ViewRay ray = navigation.rayAt(pixel, whole);
    const Pick first = view.pickAlong(ray.origin, ray.direction);
    const double depth = (point - ray.origin).dot(ray.direction) - kSightDepth * navigation.unitsPerPixelAt(point);
    if (first.isNothing() || first.distance >= depth || bodyOfPart(partOf(first)) == body.id)
      return BodyVisibility::Seen;
    visibility = BodyVisibility::Covered;
  }
  return visibility;
}

}  // namespace handwheel
