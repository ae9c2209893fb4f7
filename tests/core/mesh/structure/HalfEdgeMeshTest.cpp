// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/HalfEdgeMesh.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>

using namespace handwheel;

class HalfEdgeMeshTest : public QObject {
  Q_OBJECT

 private slots:
  void walksAroundAFace();
  void opposites();
  void fansInside();
  void fansAtTheBorder();
  void nextOpenWalksTheRim();
  void removingFaces();
  void compacting();
  void copiesAreIndependent();
};

void HalfEdgeMeshTest::walksAroundAFace() {
  const HalfEdgeMesh mesh = buildMesh(test::cube()).mesh;
  QCOMPARE(mesh.halfEdgeSlots(), std::size_t{36});
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    QCOMPARE(HalfEdgeMesh::face(h), h / 3);
    QCOMPARE(HalfEdgeMesh::next(HalfEdgeMesh::previous(h)), h);
    QCOMPARE(HalfEdgeMesh::next(HalfEdgeMesh::next(HalfEdgeMesh::next(h))), h);
    QCOMPARE(mesh.to(h), mesh.from(HalfEdgeMesh::next(h)));
    QCOMPARE(mesh.from(h), mesh.triangle(h / 3)[h % 3]);
  }
}

void HalfEdgeMeshTest::opposites() {
  const HalfEdgeMesh mesh = buildMesh(test::disc(8, 3)).mesh;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    QVERIFY(mesh.hasOpposite(h) != mesh.isBorder(h));
    QVERIFY(!mesh.isSeam(h));
    if (mesh.hasOpposite(h)) QCOMPARE(mesh.from(mesh.opposite(h)), mesh.to(h));
  }
}

// Every vertex inside: the fan has as many half-edges as faces meet there, and turns counter-clockwise seen from
// outside.
void HalfEdgeMeshTest::fansInside() {
  const HalfEdgeMesh mesh = buildMesh(test::icosphere(2)).mesh;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    const std::vector<HalfEdge> fan = mesh.fan(h);
    std::size_t faces = 0;
    for (Face f = 0; f < mesh.faceSlots(); ++f)
      faces += std::count(mesh.triangle(f).begin(), mesh.triangle(f).end(), mesh.from(h));
    QCOMPARE(fan.size(), faces);
    QVERIFY(std::count(fan.begin(), fan.end(), h) == 1);
    const Vec3 centre = mesh.position(mesh.from(h));
    for (std::size_t i = 0; i < fan.size(); ++i) {
      QCOMPARE(mesh.from(fan[i]), mesh.from(h));
      const Vec3 a = mesh.position(mesh.to(fan[i])) - centre,
                 b = mesh.position(mesh.to(fan[(i + 1) % fan.size()])) - centre;
      QVERIFY(a.cross(b).dot(centre) > 0.0);
    }
  }
}

void HalfEdgeMeshTest::fansAtTheBorder() {
  const HalfEdgeMesh mesh = buildMesh(test::disc(8, 3)).mesh;
  int rims = 0;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    const std::vector<HalfEdge> fan = mesh.fan(h);
    if (mesh.position(mesh.from(h)).norm() < 0.9) continue;
    ++rims;
    QVERIFY(mesh.isBorder(fan.front()));
    QVERIFY(mesh.isBorder(HalfEdgeMesh::previous(fan.back())));
    for (HalfEdge g : fan) QVERIFY(mesh.fan(g) == fan);
  }
  QVERIFY(rims > 0);
}

void HalfEdgeMeshTest::nextOpenWalksTheRim() {
  const HalfEdgeMesh mesh = buildMesh(test::disc(8, 3)).mesh;
  for (HalfEdge start = 0; start < mesh.halfEdgeSlots(); ++start) {
    if (!mesh.isBorder(start)) continue;
    std::size_t steps = 0;
    HalfEdge h = start;
    do {
      const HalfEdge after = mesh.nextOpen(h);
      QVERIFY(mesh.isBorder(after));
      QCOMPARE(mesh.from(after), mesh.to(h));
      h = after;
      QVERIFY(++steps <= 8);
    } while (h != start);
    QCOMPARE(steps, std::size_t{8});
  }
}

void HalfEdgeMeshTest::removingFaces() {
  HalfEdgeMesh mesh = buildMesh(test::icosphere(1)).mesh;
  mesh.removeFace(11);
  QVERIFY(!mesh.isLive(11) && !mesh.isProper(11));
  QCOMPARE(mesh.liveFaceCount(), std::size_t{79});
  QCOMPARE(mesh.faceSlots(), std::size_t{80});
  QCOMPARE(test::countBorder(mesh), std::size_t{3});
  QCOMPARE(validate(mesh), std::string());
}

void HalfEdgeMeshTest::compacting() {
  HalfEdgeMesh mesh = buildMesh(test::icosphere(1)).mesh;
  for (Face f : {3u, 4u, 50u}) mesh.removeFace(f);
  mesh.addVertex(Vec3(9, 9, 9));  // used by nobody
  const HalfEdgeMesh::Compact compact = mesh.compact();
  QCOMPARE(compact.soup.triangles.size(), std::size_t{77});
  QCOMPARE(compact.soup.points.size(), std::size_t{42});
  for (std::size_t i = 0; i < compact.faceOf.size(); ++i) {
    QVERIFY(mesh.isLive(compact.faceOf[i]));
    QVERIFY(i == 0 || compact.faceOf[i - 1] < compact.faceOf[i]);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t v = compact.soup.triangles[i][k];
      QCOMPARE(compact.vertexOf[v], mesh.triangle(compact.faceOf[i])[k]);
      QVERIFY(test::sameBits(compact.soup.points[v], mesh.position(compact.vertexOf[v])));
    }
  }
}

void HalfEdgeMeshTest::copiesAreIndependent() {
  const HalfEdgeMesh mesh = buildMesh(test::cube()).mesh;
  HalfEdgeMesh copy = mesh;
  copy.removeFace(0);
  copy.setPosition(3, Vec3(5, 5, 5));
  QCOMPARE(test::countBorder(mesh), std::size_t{0});
  QVERIFY(mesh.position(3) != copy.position(3));
}

HANDWHEEL_TEST(HalfEdgeMeshTest)
#include "HalfEdgeMeshTest.moc"
