// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/EdgeOperations.h"

#include <algorithm>

namespace handwheel {
namespace {

bool areJoined(const HalfEdgeMesh& mesh, HalfEdge fromA, Vertex b) {
  const std::vector<HalfEdge> fan = mesh.fan(fromA);
  return std::any_of(fan.begin(), fan.end(),
                     [&](HalfEdge g) { return mesh.to(g) == b || mesh.from(HalfEdgeMesh::previous(g)) == b; });
}

void attach(HalfEdgeMesh& mesh, HalfEdge h, HalfEdge other) {
  mesh.setOpposite(h, other);
  if (other < static_cast<HalfEdge>(Open::Seam)) mesh.setOpposite(other, h);
}

}  // namespace

bool flipEdge(HalfEdgeMesh& mesh, HalfEdge h) {
  if (!mesh.hasOpposite(h)) return false;
  const HalfEdge o = mesh.opposite(h);
  const HalfEdge hn = HalfEdgeMesh::next(h), hp = HalfEdgeMesh::previous(h);
  const HalfEdge on = HalfEdgeMesh::next(o), op = HalfEdgeMesh::previous(o);
  const Vertex a = mesh.from(h), c = mesh.to(h), b = mesh.from(hp), d = mesh.from(op);
  const auto pos = [&](Vertex v) { return mesh.position(v); };
  if (b == d || areJoined(mesh, hp, d)) return false;
  if (isDegenerate({pos(b), pos(d), pos(c)}) || isDegenerate({pos(d), pos(b), pos(a)})) return false;

  // h: (a c b) and o: (c a d) become (b d c) and (d b a).
  const HalfEdge behind[4] = {mesh.opposite(hn), mesh.opposite(hp), mesh.opposite(on), mesh.opposite(op)};
  const Face f = HalfEdgeMesh::face(h), g = HalfEdgeMesh::face(o);
  mesh.setTriangle(f, {b, d, c});
  mesh.setTriangle(g, {d, b, a});
  mesh.pair(3 * f, 3 * g);
  attach(mesh, 3 * f + 1, behind[3]);  // d→c was op
  attach(mesh, 3 * f + 2, behind[0]);  // c→b was hn
  attach(mesh, 3 * g + 1, behind[1]);  // b→a was hp
  attach(mesh, 3 * g + 2, behind[2]);  // a→d was on
  return true;
}

HalfEdge splitEdge(HalfEdgeMesh& mesh, HalfEdge h, const Vec3& p) {
  const HalfEdge o = mesh.opposite(h);
  const HalfEdge hn = HalfEdgeMesh::next(h), on = HalfEdgeMesh::next(o);
  const Vertex a = mesh.from(h), b = mesh.to(h);
  const Vertex c = mesh.to(hn), d = mesh.to(on);
  const HalfEdge behindHn = mesh.opposite(hn), behindOn = mesh.opposite(on);
  const Vertex m = mesh.addVertex(p);

  // h: (a b c) keeps (a m c), the new face is (m b c); o: (b a d) keeps (b m d), the new face is (m a d).
  mesh.setCorner(hn, m);
  mesh.setCorner(on, m);
  const Face f = mesh.addFace({m, b, c}), g = mesh.addFace({m, a, d});
  mesh.pair(h, 3 * g);       // a→m and m→a
  mesh.pair(o, 3 * f);       // b→m and m→b
  mesh.pair(hn, 3 * f + 2);  // m→c and c→m
  mesh.pair(on, 3 * g + 2);
  attach(mesh, 3 * f + 1, behindHn);  // b→c
  attach(mesh, 3 * g + 1, behindOn);  // a→d
  return 3 * f;
}

}  // namespace handwheel
