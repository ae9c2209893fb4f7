// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/PartDuplicates.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/Defects.h"
#include "mesh/MeshBuilder.h"
#include "mesh/MeshReport.h"
#include "mesh/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

namespace {

TriangleSoup asWritten(const HalfEdgeMesh& mesh, NumberType numbers) {
  TriangleSoup s = mesh.compact().soup;
  for (Vec3& p : s.points) p = rounded(p, numbers);
  return s;
}

std::size_t intersections(const TriangleSoup& s) {
  return reportOn(s, SelfIntersections::Count).selfIntersectingPairs.value();
}

// The distance between neighbouring numbers at the largest coordinate.
double lastPlace(const Vec3& p, NumberType numbers) {
  const double x = p.cwiseAbs().maxCoeff();
  return numbers == NumberType::Float32 ? double(std::nextafter(float(x), INFINITY)) - double(float(x))
                                        : std::nextafter(x, INFINITY) - x;
}

}  // namespace

class PartDuplicatesTest : public QObject {
  Q_OBJECT

 private slots:
  void cubesSharingAnEdge();
  void cubesSharingAVertexStay();
  void soundMeshesStay();
  void cakeOfWedges();
  void randomCells();
};

void PartDuplicatesTest::cubesSharingAnEdge() {
  for (NumberType numbers : {NumberType::Float32, NumberType::Float64}) {
    for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(10.3, -7.7, 1000), Vec3(-1, -1, -0.5)}) {
      TriangleSoup s = test::moved(test::twoCubesSharingAnEdge(), corner);
      for (Vec3& p : s.points) p = rounded(p, numbers);
      const HalfEdgeMesh before = buildMesh(s).mesh;
      QCOMPARE(test::countEdges(before).nonManifold, std::size_t{1});
      HalfEdgeMesh mesh = before;
      const std::vector<Vertex> moved = partDuplicates(mesh, numbers);
      QVERIFY(!moved.empty());
      QCOMPARE(validate(mesh), std::string());
      const TriangleSoup written = asWritten(mesh, numbers);
      QVERIFY(test::countEdges(written).sound());
      QCOMPARE(intersections(written), std::size_t{0});
      const std::set<Vertex> movedSet(moved.begin(), moved.end());
      for (Vertex v = 0; v < mesh.vertexSlots(); ++v) {
        const double distance = (mesh.position(v) - before.position(v)).norm();
        if (!movedSet.contains(v)) QVERIFY(test::sameBits(mesh.position(v), before.position(v)));
        QVERIFY2(distance <= 8 * lastPlace(before.position(v), numbers), qPrintable(QString::number(distance)));
      }
    }
  }
}

// Welding two corners into one harms no edge.
void PartDuplicatesTest::cubesSharingAVertexStay() {
  const HalfEdgeMesh before = buildMesh(test::twoCubesSharingAVertex()).mesh;
  HalfEdgeMesh mesh = before;
  QVERIFY(partDuplicates(mesh, NumberType::Float32).empty());
  QVERIFY(test::sameMesh(mesh, before));
}

void PartDuplicatesTest::soundMeshesStay() {
  for (const TriangleSoup& s : {test::cube(), test::torus(8, 6), test::disc(8, 3)}) {
    const HalfEdgeMesh before = buildMesh(s).mesh;
    HalfEdgeMesh mesh = before;
    QVERIFY(partDuplicates(mesh, NumberType::Float32).empty());
    QVERIFY(test::sameMesh(mesh, before));
  }
}

// Tetrahedra around an axis, each closed; in the file the axis has all their faces.
void PartDuplicatesTest::cakeOfWedges() {
  for (int n = 2; n <= 6; ++n) {
    TriangleSoup s;
    for (int i = 0; i < n; ++i) {
      const double u = 2 * M_PI * i / n, v = 2 * M_PI * (i + 0.6) / n;
      TriangleSoup wedge = test::tetrahedron();
      wedge.points = {Vec3(3, 3, 3), Vec3(3 + std::cos(u), 3 + std::sin(u), 3.5),
                      Vec3(3 + std::cos(v), 3 + std::sin(v), 3.5), Vec3(3, 3, 4)};
      for (Vec3& p : wedge.points) p = rounded(p, NumberType::Float32);
      test::append(s, wedge);
    }
    HalfEdgeMesh mesh = buildMesh(s).mesh;
    partDuplicates(mesh, NumberType::Float32);
    QCOMPARE(validate(mesh), std::string());
    const TriangleSoup written = asWritten(mesh, NumberType::Float32);
    QVERIFY2(test::countEdges(written).sound(), qPrintable(QString("%1 wedges").arg(n)));
    QCOMPARE(intersections(written), std::size_t{0});
  }
}

void PartDuplicatesTest::randomCells() {
  QVERIFY(rc::check("blocks that touch at edges and corners come apart without crossing", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    HalfEdgeMesh mesh = buildMesh(test::randomBlocks(random, *rc::gen::inRange<std::size_t>(2, 20), 3)).mesh;
    RC_ASSERT(test::countBorder(mesh) == std::size_t{0});
    const std::size_t before = intersections(mesh.compact().soup);
    partDuplicates(mesh, NumberType::Float32);
    RC_ASSERT(validate(mesh) == std::string());
    const TriangleSoup written = asWritten(mesh, NumberType::Float32);
    RC_ASSERT(test::countEdges(written).sound());
    RC_ASSERT(intersections(written) <= before);
  }));
}

HANDWHEEL_TEST(PartDuplicatesTest)
#include "PartDuplicatesTest.moc"
