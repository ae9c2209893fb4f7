// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/defects/DuplicateFaces.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>

using namespace handwheel;

class DuplicateFacesTest : public QObject {
  Q_OBJECT

 private slots:
  void sheetWrittenTwice();
  void doubledFaces();
  void innerWallTwice();
  void pillowStays();
  void tripledTriangle();
  void doubledShape();
  void nothingDoubled();
};

void DuplicateFacesTest::doubledFaces() {
  for (bool turned : {false, true}) {
    TriangleSoup s = test::icosphere(1);
    for (std::size_t f : {std::size_t{7}, std::size_t{30}, std::size_t{30}}) {
      Triangle t = s.triangles[f];
      if (turned) std::swap(t[0], t[1]);
      s.triangles.push_back(t);
    }
    HalfEdgeMesh mesh = buildMesh(s).mesh;
    QCOMPARE(removeDuplicateFaces(mesh), std::size_t{3});
    QCOMPARE(mesh.liveFaceCount(), std::size_t{80});
    QCOMPARE(validate(mesh), std::string());
    QVERIFY(test::countEdges(mesh).sound());
  }
}

// Two boxes side by side, each with its own copy of the side between them: without the two copies it is one closed box.
void DuplicateFacesTest::innerWallTwice() {
  TriangleSoup s = test::cube();
  TriangleSoup right = test::cube(1.0, Vec3(1, 0, 0));
  for (Vec3& p : right.points) p.x() = 3.0 - p.x();  // mirrored, so that the wall's diagonals agree
  test::append(s, test::turnedOver(right));
  HalfEdgeMesh mesh = buildMesh(s).mesh;
  QCOMPARE(removeDuplicateFaces(mesh), std::size_t{4});
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(test::countEdges(mesh).sound());
  QVERIFY(std::abs(test::volume(mesh.compact().soup) - 2.0) < 1e-12);
}

void DuplicateFacesTest::pillowStays() {
  TriangleSoup s = test::cube();
  test::append(s, {{Vec3(5, 0, 0), Vec3(6, 0, 0), Vec3(5, 1, 0)}, {{0, 1, 2}, {0, 2, 1}}});
  const HalfEdgeMesh before = buildMesh(s).mesh;
  QCOMPARE(test::countBorder(before), std::size_t{0});
  HalfEdgeMesh mesh = before;
  QCOMPARE(removeDuplicateFaces(mesh), std::size_t{0});
  QVERIFY(test::sameMesh(mesh, before));
}

// Three copies of a lone triangle: one is left, or two that make a pillow.
void DuplicateFacesTest::tripledTriangle() {
  TriangleSoup s = {{Vec3(5, 0, 0), Vec3(6, 0, 0), Vec3(5, 1, 0)}, {{0, 1, 2}, {0, 1, 2}, {0, 1, 2}}};
  HalfEdgeMesh mesh = buildMesh(s).mesh;
  const std::size_t removed = removeDuplicateFaces(mesh);
  QVERIFY(removed == 1 || removed == 2);
  QCOMPARE(mesh.liveFaceCount(), 3 - removed);
  QCOMPARE(validate(mesh), std::string());
  QCOMPARE(test::countEdges(mesh).nonManifold, std::size_t{0});
}

// Every face of a closed shape twice, in either turn: one shell is left.
void DuplicateFacesTest::doubledShape() {
  for (const TriangleSoup& once : {test::cube(), test::icosphere(2), test::torus(8, 6)}) {
    for (const TriangleSoup& second : {once, test::turnedOver(once)}) {
      TriangleSoup s = once;
      test::append(s, second);
      HalfEdgeMesh mesh = buildMesh(s).mesh;
      QCOMPARE(removeDuplicateFaces(mesh), once.triangles.size());
      QCOMPARE(validate(mesh), std::string());
      QVERIFY(test::countEdges(mesh).sound());
    }
  }
}

void DuplicateFacesTest::nothingDoubled() {
  for (const TriangleSoup& s : {test::cube(), test::disc(8, 3), test::boxWithInnerWall()}) {
    const HalfEdgeMesh before = buildMesh(s).mesh;
    HalfEdgeMesh mesh = before;
    QCOMPARE(removeDuplicateFaces(mesh), std::size_t{0});
    QVERIFY(test::sameMesh(mesh, before));
  }
}

// Both copies face the same direction, so they are not the two sides of a plate. One of each face stays, and the single
// border of the sheet.
void DuplicateFacesTest::sheetWrittenTwice() {
  const TriangleSoup sheet = test::disc(12, 4);
  TriangleSoup soup = sheet;
  test::append(soup, sheet);
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  QCOMPARE(removeDuplicateFaces(mesh), sheet.triangles.size());
  QCOMPARE(mesh.liveFaceCount(), sheet.triangles.size());
  QCOMPARE(test::countBorder(mesh), std::size_t{12});
}

HANDWHEEL_TEST(DuplicateFacesTest)
#include "DuplicateFacesTest.moc"
