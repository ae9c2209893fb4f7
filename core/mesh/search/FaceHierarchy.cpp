// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/FaceHierarchy.h"

#include "proximity/BoxQueries.h"

namespace handwheel {

FaceHierarchy::FaceHierarchy(const HalfEdgeMesh& mesh) : m_mesh(mesh) {
  HalfEdgeMesh::Compact compact = mesh.compact();
  m_hierarchy = TriangleHierarchy(compact.soup.points, compact.soup.triangles);
  m_faceOf = std::move(compact.faceOf);
}

std::optional<FaceHierarchy::Hit> FaceHierarchy::firstHit(const Ray& ray) const {
  const auto hit = m_hierarchy.firstHit(ray.origin, ray.direction);
  if (!hit) return std::nullopt;
  return Hit{m_faceOf[hit->triangle], ray.origin + hit->distance * ray.direction, hit->distance};
}

bool FaceHierarchy::forEachInBox(const Box& box, const std::function<bool(Face)>& visit) const {
  return m_hierarchy.forEachInBox(box, [&](std::uint32_t i) { return visit(m_faceOf[i]); });
}

std::optional<Vec3> FaceHierarchy::nearest(const Vec3& p) const {
  const auto found = m_hierarchy.nearest(p);
  return found ? std::optional(found->point) : std::nullopt;
}

Vec3 FaceHierarchy::normalNear(const Vec3& p) const {
  const auto nearest = m_hierarchy.nearest(p);
  if (!nearest) return Vec3::Zero();
  const auto [a, b, c] = m_hierarchy.corners(nearest->triangle);
  return (b - a).cross(c - a).normalized();
}

bool FaceHierarchy::isHidden(const Vec3& p, const std::optional<Vec3>& eye, const Vec3& direction, double by,
                             Face own) const {
  if (bounds().isEmpty()) return false;
  Ray ray;
  // Starts in front of the whole model, farther away than any of its points is from p.
  const double reach = (bounds().max() - p).cwiseAbs().cwiseMax((p - bounds().min()).cwiseAbs()).norm();
  ray.origin = eye ? *eye : Vec3(p - reach * direction.stableNormalized());
  ray.direction = p - ray.origin;
  const double distance = ray.direction.stableNorm();
  ray.direction /= distance;
  const auto hit = firstHit(ray);
  if (!hit || hit->face == own) return false;
  const double rounding = kQueryRounding * (ray.origin.cwiseAbs().maxCoeff() + p.cwiseAbs().maxCoeff());
  return hit->distance < distance - by - rounding;
}

}  // namespace handwheel
