// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/BoundaryVertices.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

namespace {

std::set<Vertex> onBorder(const HalfEdgeMesh& mesh) {
  std::set<Vertex> vertices;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
    if (mesh.isBorder(h)) vertices.insert({mesh.from(h), mesh.to(h)});
  return vertices;
}

// Triangles with corners in little clusters, some of them nearer to each other than the reach.
HalfEdgeMesh crumbs(std::mt19937& random) {
  TriangleSoup s = test::randomSoup(random, 1 + random() % 40, 4);
  for (Vec3& p : s.points)
    for (double& x : p) x += 3e-5 * (random() / 4294967296.0 - 0.5);
  return buildMesh(s).mesh;
}

}  // namespace

class BoundaryVerticesTest : public QObject {
  Q_OBJECT

 private slots:
  void diagonal();
  void whoIsIn();
  void findsAllInABox();
  void nearPairs();
  void detailOfALargeModel();
};

void BoundaryVerticesTest::diagonal() {
  QCOMPARE(modelDiagonal(HalfEdgeMesh()), 0.0);
  HalfEdgeMesh mesh = buildMesh(test::cube(2.0, Vec3(5, 5, 5))).mesh;
  QVERIFY(std::abs(modelDiagonal(mesh) - 2.0 * std::sqrt(3.0)) < 1e-12);
  mesh.addVertex(Vec3(100, 0, 0));  // belongs to no face
  QVERIFY(std::abs(modelDiagonal(mesh) - 2.0 * std::sqrt(3.0)) < 1e-12);
}

void BoundaryVerticesTest::whoIsIn() {
  QCOMPARE(BoundaryVertices(buildMesh(test::icosphere(1)).mesh).size(), std::size_t{0});
  const HalfEdgeMesh mesh = buildMesh(test::annulus(16, 3, 1, 2)).mesh;
  const std::set<Vertex> expected = onBorder(mesh);
  QVERIFY(BoundaryVertices(mesh).all() == std::vector<Vertex>(expected.begin(), expected.end()));
  std::vector<bool> without(*expected.begin() + 1, true);  // shorter than the number of vertices
  QCOMPARE(BoundaryVertices(mesh, without).size(), expected.size() - 1);
}

void BoundaryVerticesTest::findsAllInABox() {
  QVERIFY(rc::check("at least all within the box", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const HalfEdgeMesh mesh = crumbs(random);
    const BoundaryVertices vertices(mesh);
    const auto coordinate = [&] { return (random() % 500) / 100.0 - 1.0; };
    const auto corner = [&] { return Vec3(coordinate(), coordinate(), coordinate()); };
    const Box box = Box(corner()).extend(corner());
    std::set<Vertex> found;
    vertices.forEachInBox(box, [&](Vertex v) { found.insert(v); });
    for (Vertex v : vertices.all()) RC_ASSERT(found.contains(v) || !box.contains(mesh.position(v)));
  }));
}

// Each vertex with its nearest of smaller number within reach, and within a quarter of every border edge at either; all
// against all.
void BoundaryVerticesTest::nearPairs() {
  int near = 0;
  QVERIFY(rc::check("the same pairs as all against all", [&] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const HalfEdgeMesh mesh = crumbs(random);
    const double reach = tolerance::kNearWeld * modelDiagonal(mesh);
    const std::set<Vertex> border = onBorder(mesh);
    const auto detail = [&](Vertex v) {
      double longest = 0.0;
      for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
        if (mesh.isBorder(h) && (mesh.from(h) == v || mesh.to(h) == v))
          longest = std::max(longest, (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm());
      return tolerance::kNearWeldEdge * longest;
    };
    std::vector<std::pair<Vertex, Vertex>> expected;
    for (Vertex v : border) {
      Vertex nearest = kNone;
      double best = reach;
      for (Vertex u : border) {
        const double distance = (mesh.position(u) - mesh.position(v)).norm();
        if (distance > detail(u) || distance > detail(v)) continue;
        if (u >= v || distance == 0.0 || distance > best || (distance == best && nearest != kNone)) continue;
        best = distance;
        nearest = u;
      }
      if (nearest != kNone) expected.emplace_back(nearest, v);
    }
    near += !expected.empty();
    RC_ASSERT(nearBoundaryVertices(mesh) == expected);
  }));
  QVERIFY(near > 0);
}

// A flake far out makes the reach larger than a hole; the hole's corners are still not one vertex.
void BoundaryVerticesTest::detailOfALargeModel() {
  TriangleSoup soup = test::sphereWithoutCap(3);
  test::append(soup, TriangleSoup{{Vec3(1e6, 0, 0), Vec3(1e6, 1, 0), Vec3(1e6, 0, 1)}, {{0, 1, 2}}});
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  QVERIFY(nearWeldReach(mesh) > 1.0);
  QVERIFY(nearBoundaryVertices(mesh).empty());
  for (Vec3& p : soup.points) p *= 1e300;
  QCOMPARE(nearWeldReach(buildMesh(soup).mesh), 0.0);
}

HANDWHEEL_TEST(BoundaryVerticesTest)
#include "BoundaryVerticesTest.moc"
