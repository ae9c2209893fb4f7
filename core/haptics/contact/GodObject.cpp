// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/GodObject.h"

#include "base/Tolerance.h"
#include "proximity/ClosestPoint.h"

#include <algorithm>
#include <array>

namespace handwheel {
namespace {

constexpr std::size_t kCornerPlanes = 3;  // planes that hold a point in space
constexpr double kLift = 16.0;            // skins, out of the hollows that they make at a corner
// Bounds of a tick, not fidelity settings. GodObjectCornerTest compares the corners that the proxy leaves with an exact
// walk.
constexpr std::size_t kMaxExits = 8;    // exits from a corner that are tried
constexpr std::size_t kMaxAround = 64;  // triangles around it that are looked at
constexpr int kMaxParts = 32;           // parts of the displacement after an edit; mostly one

// Shortens a step by friction (Coulomb): the force that holds the proxy back is at most µ times the one that presses it
// on, so it stays within µ times the depth of its rest position without friction.
Vec3 heldBack(const Vec3& step, const Vec3& goal, double friction) {
  const double hold = friction * (goal - step).norm();
  const double length = step.norm();
  return length <= hold ? Vec3(Vec3::Zero()) : Vec3(step * (1.0 - hold / length));
}

}  // namespace

void GodObject::place(const Vec3& tip) {
  m_contact = Contact{};
  m_contact.proxy = m_proxy = m_tip = tip;
  m_planes.beginAt(tip);
}

const Contact& GodObject::follow(const ContactSurface& surface, const Vec3& tip, const ContactOptions& options) {
  if (!tip.allFinite() || !((tip - m_proxy).squaredNorm() < 1e300)) return m_contact;
  const double skin = surface.skin();
  // The cuts of a sweep depend on the cache, and round the last digit. After a free tip, a contact is the same to that
  // digit whatever came before.
  if (!m_contact.touching) m_faces.forget();
  // The proxy mostly moves like the tip.
  if (m_faces.begin(surface, tip - m_tip)) {
    m_planes.keepBelow(skin);
  } else {
    m_planes.beginAt(m_proxy);
  }
  slide(surface, tip, options);
  m_tip = tip;
  m_contact.depth = (m_proxy - tip).norm();
  m_contact.touching = m_contact.depth > skin;
  m_contact.proxy = m_contact.touching ? m_proxy : tip;
  m_contact.normal = m_contact.touching ? Vec3((m_proxy - tip) / m_contact.depth) : Vec3(Vec3::Zero());
  return m_contact;
}

void GodObject::slide(const ContactSurface& surface, const Vec3& tip, const ContactOptions& options) {
  const double rest = options.tolerance * surface.diagonal(), skin = surface.skin();
  // When the steps are used up while it is over an edge, it falls down to the surface.
  for (int i = 0; i < options.maxSteps || (m_planes.empty() && i < 2 * options.maxSteps); ++i) {
    const Vec3 goal = tip - m_proxy;
    Vec3 step = m_planes.empty() ? goal : nearestInCone(goal, m_planes.all(), 0.25 * skin);
    if (options.friction > 0.0 && !m_planes.empty()) step = heldBack(step, goal, options.friction);
    if (step.norm() <= (m_planes.empty() ? 0.0 : rest)) {
      if (!stepOut(surface, tip, options.friction)) break;
      continue;
    }
    const NearbyTriangles::Sweep sweep = m_faces.sweep(m_proxy, step);
    const Vec3 moved = sweep.fraction * step;
    const bool arrived = sweep.fraction == 1.0 && m_planes.empty();
    m_proxy = arrived ? tip : Vec3(m_proxy + moved);
    m_planes.moveTo(m_proxy, skin);
    if (sweep.hit) {
      if (m_planes.contains(*sweep.hit)) break;
      m_planes.add(*sweep.hit, sweep.face);
    } else if (sweep.fraction < 1.0) {
      m_faces.setReach(2.0 * m_faces.reach());  // nothing in sight
    }
  }
  if (!m_planes.empty()) m_wound = m_planes.lastFace().wound;
}

// Around a corner, triangles that rise and fall leave more room than their planes together, and their skins make
// hollows of their own. So if one of the triangles that it touches has a point nearer to the tip, it is lifted off and
// goes there straight, as far as nothing blocks it.
bool GodObject::stepOut(const ContactSurface& surface, const Vec3& tip, double friction) {
  if (m_planes.size() < kCornerPlanes) return false;
  const Vec3 goal = tip - m_proxy;
  const double depth = goal.norm();
  const double skin = surface.skin(), height = kLift * skin;
  std::array<Vec3, kMaxExits> steps;
  std::size_t count = 0, looked = 0;
  const Box around(m_proxy - Vec3::Constant(height), m_proxy + Vec3::Constant(height));
  surface.forEachInBox(around, [&](const ContactTriangle& t) {
    const auto& [a, b, c] = t.corners;
    if (++looked > kMaxAround) return false;
    if ((closestOnTriangle(m_proxy, a, b, c) - m_proxy).norm() > height) return true;
    const Vec3 step = closestOnTriangle(tip, a, b, c) - m_proxy;
    if ((goal - step).norm() < depth - height) steps[count++] = heldBack(step, goal, friction);
    return count < kMaxExits;
  });
  if (count == 0) return false;
  const Vec3 lift = -height / depth * goal;
  const Vec3 above = m_proxy + m_faces.sweep(m_proxy, lift).fraction * lift;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 end = above + m_faces.sweep(above, steps[i]).fraction * steps[i];
    if ((tip - end).norm() > depth - height) continue;
    m_proxy = end;
    m_planes.moveTo(m_proxy, skin);
    return true;
  }
  return false;
}

void GodObject::surfaceChanged(const ContactSurface& surface) {
  if (!m_contact.touching) return;
  const double far = tolerance::kContactBuried * surface.diagonal();
  const Vec3 rise = far * m_contact.normal;
  m_faces.begin(surface, rise);
  // Upwards, it must not meet a surface from behind. The move is made in parts, if there are more triangles than can be
  // looked up at once.
  double gone = 0.0;
  for (int i = 0; i < kMaxParts && gone < 1.0; ++i) {
    m_faces.setReach(far);
    const NearbyTriangles::Sweep sweep = m_faces.sweep(m_proxy + gone * rise, (1.0 - gone) * rise);
    gone += sweep.fraction * (1.0 - gone);
    if (!sweep.hit) continue;
    const double steepness = std::max(-sweep.hit->normal.dot(m_contact.normal), 0.1);
    if (sweep.face.wound != m_wound) m_proxy += gone * rise + 2.0 * surface.skin() / steepness * m_contact.normal;
    break;
  }
  m_planes.beginAt(m_proxy);
}

Vec3 contactForce(const Contact& contact, const Vec3& tip, const Vec3& velocity, double stiffness, double damping) {
  if (!contact.touching) return Vec3::Zero();
  const Vec3 spring = stiffness * (contact.proxy - tip);
  const double damped = damping * velocity.dot(contact.normal);
  const double along = spring.dot(contact.normal);
  return spring - std::min(damped, along) * contact.normal;
}

}  // namespace handwheel
