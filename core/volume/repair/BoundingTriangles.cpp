// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/BoundingTriangles.h"

#include "volume/repair/WindingNumberFill.h"

namespace handwheel {

BoundingTriangles::BoundingTriangles(const TriangleSoup& closed, const ScanlineCrossings& alongX,
                                     const WindingNumberFill& holeFill, const Progress& progress)
    : m_isSimple(alongX.isSimple()), m_certain(closed.triangles.size(), false), m_perhaps(m_certain.size(), true) {
  add(alongX, 0, holeFill);
  TriangleSoup turned = closed;
  for (int axis = 1; axis < 3 && !m_isSimple && !progress.cancelled(); ++axis) {
    for (Vec3& p : turned.points) p = Vec3(p.y(), p.z(), p.x());
    add(ScanlineCrossings(turned, progress), axis, holeFill);
  }
  if (m_isSimple) m_perhaps.assign(m_certain.size(), true);
}

void BoundingTriangles::add(const ScanlineCrossings& rows, int turn, const WindingNumberFill& holeFill) {
  // Converts back from the rotated axes.
  const auto back = [&](const Vec3& p) { return Vec3(p[(3 - turn) % 3], p[(4 - turn) % 3], p[(5 - turn) % 3]); };
  const ScanlineCrossings::Bounding found =
      rows.boundingBy([&](const Vec3& p, int whole) { return holeFill.winding(back(p), whole); });
  for (std::size_t i = 0; i < m_certain.size(); ++i) {
    if (found.triangles[i]) m_certain[i] = true;
    if (rows.crossed()[i]) m_perhaps[i] = false;
  }
  for (const auto& [point, triangle] : found.points) m_points.emplace_back(back(point), triangle);
}

std::vector<bool> BoundingTriangles::withPerhaps(std::span<const std::uint32_t> cones) const {
  std::vector<bool> all = m_certain;
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = all[i] || m_perhaps[i];
  for (const std::uint32_t cone : cones) all[cone] = false;
  return all;
}

}  // namespace handwheel
