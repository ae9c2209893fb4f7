// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fidelity/BumpySphere.h"

#include "fidelity/CaseShapes.h"
#include "fidelity/SeededInput.h"

#include <cmath>

namespace handwheel {
namespace {

constexpr double kSphereRadius = 38.0;  // mm
constexpr double kBumps = 0.03;         // fraction of the radius, up and down
constexpr double kBumpDepth = 0.05;     // radii below the middle of the bumps

ContactSurface bumpyBall() {
  TriangleSoup soup = sphereSoup(6, kSphereRadius);  // 81,920 faces
  for (Vec3& p : soup.points) {
    const Vec3 d = p / kSphereRadius;
    p *= 1.0 + kBumps * std::sin(9.0 * d.x()) * std::sin(8.0 * d.y() + 1.0) * std::sin(7.0 * d.z() + 2.0);
  }
  return ContactSurface(soup.points, soup.triangles);
}

}  // namespace

BumpySphere::BumpySphere(std::uint64_t seed) : m_surface(bumpyBall()) {
  const Vec3 axis = Random(seed).direction();
  m_along = axis.unitOrthogonal();
  m_across = axis.cross(m_along);
}

Vec3 BumpySphere::tipAt(double distance) const {
  const double radius = (1.0 - kBumpDepth) * kSphereRadius, angle = distance / radius;
  return radius * (std::cos(angle) * m_along + std::sin(angle) * m_across);
}

}  // namespace handwheel
