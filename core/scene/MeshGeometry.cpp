// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/MeshGeometry.h"

#include <algorithm>
#include <cassert>

namespace handwheel {

MeshGeometry::MeshGeometry(TriangleSoup soup) : m_soup(std::make_shared<const TriangleSoup>(std::move(soup))) {
  assert(isSoundSoup(*m_soup));
}

std::size_t MeshGeometry::bytes() const {
  return m_soup->points.size() * sizeof(Vec3) + m_soup->triangles.size() * sizeof(Triangle);
}

bool isSoundSoup(const TriangleSoup& soup) {
  const auto isNear = [](const Vec3& p) {
    return p.allFinite() && p.cwiseAbs().maxCoeff() <= MeshGeometry::kLargestCoordinate;
  };
  const auto isInRange = [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t corner) { return corner < soup.points.size(); });
  };
  return !soup.triangles.empty() && std::all_of(soup.points.begin(), soup.points.end(), isNear) &&
         std::all_of(soup.triangles.begin(), soup.triangles.end(), isInRange);
}

}  // namespace handwheel
