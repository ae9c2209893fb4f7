// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/Islands.h"

#include "HandWorkChecks.h"
#include "HoleShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/boundary/Peninsulas.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

class IslandsTest : public QObject {
  Q_OBJECT

 private slots:
  void island();
  void noIsland_data();
  void noIsland();
  void peninsula_data();
  void peninsula();
  void noPeninsula_data();
  void noPeninsula();
  void pinchedAndOneSided();
  void cancelled();
};

namespace {

BoundaryLoop holeOf(const HalfEdgeMesh& mesh) {
  BoundaryLoop hole;
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh))
    if (!loop.isSheetBoundary && loop.halfEdges.size() > hole.halfEdges.size()) hole = loop;
  return hole;
}

double areaOf(const HalfEdgeMesh& mesh, const FaceSelection& faces) {
  double sum = 0.0;
  faces.forEach([&](Face f) {
    const TrianglePoints p = mesh.points(f);
    sum += 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
  });
  return sum;
}

std::size_t halfSquares(const TriangleSoup& soup) {
  return static_cast<std::size_t>(std::lround(2.0 * test::area(soup)));
}

}  // namespace

void IslandsTest::island() {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const HalfEdgeMesh mesh = buildMesh(test::moved(test::plateWithIsland(), Vec3::Zero(), scale)).mesh;
    const auto loops = findBoundaryLoops(mesh);
    const FaceSelection islands = findIslands(mesh, holeOf(mesh), loops);
    // Half squares whose middles are within 2 of the origin.
    const std::size_t island =
        2 * 400 - halfSquares(test::plateWithout(20, [](double x, double y) { return std::hypot(x, y) <= 2.0; }));
    QCOMPARE(islands.count(), island);
    HalfEdgeMesh without = mesh;
    removeFaces(without, islands);
    QCOMPARE(test::worse(mesh, without), std::string());
    QCOMPARE(test::pieces(buildMesh(without.compact().soup).mesh).size(), std::size_t(1));
  }
}

void IslandsTest::noIsland_data() {
  QTest::addColumn<TriangleSoup>("soup");
  QTest::newRow("none") << test::plateWithHole();
  QTest::newRow("tongue") << test::plateWithTongue();
  // A patch far above the hole, and one that reaches over its edge.
  TriangleSoup above = test::plateWithHole();
  test::append(above, test::moved(test::disc(8, 2), Vec3(0, 0, 4)));
  QTest::newRow("above") << above;
  TriangleSoup over = test::plateWithHole();
  test::append(over, test::moved(test::disc(8, 2, 1.5), Vec3(1, 0, 0.2)));
  QTest::newRow("over the edge") << over;
  TriangleSoup ball = test::plateWithHole();
  test::append(ball, test::moved(test::icosphere(1), Vec3::Zero()));
  QTest::newRow("closed") << ball;
}

void IslandsTest::noIsland() {
  QFETCH(TriangleSoup, soup);
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const auto loops = findBoundaryLoops(mesh);
  QVERIFY(findIslands(mesh, holeOf(mesh), loops).empty());
  // A piece over a sheet is in no hole of it.
  for (const BoundaryLoop& loop : loops) QVERIFY(!loop.isSheetBoundary || findIslands(mesh, loop, loops).empty());
}

void IslandsTest::peninsula_data() {
  QTest::addColumn<TriangleSoup>("soup");
  QTest::addColumn<double>("least");  // least share of its area
  QTest::addColumn<double>("most");
  QTest::newRow("tongue") << test::plateWithTongue() << 14.0 << 16.5;
  QTest::newRow("mushroom") << test::plateWithout(20, [](double x, double y) {
    const bool inHole = std::max(std::abs(x), std::abs(y)) < 6.0;
    return inHole && !(std::abs(y) < 1.0 && x < -3.0) && !(x > -3.0 && x < 2.0 && std::abs(y) < 3.0);
  }) << 30.0 << 36.5;
  QTest::newRow("two tongues") << test::plateWithout(20, [](double x, double y) {
    return std::max(std::abs(x), std::abs(y)) < 6.0 && !(std::abs(std::abs(y) - 3.0) < 1.0 && x < 2.0);
  }) << 28.0 << 33.0;
}

void IslandsTest::peninsula() {
  QFETCH(TriangleSoup, soup);
  QFETCH(double, least);
  QFETCH(double, most);
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const FaceSelection found = findPeninsulas(mesh, holeOf(mesh));
  const double area = areaOf(mesh, found);
  QVERIFY2(area >= least && area <= most, qPrintable(QString::number(area)));
  found.forEach([&](Face f) {
    for (const Vec3& p : mesh.points(f)) QVERIFY(std::max(std::abs(p.x()), std::abs(p.y())) <= 6.0);
  });
  HalfEdgeMesh without = mesh;
  removeFaces(without, found);
  QCOMPARE(test::worse(mesh, without), std::string());
  QVERIFY(findPeninsulas(without, holeOf(without)).empty());
}

void IslandsTest::noPeninsula_data() {
  QTest::addColumn<TriangleSoup>("soup");
  QTest::newRow("square hole") << test::plateWithHole();
  QTest::newRow("round holes in a sphere") << test::sphereWithHoles(3, 4, 0.4);
  // Narrow across the hole, not across the surface.
  QTest::newRow("slot") << test::plateWithout(20,
                                              [](double x, double y) { return std::abs(x) < 1 && std::abs(y) < 6; });
  QTest::newRow("dumbbell") << test::plateWithout(20, [](double x, double y) {
    return (std::abs(x) < 6 && std::abs(x) > 2 && std::abs(y) < 4) || (std::abs(x) < 3 && std::abs(y) < 1);
  });
  QTest::newRow("low bump") << test::plateWithout(20, [](double x, double y) {
    return std::max(std::abs(x), std::abs(y)) < 6.0 && !(std::abs(y) < 3.0 && x < -3.0);
  });
  QTest::newRow("ends of a tube") << test::cylinder(16, 5, 1.0, 3.0, false);
}

void IslandsTest::noPeninsula() {
  QFETCH(TriangleSoup, soup);
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  QVERIFY(!loops.empty());
  for (const BoundaryLoop& loop : loops) QVERIFY(findPeninsulas(mesh, loop).empty());
}

void IslandsTest::pinchedAndOneSided() {
  for (const TriangleSoup& soup : {test::plateWithPinchedHole(), test::moebiusStrip(24, 1), test::disc(3, 2)}) {
    const HalfEdgeMesh mesh = buildMesh(soup).mesh;
    const auto loops = findBoundaryLoops(mesh);
    QVERIFY(!loops.empty());
    for (const BoundaryLoop& loop : loops) {
      HalfEdgeMesh without = mesh;
      FaceSelection all = findPeninsulas(mesh, loop);
      all.add(findIslands(mesh, loop, loops));
      QVERIFY(all.count() < mesh.liveFaceCount());
      removeFaces(without, all);
      QCOMPARE(validate(without), std::string());
    }
  }
}

void IslandsTest::cancelled() {
  JobState state;
  state.cancelled = true;
  const HalfEdgeMesh mesh = buildMesh(test::plateWithIsland()).mesh;
  QVERIFY(findIslands(mesh, holeOf(mesh), findBoundaryLoops(mesh), Progress(state)).empty());
  QVERIFY(findPeninsulas(mesh, holeOf(mesh), Progress(state)).empty());
}

HANDWHEEL_TEST(IslandsTest)
#include "IslandsTest.moc"
