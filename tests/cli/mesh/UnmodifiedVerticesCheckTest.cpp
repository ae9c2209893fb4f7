// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "cli/mesh/UnmodifiedVerticesCheck.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

TriangleSoup fourFaces() {
  TriangleSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  soup.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return soup;
}

// Returns the number of the vertex at this position.
Vertex vertexAt(const HalfEdgeMesh& mesh, const Vec3& position) {
  Vertex v = 0;
  while (mesh.position(v) != position) ++v;
  return v;
}

}  // namespace

// Against mathematics: a file differs from the mesh in one vertex, by the least that a double can.
class UnmodifiedVerticesCheckTest : public QObject {
  Q_OBJECT

 private slots:
  void oneStepIsSeen() {
    const HalfEdgeMesh mesh = buildMesh(fourFaces()).mesh;
    TriangleSoup file = fourFaces();
    QVERIFY(unmodifiedAreIdentical(mesh, mesh, {}, file));
    file.points[1].x() = std::nextafter(1.0, 2.0);
    QVERIFY(!unmodifiedAreIdentical(mesh, mesh, {}, file));
    QVERIFY(unmodifiedAreIdentical(mesh, mesh, {vertexAt(mesh, {1, 0, 0})}, file));
    QVERIFY(!unmodifiedAreIdentical(mesh, mesh, {vertexAt(mesh, {0, 1, 0})}, file));
  }

  // A point of the file that no triangle uses does not stand for a vertex.
  void missingFacesAreSeen() {
    const HalfEdgeMesh mesh = buildMesh(fourFaces()).mesh;
    TriangleSoup file = fourFaces();
    file.triangles = {{0, 2, 1}};
    QVERIFY(!unmodifiedAreIdentical(mesh, mesh, {}, file));
  }
};

HANDWHEEL_TEST(UnmodifiedVerticesCheckTest)
#include "UnmodifiedVerticesCheckTest.moc"
