// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/scene/FloorDrag.h"

#include "tools/AxisDrag.h"
#include "tools/ValueSnapping.h"

#include <cmath>

namespace handwheel {

namespace {

// Sine of the angle between a ray and the horizontal plane below which a drag on the plane would run away: 15°.
constexpr double kFlatView = 0.25881904510252074;
// Slope of the rays of a drag that began at a larger angle: 3°.
constexpr double kFlatRay = 0.052335956242943835;
constexpr double kSnapPixels = 4.0;  // the least distance of two snapped positions in the view

}  // namespace

FloorDrag::FloorDrag(const Vec3& grip, const Vec3& start, const PointerEvent& press)
    : m_grip(grip),
      m_start(start),
      m_ray(press.ray),
      m_isFlatView(std::abs(press.ray.direction.z()) < kFlatView),
      m_isUpright(m_isFlatView || press.modifiers.shift) {}

std::optional<Vec3> FloorDrag::positionFor(const PointerEvent& event, const Vec3& now, double shownUnit) {
  const Ray& ray = event.ray;
  if (!ray.isUsable()) return {};
  // A click must not move anything, not even by a rounding error.
  m_hasMoved |= ray.origin != m_ray.origin || ray.direction != m_ray.direction;
  if (!m_hasMoved) return {};
  const bool isUpright = m_isFlatView || event.modifiers.shift;
  if (m_isUpright != isUpright) {  // goes on from where it is now
    m_grip += now - m_start;
    m_start = now;
    m_isUpright = isUpright;
  }
  Vec3 displacement = Vec3::Zero();
  if (m_isUpright) {
    const auto up = translationUnder({m_grip, Vec3::UnitZ(), m_grip}, ray);
    if (!up) return {};
    displacement.z() = *up;
  } else {
    const auto hit = positionUnder(m_grip, Vec3::UnitZ(), ray);
    const bool isBehind = event.eye && hit && (*hit - ray.origin).dot(ray.direction) <= 0.0;
    if (!hit || isBehind || std::abs(ray.direction.z()) < kFlatRay) return {};
    displacement.head<2>() = (*hit - m_grip).head<2>();
  }
  Vec3 position = m_start + displacement;
  const double least = kSnapPixels * event.pickRay().pixelAt(m_grip) / shownUnit;
  const bool snaps = !event.modifiers.control && std::isfinite(least) && least > 0.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const bool isStill = displacement[axis] == 0.0 || (snaps && std::abs(displacement[axis]) < 0.5 * least * shownUnit);
    if (isStill)
      position[axis] = m_start[axis];
    else if (snaps)
      position[axis] = snappedTo(position[axis] / shownUnit, least) * shownUnit;
  }
  return position;
}

}  // namespace handwheel
