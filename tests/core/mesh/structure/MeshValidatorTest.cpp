// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/MeshValidator.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>
#include <limits>

using namespace handwheel;

namespace {

// Two triangles that share the edge 1-2.
HalfEdgeMesh twoTriangles() {
  return buildMesh({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0)}, {{0, 1, 2}, {1, 3, 2}}}).mesh;
}

HalfEdge sharedHalfEdge(const HalfEdgeMesh& mesh) {
  for (HalfEdge h = 0; h < 3; ++h)
    if (mesh.hasOpposite(h)) return h;
  return kNone;
}

}  // namespace

// Each test breaks one promise, and only that one, through the low-level changes.
class MeshValidatorTest : public QObject {
  Q_OBJECT

 private slots:
  void soundMeshes();
  void cornerOutOfRange();
  void cornerNotFinite();
  void deadFaceWithNeighbours();
  void oppositeOutOfRange();
  void oppositeNotMutual();
  void oppositeOfAFaceWithoutExtent();
  void oppositeAlongOtherVertices();
  void oppositeInTheSameDirection();
  void oppositeInTheSameFace();
  void twoFansAtAVertex();
  void twoVerticesInAFan();
};

void MeshValidatorTest::soundMeshes() {
  QCOMPARE(validate(HalfEdgeMesh()), std::string());
  QCOMPARE(validate(twoTriangles()), std::string());
  HalfEdgeMesh mesh = twoTriangles();
  mesh.removeFace(0);
  mesh.addVertex(Vec3(5, 5, 5));  // one that nobody uses
  QCOMPARE(validate(mesh), std::string());
}

void MeshValidatorTest::cornerOutOfRange() {
  HalfEdgeMesh mesh;
  for (int i = 0; i < 3; ++i) mesh.addVertex(Vec3(i, i * i, 0));
  mesh.addFace({0, 1, 3});
  QVERIFY(!validate(mesh).empty());
}

void MeshValidatorTest::cornerNotFinite() {
  for (double x : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    HalfEdgeMesh mesh = twoTriangles();
    mesh.setPosition(3, Vec3(0, x, 0));
    QVERIFY(!validate(mesh).empty());
  }
}

void MeshValidatorTest::deadFaceWithNeighbours() {
  HalfEdgeMesh mesh = twoTriangles();
  const HalfEdge h = sharedHalfEdge(mesh), o = mesh.opposite(h);
  mesh.removeFace(0);
  mesh.setOpposite(h, o);
  QVERIFY(!validate(mesh).empty());
}

void MeshValidatorTest::oppositeOutOfRange() {
  HalfEdgeMesh mesh = twoTriangles();
  mesh.setOpposite(sharedHalfEdge(mesh), 6);
  QVERIFY(!validate(mesh).empty());
}

void MeshValidatorTest::oppositeNotMutual() {
  HalfEdgeMesh mesh = twoTriangles();
  mesh.setOpen(mesh.opposite(sharedHalfEdge(mesh)), Open::Border);
  QVERIFY(!validate(mesh).empty());
  mesh = twoTriangles();
  mesh.setOpen(sharedHalfEdge(mesh), Open::Seam);
  QVERIFY(!validate(mesh).empty());
}

void MeshValidatorTest::oppositeOfAFaceWithoutExtent() {
  HalfEdgeMesh mesh = buildMesh({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}, {1, 0, 0}}}).mesh;
  QCOMPARE(validate(mesh), std::string());
  mesh.pair(0, 3);  // 0→1 and 1→0
  QVERIFY(!validate(mesh).empty());
}

void MeshValidatorTest::oppositeAlongOtherVertices() {
  HalfEdgeMesh mesh = twoTriangles();
  const HalfEdge h = sharedHalfEdge(mesh), o = mesh.opposite(h);
  mesh.setOpen(h, Open::Border);
  mesh.setOpen(o, Open::Border);
  mesh.pair(HalfEdgeMesh::next(h), o);
  QVERIFY(!validate(mesh).empty());
}

void MeshValidatorTest::oppositeInTheSameDirection() {
  HalfEdgeMesh mesh;
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) mesh.addVertex(p);
  mesh.addFace({0, 1, 2});
  mesh.addFace({0, 1, 3});
  mesh.pair(0, 3);
  QVERIFY(!validate(mesh).empty());
}

void MeshValidatorTest::oppositeInTheSameFace() {
  HalfEdgeMesh mesh = twoTriangles();
  for (HalfEdge h = 0; h < 3; ++h) {
    if (mesh.hasOpposite(h)) continue;
    mesh.setOpposite(h, h);
    QVERIFY(!validate(mesh).empty());
    return;
  }
}

void MeshValidatorTest::twoFansAtAVertex() {
  HalfEdgeMesh mesh;
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0)}) mesh.addVertex(p);
  mesh.addFace({0, 1, 2});
  mesh.addFace({0, 3, 4});
  QVERIFY(!validate(mesh).empty());
}

void MeshValidatorTest::twoVerticesInAFan() {
  // One of the two faces at the shared edge gets another vertex at the same position at one end.
  HalfEdgeMesh mesh = twoTriangles();
  const HalfEdge h = sharedHalfEdge(mesh);
  const Vec3 p = mesh.position(mesh.from(h));
  mesh.setCorner(h, mesh.addVertex(p));
  QVERIFY(!validate(mesh).empty());
}

HANDWHEEL_TEST(MeshValidatorTest)
#include "MeshValidatorTest.moc"
