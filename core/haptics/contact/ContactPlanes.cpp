// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/ContactPlanes.h"

#include "haptics/contact/LineTriangleTest.h"

#include <algorithm>
#include <utility>

namespace handwheel {

void ContactPlanes::beginAt(const Vec3& position) {
  m_count = 0;
  m_position = m_met = position;
}

void ContactPlanes::add(const HalfSpace& plane, const TouchedFace& face) {
  if (m_count == kCapacity) letFirstGo();
  m_planes[m_count] = plane;
  m_faces[m_count++] = face;
}

bool ContactPlanes::contains(const HalfSpace& plane) const {
  return std::ranges::any_of(all(), [&](const HalfSpace& p) { return p.normal == plane.normal; });
}

void ContactPlanes::letFirstGo() {
  std::shift_left(m_planes.begin(), m_planes.begin() + static_cast<std::ptrdiff_t>(m_count), 1);
  std::shift_left(m_faces.begin(), m_faces.begin() + static_cast<std::ptrdiff_t>(m_count), 1);
  --m_count;
}

void ContactPlanes::moveTo(const Vec3& position, double skin) {
  const Vec3 step = position - std::exchange(m_position, position);
  if ((position - m_met).norm() <= skin) {
    for (std::size_t i = 0; i < m_count; ++i) m_planes[i].least -= m_planes[i].normal.dot(step);
    return;
  }
  keepBelow(skin);
}

void ContactPlanes::keepBelow(double skin) {
  m_met = m_position;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < m_count; ++i) {
    const Vec3 normal = m_planes[i].normal;
    const double height = normal.dot(m_position - m_faces[i].corners[0]);
    if (!(height > 0.0 && height < 2.0 * skin) || !passesThrough(m_position, normal, m_faces[i].corners)) continue;
    m_planes[kept] = {normal, skin - height};
    if (kept != i) m_faces[kept] = m_faces[i];
    ++kept;
  }
  m_count = kept;
}

}  // namespace handwheel
