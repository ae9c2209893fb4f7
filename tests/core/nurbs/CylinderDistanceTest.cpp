// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "nurbs/CylinderDistance.h"

#include <MeshShapes.h>
#include <QTest>
#include <cmath>

using namespace handwheel;

class CylinderDistanceTest : public QObject {
  Q_OBJECT

 private slots:
  void knownTriangles();
  void aPrism();
  void outside();
};

void CylinderDistanceTest::knownTriangles() {
  const StockCylinder c{2, 4, 0};  // radius 1
  const auto distance = [&](const Vec3& p, const Vec3& q, const Vec3& r) {
    return distanceToCylinder({{p, q, r}, {{0, 1, 2}}}, c);
  };
  // A chord over a quarter of the mantle: 1 - √½. In an end: nothing. Parallel to one, half in: 0.25.
  QVERIFY(std::abs(distance({1, 0, 1}, {0, 1, 1}, {0, 1, 3}) - (1 - std::sqrt(0.5))) < 1e-15);
  QCOMPARE(distance({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0.0);
  QCOMPARE(distance({0, 0, 3.75}, {1, 0, 3.75}, {0, 1, 3.75}), 0.25);
  // Round the axis in the middle: as far as can be, a radius.
  QCOMPARE(distance({1, 0, 2}, {-0.5, std::sqrt(0.75), 2}, {-0.5, -std::sqrt(0.75), 2}), 1.0);
}

void CylinderDistanceTest::aPrism() {
  // A square inside: its sides are r(1 - cos 45°) from the mantle, its ends lie in the ends.
  TriangleSoup prism = test::cube();
  for (Vec3& p : prism.points) p = Vec3((p.x() - 0.5) * std::sqrt(2.0), (p.y() - 0.5) * std::sqrt(2.0), 7.0 * p.z());
  QVERIFY(std::abs(distanceToCylinder(prism, {2, 7, 0}) - (1 - std::sqrt(0.5))) < 1e-15);
}

void CylinderDistanceTest::outside() {
  const StockCylinder c{2, 4, 10};
  const auto distance = [&](const Vec3& p) { return distanceToCylinder({{p, p, p}, {{0, 1, 2}}}, c); };
  QCOMPARE(distance({4, 5, 12}), std::sqrt(41.0) - 1.0);
  QCOMPARE(distance({0, 0, 17}), 3.0);
  QCOMPARE(distance({0, 4, 18}), 5.0);  // 3 beside and 4 above the rim
  QCOMPARE(distance({0, 4, 6}), 5.0);
  QCOMPARE(distanceToCylinder({}, c), 0.0);
}

HANDWHEEL_TEST(CylinderDistanceTest)
#include "CylinderDistanceTest.moc"
