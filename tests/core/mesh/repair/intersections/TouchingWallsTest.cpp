// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/TouchingWalls.h"

#include "../../SoupsTogether.h"
#include "MeshShapes.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;

namespace {

TriangleSoup inFloats(TriangleSoup soup) {
  for (Vec3& p : soup.points) p = rounded(p, NumberType::Float32);
  return soup;
}

std::size_t touching(const TriangleSoup& a, const TriangleSoup& b) {
  return findTouchingWalls(inFloats(test::together({a, b}))).size();
}

}  // namespace

class TouchingWallsTest : public QObject {
  Q_OBJECT

 private slots:
  // The diagonals of the two walls of a cube cross, so that both triangles overlap both others.
  void boxes() {
    const TriangleSoup cube = test::box({0, 0, 0}, {1, 1, 1});
    const auto beside = [&](double x, double y) { return touching(cube, test::box({x, y, 0.2}, {1, 1, 1})); };
    QVERIFY(beside(1.0, 0.3) >= 2 && beside(1.0, 0.3) <= 4);
    QCOMPARE(beside(1.0 + 1e-6, 0.3), beside(1.0, 0.3));  // floats at 1 are 1.2e-7 apart
    QCOMPARE(beside(1.0 - 1e-6, 0.3), beside(1.0, 0.3));
    QCOMPARE(beside(1.0 + 1e-4, 0.3), std::size_t{0});
    QCOMPARE(beside(1.0, 1.0), std::size_t{0});                                           // only an edge in common
    QCOMPARE(touching(cube, test::box({0, 0.3, 0.2}, {0.5, 0.2, 0.2})), std::size_t{0});  // faces the same direction
  }

  void noWalls() {
    QVERIFY(findTouchingWalls({}).empty());
    QVERIFY(findTouchingWalls(test::icosphere(3)).empty());
    QVERIFY(
        findTouchingWalls({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 0, 1}, {0, 3, 1}}}).empty());
  }

  void cancelled() {
    JobState state;
    state.cancelled = true;
    QVERIFY(findTouchingWalls(test::icosphere(3), Progress(state)).empty());
  }
};

HANDWHEEL_TEST(TouchingWallsTest)
#include "TouchingWallsTest.moc"
