// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/GodObject.h"

#include "base/Tolerance.h"
#include "haptics/LocalFaces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {
namespace {

// Beyond so many planes at one place the oldest are forgotten; they are met again where they matter.
constexpr std::size_t kMaxPlanes = 8;
constexpr std::size_t kCornerPlanes = 3;  // that hold a point in space

// The planes that are met at one place.
class Planes {
 public:
  void clear() { m_count = 0; }
  bool empty() const { return m_count == 0; }
  std::size_t size() const { return m_count; }
  std::span<const HalfSpace> all() const { return {m_planes.data(), m_count}; }

  void add(const HalfSpace& plane) {
    if (m_count == kMaxPlanes) release();
    m_planes[m_count++] = plane;
  }
  bool contains(const HalfSpace& plane) const {
    const auto same = [&](const HalfSpace& p) { return p.normal == plane.normal; };
    return std::any_of(m_planes.begin(), m_planes.begin() + static_cast<std::ptrdiff_t>(m_count), same);
  }
  // Lets the plane go that was met first.
  void release() {
    std::move(m_planes.begin() + 1, m_planes.begin() + static_cast<std::ptrdiff_t>(m_count), m_planes.begin());
    --m_count;
  }
  // The place has moved by so little that they still stand.
  void shift(const Vec3& step) {
    for (std::size_t i = 0; i < m_count; ++i) m_planes[i].least -= m_planes[i].normal.dot(step);
  }

 private:
  std::array<HalfSpace, kMaxPlanes> m_planes;
  std::size_t m_count = 0;
};

// Coulomb: what holds the proxy back is at most µ times what presses it on, so it stays within µ times the depth of
// where it would rest without friction.
Vec3 heldBack(const Vec3& step, const Vec3& goal, double friction) {
  const double hold = friction * (goal - step).norm();
  const double length = step.norm();
  return length <= hold ? Vec3(Vec3::Zero()) : Vec3(step * (1.0 - hold / length));
}

}  // namespace

void GodObject::place(const Vec3& tip) {
  m_contact = Contact{};
  m_contact.proxy = m_proxy = m_tip = tip;
  m_fit = 0.0;
}

const Contact& GodObject::follow(const ContactSurface& surface, const Vec3& tip, const ContactOptions& options) {
  if (!tip.allFinite() || !((tip - m_proxy).squaredNorm() < 1e300)) return m_contact;
  // The proxy mostly goes as the tip does.
  LocalFaces faces(surface, tip - m_tip);
  const double ahead = (tip - m_tip).norm();
  faces.setReach(m_fit > 0.0 ? std::min(m_fit, ahead) : ahead);
  slide(faces, tip, options, options.tolerance * surface.diagonal(), surface.skin());
  m_fit = faces.crowded() ? faces.reach() : std::max(1.25 * m_fit, faces.reach());
  m_tip = tip;
  m_contact.depth = (m_proxy - tip).norm();
  m_contact.touching = m_contact.depth > surface.skin();
  m_contact.proxy = m_contact.touching ? m_proxy : tip;
  m_contact.normal = m_contact.touching ? Vec3((m_proxy - tip) / m_contact.depth) : Vec3(Vec3::Zero());
  return m_contact;
}

void GodObject::slide(LocalFaces& faces, const Vec3& tip, const ContactOptions& options, double rest, double skin) {
  Planes planes;
  std::size_t released = 0;  // at this place
  m_contact.triangle = kNone;
  // When the steps are used up while it is over an edge, it falls down to the surface.
  for (int i = 0; i < options.maxSteps || (planes.empty() && i < 2 * options.maxSteps); ++i) {
    const Vec3 goal = tip - m_proxy;
    Vec3 step = planes.empty() ? goal : nearestInCone(goal, planes.all(), 0.25 * skin);
    if (options.friction > 0.0 && !planes.empty()) step = heldBack(step, goal, options.friction);
    if (step.norm() <= rest) {
      // Where triangles rise and fall around a corner, their planes together leave less room than they do themselves:
      // it is held only if each plane holds it that the others would let go.
      if (planes.size() < kCornerPlanes || released == planes.size()) break;
      planes.release();
      ++released;
      continue;
    }
    const LocalFaces::Sweep sweep = faces.sweep(m_proxy, step);
    const Vec3 moved = sweep.fraction * step;
    const bool arrived = sweep.fraction == 1.0 && planes.empty();
    m_proxy = arrived ? tip : Vec3(m_proxy + moved);
    if (moved.norm() > skin) {
      planes.clear();
      released = 0;
    } else {
      planes.shift(moved);
    }
    if (sweep.hit) {
      if (planes.contains(*sweep.hit)) break;
      planes.add(*sweep.hit);
      m_contact.triangle = sweep.triangle;
      m_wound = sweep.wound;
    } else if (sweep.fraction < 1.0) {
      faces.setReach(2.0 * faces.reach());  // nothing in sight
    }
  }
}

void GodObject::surfaceChanged(const ContactSurface& surface) {
  if (!m_contact.touching) return;
  const double far = tolerance::kContactBuried * surface.diagonal();
  LocalFaces faces(surface, far * m_contact.normal);
  faces.setReach(far);
  // Upwards, it must not meet a surface from behind.
  const LocalFaces::Sweep sweep = faces.sweep(m_proxy, far * m_contact.normal);
  if (!sweep.hit || sweep.wound == m_wound) return;
  const double steepness = std::max(-sweep.hit->normal.dot(m_contact.normal), 0.1);
  m_proxy += (sweep.fraction * far + 2.0 * surface.skin() / steepness) * m_contact.normal;
}

Vec3 contactForce(const Contact& contact, const Vec3& tip, const Vec3& velocity, double stiffness, double damping) {
  if (!contact.touching) return Vec3::Zero();
  const Vec3 spring = stiffness * (contact.proxy - tip);
  const double damped = damping * velocity.dot(contact.normal);
  const double along = spring.dot(contact.normal);
  return spring - std::min(damped, along) * contact.normal;
}

}  // namespace handwheel
