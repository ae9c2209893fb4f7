// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <cmath>
#include <optional>

namespace handwheel {

// A ray with an origin and a direction.
struct Ray {
  Vec3 origin = Vec3::Zero();      // mm
  Vec3 direction = Vec3::UnitX();  // of unit length

  // Whether origin and direction are finite, and the direction is not zero.
  bool isUsable() const { return origin.allFinite() && direction.allFinite() && !direction.isZero(0.0); }
};

// The depth by which the surface must be in front of a point to hide it, since it may bulge before its own edge;
// logical pixels.
inline constexpr double kPickHidingDepth = 4.0;

// The pick ray of a view, from an eye or under parallel projection.
struct PickRay {
  Ray ray;
  std::optional<Vec3> eye;
  double pixel = 0.0;  // mm to a logical pixel at the focus of the view, and everywhere under parallel projection
  double focus = 0.0;  // mm from the eye to the focus; 0: not known, then a pixel is taken to be as large everywhere

  // mm to a pixel at a point.
  double pixelAt(const Vec3& p) const {
    return eye && focus > 0.0 ? pixel * std::abs((p - *eye).dot(ray.direction.stableNormalized())) / focus : pixel;
  }
};

// A projection plane perpendicular to the viewing direction. On it the model appears as to the viewer: in mm under
// parallel projection, as tangents of angles to an eye.
class PickRayPlane {
 public:
  using Vec2 = Eigen::Vector2d;

  // forward: finite, not zero. Under parallel projection any point near the model serves as the origin of the plane.
  PickRayPlane(const std::optional<Vec3>& eye, const Vec3& origin, const Vec3& forward)
      : m_perspective(eye.has_value()), m_origin(eye.value_or(origin)), m_forward(forward.stableNormalized()) {
    m_right = m_forward.unitOrthogonal();
    m_up = m_forward.cross(m_right);
  }

  const Vec3& forward() const { return m_forward; }
  // mm, along the viewing direction.
  double depth(const Vec3& p) const { return (p - m_origin).dot(m_forward); }

  // The projection of p; none for what is not in front of the eye.
  std::optional<Vec2> place(const Vec3& p) const {
    const Vec3 r = p - m_origin;
    const Vec2 across(r.dot(m_right), r.dot(m_up));
    if (!m_perspective) return across;
    const double depth = r.dot(m_forward);
    if (!(depth > 0.0)) return std::nullopt;
    return Vec2(across / depth);
  }
  // The projection of all points of a viewing ray.
  std::optional<Vec2> place(const Ray& ray) const {
    return place(m_perspective ? Vec3(m_origin + ray.direction) : ray.origin);
  }

 private:
  bool m_perspective;
  Vec3 m_origin;
  Vec3 m_forward, m_right, m_up;
};

}  // namespace handwheel
