// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/SurfaceDistance.h"

#include "mesh/structure/AngleBetween.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/FaceNormal.h"
#include "proximity/ClosestPoint.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

bool isFinite(const TrianglePoints& t) {
  return t[0].allFinite() && t[1].allFinite() && t[2].allFinite();
}

// The result is invalid once cancelled.
std::vector<Face> surfaceFaces(const HalfEdgeMesh& mesh, const Progress& progress) {
  std::vector<Face> solid, flat;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!pollProgress(f, mesh.faceSlots(), progress)) return {};
    if (!mesh.isLive(f) || !isFinite(mesh.points(f))) continue;
    (isDegenerate(mesh.points(f)) ? flat : solid).push_back(f);
  }
  return solid.empty() ? flat : solid;
}

std::vector<Vec3> vertexNormals(const HalfEdgeMesh& mesh, const std::vector<Face>& faces, const Progress& progress) {
  std::vector<Vec3> normals(mesh.vertexSlots(), Vec3::Zero());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!pollProgress(i, faces.size(), progress)) break;
    const TrianglePoints t = mesh.points(faces[i]);
    const Vec3 normal = unitNormal(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const double angle = angleBetween(t[(k + 1) % 3] - t[k], t[(k + 2) % 3] - t[k]);
      normals[mesh.triangle(faces[i])[k]] += angle * normal;
    }
  }
  return normals;
}

TriangleHierarchy hierarchyOf(const HalfEdgeMesh& mesh, const std::vector<Face>& faces, Progress progress) {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> number(mesh.vertexSlots(), kNone);
  triangles.reserve(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!pollProgress(i, faces.size(), progress.part(0.0, 0.2))) return {};
    Triangle t = mesh.triangle(faces[i]);
    for (std::uint32_t& v : t) {
      if (number[v] == kNone) {
        number[v] = static_cast<std::uint32_t>(points.size());
        points.push_back(mesh.position(v));
      }
      v = number[v];
    }
    triangles.push_back(t);
  }
  return {points, triangles, progress.part(0.2, 1.0), Slivers::Cut};
}

}  // namespace

SurfaceDistance::SurfaceDistance(const HalfEdgeMesh& mesh, Progress progress)
    : m_mesh(mesh),
      m_faces(surfaceFaces(mesh, progress.part(0.0, 0.1))),
      m_normals(vertexNormals(mesh, m_faces, progress.part(0.1, 0.2))),
      m_hierarchy(hierarchyOf(mesh, m_faces, progress.part(0.2, 1.0))) {}

Vec3 SurfaceDistance::normalAt(Face f, const Vec3& p, const Vec3& nearest) const {
  const TrianglePoints t = m_mesh.points(f);
  for (std::uint32_t k = 0; k < 3; ++k) {
    if (nearest == t[k]) return m_normals[m_mesh.triangle(f)[k]];
  }
  const Vec3 normal = unitNormal(t);
  for (std::uint32_t k = 0; k < 3; ++k) {
    // Exactly the point that closestOnTriangle() returns if it is on an edge.
    const HalfEdge h = 3 * f + k;
    if (!m_mesh.hasOpposite(h) || closestOnSegment(p, t[k], t[(k + 1) % 3]) != nearest) continue;
    return normal + unitNormal(m_mesh.points(HalfEdgeMesh::face(m_mesh.opposite(h))));
  }
  return normal;
}

std::optional<SurfaceDistance::Nearest> SurfaceDistance::from(const Vec3& p) const {
  const auto found = m_hierarchy.nearest(p);
  if (!found) return std::nullopt;
  const Vec3 normal = normalAt(m_faces[found->triangle], p, found->point);
  const double distance = (p - found->point).stableNorm();
  return Nearest{found->point, (p - found->point).dot(normal) < 0.0 ? -distance : distance};
}

}  // namespace handwheel
