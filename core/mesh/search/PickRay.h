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
  Vec3 direction = Vec3::UnitX();  // unit length

  // Returns true if origin and direction are finite and the direction is not zero.
  bool isUsable() const { return origin.allFinite() && direction.allFinite() && !direction.isZero(0.0); }
};

// The depth by which the surface must be in front of a point to hide it, in logical pixels. It is not 0, since the
// surface may bulge in front of its own edge.
inline constexpr double kPickHidingDepth = 4.0;

// The pick ray of a view, from an eye point or under parallel projection.
struct PickRay {
  Ray ray;
  std::optional<Vec3> eye;
  double pixel = 0.0;  // mm per logical pixel at the focus of the view, and everywhere under parallel projection
  double focus = 0.0;  // mm from the eye to the focus; 0: unknown, pixels then have the same size everywhere

  // Returns the size of a pixel at a point, mm.
  double pixelAt(const Vec3& p) const {
    return eye && focus > 0.0 ? pixel * std::abs((p - *eye).dot(ray.direction.stableNormalized())) / focus : pixel;
  }
};

// A projection plane perpendicular to the viewing direction. The model is projected onto it as in the view. Coordinates
// are in mm under parallel projection; in the view from an eye they are tangents of angles.
class PickRayPlane {
 public:
  using Vec2 = Eigen::Vector2d;

  // forward must be finite and not zero. Under parallel projection any point near the model serves as the origin.
  PickRayPlane(const std::optional<Vec3>& eye, const Vec3& origin, const Vec3& forward)
      : m_perspective(eye.has_value()), m_origin(eye.value_or(origin)), m_forward(forward.stableNormalized()) {
    m_right = m_forward.unitOrthogonal();
    m_up = m_forward.cross(m_right);
  }

  const Vec3& forward() const { return m_forward; }
  // Returns the depth along the viewing direction, mm.
  double depth(const Vec3& p) const { return (p - m_origin).dot(m_forward); }

  // Returns the projection of p; nothing if p is not in front of the eye.
  std::optional<Vec2> projected(const Vec3& p) const {
    const Vec3 r = p - m_origin;
    const Vec2 across(r.dot(m_right), r.dot(m_up));
    if (!m_perspective) return across;
    const double depth = r.dot(m_forward);
    if (!(depth > 0.0)) return std::nullopt;
    return Vec2(across / depth);
  }
  // Returns the common projection of all points of a viewing ray.
  std::optional<Vec2> projected(const Ray& ray) const {
    return projected(m_perspective ? Vec3(m_origin + ray.direction) : ray.origin);
  }

 private:
  bool m_perspective;
  Vec3 m_origin;
  Vec3 m_forward, m_right, m_up;
};

}  // namespace handwheel
