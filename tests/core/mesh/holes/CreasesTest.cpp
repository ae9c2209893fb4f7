// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/Creases.h"

#include "CreasedShapes.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

namespace {

HoleContext creasesHoleIn(const TriangleSoup& part, const Vec3& centre, double radius) {
  const HalfEdgeMesh mesh = buildMesh(test::withHole(part, centre, radius)).mesh;
  return holeContext(mesh, findBoundaryLoops(mesh).at(0));
}

}  // namespace

class CreasesTest : public QObject {
  Q_OBJECT

 private slots:
  void findsTheEndsOnACube();
  void tellsConvexFromConcave();
  void anglesBelowAreSmooth();
  void followsTheLoopAlongTheCrease();
};

void CreasesTest::findsTheEndsOnACube() {
  const HoleContext hole = creasesHoleIn(test::roughCube(20, 5), Vec3(1, 1, 0), 0.3);
  const std::vector<CreaseEnd> ends = findCreaseEnds(hole, tolerance::kCreaseAngle);
  QCOMPARE(ends.size(), std::size_t{2});
  for (const CreaseEnd& end : ends) {
    const Vec3& p = hole.points[end.chain[0]];
    QVERIFY(end.chain[0] < hole.loopSize);
    QVERIFY((p - Vec3(1, 1, p.z())).norm() < 1e-12);
    QVERIFY((end.direction - Vec3(0, 0, p.z() > 0.0 ? -1 : 1)).norm() < 1e-9);
    QVERIFY(std::abs(end.angle - M_PI / 2.0) < 1e-9);
  }
  QVERIFY(findCreaseEnds(creasesHoleIn(test::roughCube(20, 5), Vec3(1, 0, 0), 0.3), tolerance::kCreaseAngle).empty());
}

void CreasesTest::tellsConvexFromConcave() {
  const HoleContext hole = creasesHoleIn(test::turnedOver(test::roughCube(20, 5)), Vec3(1, 1, 0), 0.3);
  const std::vector<CreaseEnd> ends = findCreaseEnds(hole, tolerance::kCreaseAngle);
  QCOMPARE(ends.size(), std::size_t{2});
  for (const CreaseEnd& end : ends) QVERIFY(std::abs(end.angle + M_PI / 2.0) < 1e-9);
}

void CreasesTest::anglesBelowAreSmooth() {
  const HoleContext hole = creasesHoleIn(test::roughCube(20, 5), Vec3(1, 1, 0), 0.3);
  QCOMPARE(findCreaseEnds(hole, 1.57).size(), std::size_t{2});
  QVERIFY(findCreaseEnds(hole, 1.58).empty());
}

// A corner of the hole on the crease, from which only one side goes on: the end is where the other side begins.
void CreasesTest::followsTheLoopAlongTheCrease() {
  TriangleSoup part = test::roughCube(20, 0);
  std::erase_if(part.triangles, [&](const Triangle& t) {
    const Vec3 middle = (part.points[t[0]] + part.points[t[1]] + part.points[t[2]]) / 3.0;
    const bool onX = middle.x() > 0.999, onY = middle.y() > 0.999;
    const double half = onX ? 0.4 : 0.2;  // taller on the side x = 1
    return (onX || onY) && middle.x() > 0.7 && middle.y() > 0.7 && std::abs(middle.z()) < half;
  });
  const HalfEdgeMesh mesh = buildMesh(part).mesh;
  const HoleContext hole = holeContext(mesh, findBoundaryLoops(mesh).at(0));
  const std::vector<CreaseEnd> ends = findCreaseEnds(hole, tolerance::kCreaseAngle);
  QCOMPARE(ends.size(), std::size_t{2});
  for (const CreaseEnd& end : ends) {
    QVERIFY(std::abs(std::abs(hole.points[end.chain[0]].z()) - 0.2) < 1e-9);
    QVERIFY(end.chain[1] < hole.loopSize && end.chain[2] < hole.loopSize);
  }
}

HANDWHEEL_TEST(CreasesTest)
#include "CreasesTest.moc"
