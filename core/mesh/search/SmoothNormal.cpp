// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/SmoothNormal.h"

#include "mesh/structure/FaceNormal.h"

#include <cmath>

namespace handwheel {

namespace {

constexpr double kCreaseCosine = 0.7660444431189780;  // cos 40°

Vec3 cornerNormal(const HalfEdgeMesh& mesh, HalfEdge h, const Vec3& own) {
  Vec3 sum = Vec3::Zero();
  const Vec3& p = mesh.position(mesh.from(h));
  for (const HalfEdge g : mesh.fan(h)) {
    const Vec3 normal = unitNormal(mesh.points(HalfEdgeMesh::face(g)));
    if (!(normal.dot(own) > kCreaseCosine)) continue;
    const Vec3 a = (mesh.position(mesh.to(g)) - p).stableNormalized();
    const Vec3 b = (mesh.position(mesh.from(HalfEdgeMesh::previous(g))) - p).stableNormalized();
    sum += std::atan2(a.cross(b).norm(), a.dot(b)) * normal;
  }
  return sum.stableNormalized();
}

}  // namespace

Vec3 smoothNormal(const HalfEdgeMesh& mesh, Face f, const Vec3& p) {
  const TrianglePoints t = mesh.points(f);
  const Vec3 own = unitNormal(t);
  if (own.isZero(0.0) || !mesh.isProper(f)) return own;
  Vec3 sum = Vec3::Zero();
  for (std::uint32_t k = 0; k < 3; ++k) {
    const double weight = (t[(k + 1) % 3] - p).cross(t[(k + 2) % 3] - p).dot(own);  // barycentric, scaled
    sum += std::max(weight, 0.0) * cornerNormal(mesh, 3 * f + k, own);
  }
  return sum.isZero(0.0) ? own : Vec3(sum.stableNormalized());
}

}  // namespace handwheel
