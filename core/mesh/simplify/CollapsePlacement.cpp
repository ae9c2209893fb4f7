// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/simplify/CollapsePlacement.h"

#include "mesh/simplify/Quadric.h"
#include "mesh/structure/EdgeCollapse.h"
#include "mesh/structure/FaceNormal.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

constexpr double kPull = 1e-6;        // weight of the edge's middle if the planes leave the position undetermined
constexpr double kShortFirst = 1e-8;  // if no collapse changes the surface, the shortest edge is first

// Sum of the quadrics around an edge, relative to its middle.
class PlaneSum {
 public:
  PlaneSum(const HalfEdgeMesh& mesh, const VertexConstraints& holds, const Vec3& origin)
      : m_mesh(mesh), m_holds(holds), m_origin(origin) {}

  Quadric around(HalfEdge h) {
    const HalfEdge one = HalfEdgeMesh::next(h);
    addFan(h, kNone, kNone);
    if (!m_mesh.hasOpposite(h)) {
      addFan(one, HalfEdgeMesh::face(h), kNone);
    } else {
      const HalfEdge o = m_mesh.opposite(h);
      addFan(one, HalfEdgeMesh::face(h), HalfEdgeMesh::face(o));
      addSharpEdge(HalfEdgeMesh::previous(o));
    }
    addSharpEdge(one);
    return m_sum;
  }

 private:
  // Only the first faces are added if there are too many: such an edge does not collapse anyway.
  void addFan(HalfEdge h, Face except, Face exceptToo) {
    std::size_t n = 0;
    forEachInFan(m_mesh, h, [&](HalfEdge g) {
      if (HalfEdgeMesh::face(g) != except && HalfEdgeMesh::face(g) != exceptToo) addFace(g);
      return ++n <= kLargestFan;
    });
  }

  // Adds the face of g with the planes of its open or sharp edges at the start of g.
  void addFace(HalfEdge g) {
    const TrianglePoints t = m_mesh.points(HalfEdgeMesh::face(g));
    const Vec3 n = 0.5 * (t[1] - t[0]).cross(t[2] - t[0]);
    const double area = n.norm();
    if (!(area > 0.0)) return;
    m_sum += Quadric::ofPlane(t[0] - m_origin, n / area, area);
    addSharpEdge(g);
    addSharpEdge(HalfEdgeMesh::previous(g));
  }

  // Adds the plane of an edge if it is open or a crease. Its weight is that of a square face on the edge.
  void addSharpEdge(HalfEdge h) {
    if (m_mesh.hasOpposite(h) && !m_holds.isCrease(h)) return;
    const Vec3 normal = unitNormal(m_mesh.points(HalfEdgeMesh::face(h)));
    const Vec3& from = m_mesh.position(m_mesh.from(h));
    const Vec3 along = m_mesh.position(m_mesh.to(h)) - from, across = along.cross(normal);
    const double length = across.norm();
    if (length > 0.0) m_sum += Quadric::ofPlane(from - m_origin, across / length, along.squaredNorm());
  }

  const HalfEdgeMesh& m_mesh;
  const VertexConstraints& m_holds;
  Vec3 m_origin;
  Quadric m_sum;
};

}  // namespace

std::optional<CollapsePlacement> collapsePlacement(const HalfEdgeMesh& mesh, const VertexConstraints& holds,
                                                   HalfEdge h) {
  const VertexConstraint a = holds.of(mesh.from(h)), b = holds.of(mesh.to(h));
  if (a == VertexConstraint::Fixed && b == VertexConstraint::Fixed) return std::nullopt;
  if (a != VertexConstraint::Free && b != VertexConstraint::Free && !holds.isCrease(h)) return std::nullopt;
  const Vec3 &from = mesh.position(mesh.from(h)), &to = mesh.position(mesh.to(h)), middle = 0.5 * (from + to);
  const Quadric q = PlaneSum(mesh, holds, middle).around(h);
  const double length2 = (to - from).squaredNorm();
  CollapsePlacement best{middle, std::numeric_limits<double>::infinity()};
  const auto take = [&](const Vec3& p) {
    const double cost = std::max(q.at(p - middle), 0.0);
    if (cost < best.cost) best = {p, cost};
  };
  if (a == VertexConstraint::Free && b == VertexConstraint::Free) {
    const Vec3 least = q.leastNear(Vec3::Zero(), kPull);
    if (least.squaredNorm() <= length2) take(middle + least);
    take(middle);
  }
  if (a >= b) take(from);
  if (b >= a) take(to);
  best.cost += kShortFirst * q.a.trace() * length2;
  return std::isfinite(best.cost) ? std::optional(best) : std::nullopt;
}

}  // namespace handwheel
