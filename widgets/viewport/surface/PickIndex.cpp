// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/PickIndex.h"

namespace handwheel {

PickIndex::PickIndex(const HalfEdgeMesh& mesh) {
  HalfEdgeMesh::Compact compact = mesh.compact();
  m_hierarchy = TriangleHierarchy(compact.soup.points, compact.soup.triangles);
  m_faceOf = std::move(compact.faceOf);
}

std::optional<PickIndex::Hit> PickIndex::firstHit(const Vec3& origin, const Vec3& direction) const {
  const auto hit = m_hierarchy.firstHit(origin, direction);
  if (!hit) return std::nullopt;
  return Hit{m_faceOf[hit->triangle], hit->distance};
}

Vec3 PickIndex::normalNear(const Vec3& p) const {
  const auto nearest = m_hierarchy.nearest(p);
  if (!nearest) return Vec3::Zero();
  const auto [a, b, c] = m_hierarchy.corners(nearest->triangle);
  return (b - a).cross(c - a).normalized();
}

}  // namespace handwheel
