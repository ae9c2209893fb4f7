// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/PositionTriangles.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

class PositionTrianglesTest : public QObject {
  Q_OBJECT

 private slots:
  void asAFileShowsThem();
  void deadFaces();
};

// The two fans at the corner that the cubes share are one position.
void PositionTrianglesTest::asAFileShowsThem() {
  const HalfEdgeMesh mesh = buildMesh(test::twoCubesSharingAVertex()).mesh;
  const PositionTriangles byPosition(mesh);
  QCOMPARE(byPosition.classes.representative.size(), std::size_t{15});
  QCOMPARE(byPosition.triangles.size(), std::size_t{24});
  for (Face f = 0; f < 24; ++f)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t c = byPosition.triangles[f][k];
      QVERIFY(mesh.position(byPosition.classes.representative[c]) == mesh.points(f)[k]);
    }
}

void PositionTrianglesTest::deadFaces() {
  HalfEdgeMesh mesh = buildMesh(test::cube()).mesh;
  mesh.removeFace(5);
  const PositionTriangles byPosition(mesh);
  for (Face f = 0; f < 12; ++f) QCOMPARE(hasRepeatedVertex(byPosition.triangles[f]), f == 5);
}

HANDWHEEL_TEST(PositionTrianglesTest)
#include "PositionTrianglesTest.moc"
