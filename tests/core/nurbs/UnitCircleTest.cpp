// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "nurbs/UnitCircle.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

class UnitCircleTest : public QObject {
  Q_OBJECT

 private slots:
  void isExact();
  void speedIsItsDerivative();
};

void UnitCircleTest::isExact() {
  for (int i = 0; i <= 4000; ++i) {
    const auto p = unit_circle::at(i / 4000.0);
    QVERIFY(std::abs(p.direction.norm() - 1.0) < 4e-16);
  }
  const double s = std::sqrt(0.5);
  QVERIFY((unit_circle::at(0.125).direction - Eigen::Vector2d(s, s)).norm() < 1e-15);
  QCOMPARE(unit_circle::at(0.25).direction, Eigen::Vector2d(0, 1));
  QCOMPARE(unit_circle::at(0.5).direction, Eigen::Vector2d(-1, 0));
  QCOMPARE(unit_circle::at(0.75).direction, Eigen::Vector2d(0, -1));
  QCOMPARE(unit_circle::at(1.0).direction, Eigen::Vector2d(1, 0));
}

void UnitCircleTest::speedIsItsDerivative() {
  for (int i = 1; i < 400; ++i) {
    if (i % 100 == 0) continue;  // the second derivative leaps there
    const double u = i / 400.0, h = 1e-5;
    const Eigen::Vector2d slope = (unit_circle::at(u + h).direction - unit_circle::at(u - h).direction) / (2 * h);
    QVERIFY(std::abs(unit_circle::at(u).speed - slope.norm()) < 1e-6);
  }
}

HANDWHEEL_TEST(UnitCircleTest)
#include "UnitCircleTest.moc"
