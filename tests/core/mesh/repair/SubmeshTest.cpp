// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/Submesh.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/defects/Defects.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"
#include "mesh/structure/PositionTriangles.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

class SubmeshTest : public QObject {
  Q_OBJECT

 private slots:
  void holdsWhatReachesIn();
  void unchangedItIsTheSame();
  void changesCountAsInTheWhole();
  void fansThatExchangeVertices();
  void halfEdges();
};

namespace {

Box ballBox(double from) {
  return {Vec3(from, -2, -2), Vec3(2, 2, 2)};
}

// Returns the live faces, each by its corners in order of position.
std::multiset<std::array<test::Coordinates, 3>> shapes(const HalfEdgeMesh& mesh) {
  std::multiset<std::array<test::Coordinates, 3>> result;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    const auto [p, q, r] = mesh.points(f);
    std::array<test::Coordinates, 3> corners = {test::coordinates(p), test::coordinates(q), test::coordinates(r)};
    std::sort(corners.begin(), corners.end());
    result.insert(corners);
  }
  return result;
}

// Returns the expected faces of the whole mesh after a part was written back.
std::multiset<std::array<test::Coordinates, 3>> expected(const HalfEdgeMesh& before, const Submesh& part,
                                                         const HalfEdgeMesh& changed) {
  auto result = shapes(before);
  for (const auto& gone : shapes(part.mesh())) result.erase(result.find(gone));
  result.merge(shapes(changed));
  return result;
}

}  // namespace

void SubmeshTest::holdsWhatReachesIn() {
  const HalfEdgeMesh whole = buildMesh(test::icosphere(3)).mesh;
  const Submesh half(whole, ballBox(0.0)), all(whole, ballBox(-2.0)), none(whole, ballBox(1.5));
  std::size_t reaching = 0;
  for (Face f = 0; f < whole.faceSlots(); ++f) {
    const auto [p, q, r] = whole.points(f);
    reaching += p.x() >= 0.0 || q.x() >= 0.0 || r.x() >= 0.0;
  }
  QCOMPARE(half.faceCount(), reaching);
  QCOMPARE(all.faceCount(), whole.faceSlots());
  QCOMPARE(none.faceCount(), std::size_t{0});
  QCOMPARE(validate(half.mesh()), std::string());
}

void SubmeshTest::unchangedItIsTheSame() {
  for (const TriangleSoup& soup :
       {test::icosphere(2), test::moebiusStrip(12, 3), test::twoCubesSharingAnEdge(), test::kleinBottle(12, 6)}) {
    const HalfEdgeMesh before = buildMesh(soup).mesh;
    HalfEdgeMesh whole = before;
    const Submesh part(whole, ballBox(0.3));
    QVERIFY(part.changesIn(part.mesh()).isEmpty());
    part.writeBack(whole, part.mesh());
    QVERIFY(test::sameMesh(whole, before));
  }
}

// Vertices within the box are moved, faces there removed, others added; crossings and edges without two faces become
// more or fewer by as many in the part as in the whole.
void SubmeshTest::changesCountAsInTheWhole() {
  const bool held = rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    const HalfEdgeMesh before = buildMesh(test::withHole(test::bumpySphere(3), Vec3(0, 1, 0), 0.4)).mesh;
    const Box box = ballBox(*rc::gen::inRange(-10, 9) / 10.0);
    const Submesh part(before, box);
    HalfEdgeMesh changed = part.mesh();
    const auto isWithin = [&](Face f) {
      for (const Vec3& p : changed.points(f))
        if (!box.contains(p)) return false;
      return true;
    };
    for (int i = 0; i < 6; ++i) {
      const auto f = static_cast<Face>(random() % part.faceCount());
      if (!changed.isLive(f) || !isWithin(f)) continue;
      const TrianglePoints p = changed.points(f);
      if (i % 3 == 0) {
        changed.removeFace(f);
      } else if (i % 3 == 1) {
        changed.addFace({changed.triangle(f)[0], changed.triangle(f)[2],
                         changed.addVertex((p[0] + p[1] + p[2]) / 3.0 - 0.2 * p[0])});
      } else {
        changed.setPosition(changed.triangle(f)[0], 0.7 * p[0] + 0.3 * p[1] - 0.2 * p[2]);
      }
    }
    RC_PRE(box.contains(part.changesIn(changed)));
    HalfEdgeMesh whole = before;
    part.writeBack(whole, changed);
    relink(whole);
    RC_ASSERT(validate(whole) == std::string());
    RC_ASSERT(shapes(whole) == expected(before, part, changed));
    const auto crossings = [](const HalfEdgeMesh& mesh) {
      return static_cast<long>(findSelfIntersections(mesh)->size());
    };
    const auto badEdges = [](const HalfEdgeMesh& mesh) { return static_cast<long>(countBadEdges(mesh)); };
    RC_ASSERT(crossings(whole) - crossings(before) == crossings(changed) - crossings(part.mesh()));
    RC_ASSERT(badEdges(whole) - badEdges(before) == badEdges(changed) - badEdges(part.mesh()));
    RC_ASSERT(whole.liveFaceCount() - before.liveFaceCount() == changed.liveFaceCount() - part.faceCount());
  });
  QVERIFY(held);
}

// If two fans meet in a point, relinking may give each the vertex of the other; then one is moved.
void SubmeshTest::fansThatExchangeVertices() {
  const HalfEdgeMesh before = buildMesh(test::twoCubesSharingAVertex()).mesh;
  const Submesh part(before, ballBox(-2.0));
  HalfEdgeMesh changed = part.mesh();
  std::vector<Vertex> shared;
  for (Vertex v = 0; v < changed.vertexSlots(); ++v)
    if (changed.position(v) == Vec3(1, 1, 1)) shared.push_back(v);
  QCOMPARE(shared.size(), std::size_t{2});
  for (HalfEdge h = 0; h < changed.halfEdgeSlots(); ++h) {
    const Vertex v = changed.from(h);
    if (v == shared[0] || v == shared[1]) changed.setCorner(h, v == shared[0] ? shared[1] : shared[0]);
  }
  changed.setPosition(shared[0], Vec3(1.1, 1.1, 1.1));
  HalfEdgeMesh whole = before;
  part.writeBack(whole, changed);
  relink(whole);
  QCOMPARE(validate(whole), std::string());
  QVERIFY(shapes(whole) == expected(before, part, changed));
}

void SubmeshTest::halfEdges() {
  const HalfEdgeMesh whole = buildMesh(test::sphereWithHoles(3, 3, 0.3)).mesh;
  const Submesh part(whole, ballBox(0.0));
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(whole);
  QCOMPARE(loops.size(), std::size_t{3});
  std::size_t found = 0;
  for (const BoundaryLoop& loop : loops) {
    for (const HalfEdge h : loop.halfEdges) {
      const HalfEdge own = part.halfEdgeOf(whole, h);
      if (own == kNone) continue;
      ++found;
      QVERIFY(!part.mesh().hasOpposite(own));
      QCOMPARE(part.mesh().position(part.mesh().from(own)), whole.position(whole.from(h)));
      QCOMPARE(part.mesh().position(part.mesh().to(own)), whole.position(whole.to(h)));
    }
    for (const HalfEdge h : loop.halfEdges)
      QVERIFY(part.halfEdgeOf(whole, h) != kNone || whole.position(whole.from(h)).x() < 0.0);
  }
  QVERIFY(found > 0);
}

HANDWHEEL_TEST(SubmeshTest)
#include "SubmeshTest.moc"
