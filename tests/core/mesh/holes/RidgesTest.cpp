// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/Ridges.h"

#include "MeshShapes.h"
#include "RidgedShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

namespace {

HoleContext ridgesHoleIn(const TriangleSoup& part, const Vec3& place, double radius) {
  const HalfEdgeMesh mesh = buildMesh(test::withHole(part, place, radius)).mesh;
  return holeContext(mesh, findBoundaryLoops(mesh).at(0));
}

}  // namespace

class RidgesTest : public QObject {
  Q_OBJECT

 private slots:
  void findsTheEndsOnACube();
  void tellsRidgesFromValleys();
  void anglesBelowAreSmooth();
  void followsTheLoopAlongTheCrease();
};

void RidgesTest::findsTheEndsOnACube() {
  const HoleContext hole = ridgesHoleIn(test::roughCube(20, 5), Vec3(1, 1, 0), 0.3);
  const std::vector<RidgeEnd> ends = findRidgeEnds(hole, tolerance::kRidgeAngle);
  QCOMPARE(ends.size(), std::size_t{2});
  for (const RidgeEnd& end : ends) {
    const Vec3& p = hole.points[end.chain[0]];
    QVERIFY(end.chain[0] < hole.loopSize);
    QVERIFY((p - Vec3(1, 1, p.z())).norm() < 1e-12);
    QVERIFY((end.direction - Vec3(0, 0, p.z() > 0.0 ? -1 : 1)).norm() < 1e-9);
    QVERIFY(std::abs(end.angle - M_PI / 2.0) < 1e-9);
  }
  QVERIFY(findRidgeEnds(ridgesHoleIn(test::roughCube(20, 5), Vec3(1, 0, 0), 0.3), tolerance::kRidgeAngle).empty());
}

void RidgesTest::tellsRidgesFromValleys() {
  const HoleContext hole = ridgesHoleIn(test::turnedOver(test::roughCube(20, 5)), Vec3(1, 1, 0), 0.3);
  const std::vector<RidgeEnd> ends = findRidgeEnds(hole, tolerance::kRidgeAngle);
  QCOMPARE(ends.size(), std::size_t{2});
  for (const RidgeEnd& end : ends) QVERIFY(std::abs(end.angle + M_PI / 2.0) < 1e-9);
}

void RidgesTest::anglesBelowAreSmooth() {
  const HoleContext hole = ridgesHoleIn(test::roughCube(20, 5), Vec3(1, 1, 0), 0.3);
  QCOMPARE(findRidgeEnds(hole, 1.57).size(), std::size_t{2});
  QVERIFY(findRidgeEnds(hole, 1.58).empty());
}

// A corner of the hole on the crease, from which only one side goes on: the end is where the other side begins.
void RidgesTest::followsTheLoopAlongTheCrease() {
  TriangleSoup part = test::roughCube(20, 0);
  std::erase_if(part.triangles, [&](const Triangle& t) {
    const Vec3 middle = (part.points[t[0]] + part.points[t[1]] + part.points[t[2]]) / 3.0;
    const bool onX = middle.x() > 0.999, onY = middle.y() > 0.999;
    const double half = onX ? 0.4 : 0.2;  // taller on the side x = 1
    return (onX || onY) && middle.x() > 0.7 && middle.y() > 0.7 && std::abs(middle.z()) < half;
  });
  const HalfEdgeMesh mesh = buildMesh(part).mesh;
  const HoleContext hole = holeContext(mesh, findBoundaryLoops(mesh).at(0));
  const std::vector<RidgeEnd> ends = findRidgeEnds(hole, tolerance::kRidgeAngle);
  QCOMPARE(ends.size(), std::size_t{2});
  for (const RidgeEnd& end : ends) {
    QVERIFY(std::abs(std::abs(hole.points[end.chain[0]].z()) - 0.2) < 1e-9);
    QVERIFY(end.chain[1] < hole.loopSize && end.chain[2] < hole.loopSize);
  }
}

HANDWHEEL_TEST(RidgesTest)
#include "RidgesTest.moc"
