// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/NearFeatures.h"

#include "base/Tolerance.h"
#include "haptics/contact/TouchableSurface.h"
#include "mesh/structure/AngleBetween.h"
#include "mesh/structure/FaceNormal.h"

#include <cmath>
#include <unordered_set>

namespace handwheel {
namespace {

constexpr int kMostHalvings = 40;  // then the faces meet in one point

// False when there are too many; the first of them then.
bool collect(const ContactSurface& surface, const Vec3& position, double reach, std::vector<Face>& faces) {
  faces.clear();
  const Vec3 half = Vec3::Constant(reach);
  return surface.forEachInBox(Box(position - half, position + half), [&](const ContactTriangle& triangle) {
    const Face face = triangle.id / 2;
    if (touchableNumber(face) != triangle.id) return true;  // a strip in a seam
    if (faces.size() == NearFeatures::kMostFaces) return false;
    faces.push_back(face);
    return true;
  });
}

bool isBent(const HalfEdgeMesh& mesh, HalfEdge h) {
  if (!mesh.hasOpposite(h)) return true;
  const Vec3 a = unitNormal(mesh.points(HalfEdgeMesh::face(h)));
  const Vec3 b = unitNormal(mesh.points(HalfEdgeMesh::face(mesh.opposite(h))));
  return a.isZero(0.0) || b.isZero(0.0) || angleBetween(a, b) > tolerance::kFlatEdge;
}

class Gatherer {
 public:
  Gatherer(const HalfEdgeMesh& mesh, const SnapTargets& snapTargets, SnapFeatures& features)
      : m_mesh(mesh), m_snapTargets(snapTargets), m_features(features) {}

  void add(Face face) {
    if (m_snapTargets.faces) {
      const TrianglePoints p = m_mesh.points(face);
      m_features.addTriangle(face, p[0], p[1], p[2]);
    }
    if (!m_mesh.isProper(face)) return;
    for (HalfEdge h = 3 * face; h < 3 * face + 3; ++h) addEdge(h);
  }

 private:
  void addEdge(HalfEdge h) {
    const bool isBorder = m_mesh.isBorder(h);
    const bool isEdge = (m_snapTargets.edges || m_snapTargets.corners) && isBent(m_mesh, h);
    if (!isEdge && !isBorder) return;
    const Vertex from = m_mesh.from(h), to = m_mesh.to(h);
    if ((isEdge && m_snapTargets.corners) || (isBorder && m_snapTargets.borderPoints)) {
      addPoint(from);
      addPoint(to);
    }
    const HalfEdge number = m_mesh.hasOpposite(h) ? std::min(h, m_mesh.opposite(h)) : h;
    if (((isEdge && m_snapTargets.edges) || (isBorder && m_snapTargets.borderEdges)) && m_edges.insert(number).second)
      m_features.addSegment(number, m_mesh.position(from), m_mesh.position(to));
  }
  void addPoint(Vertex vertex) {
    if (m_points.insert(vertex).second) m_features.addPoint(vertex, m_mesh.position(vertex));
  }

  const HalfEdgeMesh& m_mesh;
  const SnapTargets& m_snapTargets;
  SnapFeatures& m_features;
  std::unordered_set<Vertex> m_points;
  std::unordered_set<HalfEdge> m_edges;
};

}  // namespace

NearFeatures nearFeatures(const HalfEdgeMesh& mesh, const ContactSurface& surface, const SnapTargets& snapTargets,
                          const Vec3& position, double reach) {
  NearFeatures near;
  if (!position.allFinite() || !(reach > 0.0) || !std::isfinite(reach)) return near;
  std::vector<Face> faces;
  for (int i = 0; !collect(surface, position, reach, faces) && i < kMostHalvings; ++i) reach *= 0.5;
  Gatherer gatherer(mesh, snapTargets, near.features);
  for (const Face face : faces) gatherer.add(face);
  near.reach = reach;
  return near;
}

double meanSide(const HalfEdgeMesh& mesh) {
  double sum = 0.0;
  std::size_t count = 0;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    const TrianglePoints p = mesh.points(f);
    const double sides = (p[1] - p[0]).norm() + (p[2] - p[1]).norm() + (p[0] - p[2]).norm();
    if (!std::isfinite(sides)) continue;
    sum += sides;
    count += 3;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

}  // namespace handwheel
