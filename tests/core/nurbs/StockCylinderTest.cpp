// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "nurbs/StockCylinder.h"

#include <QTest>
#include <cmath>
#include <limits>

using namespace handwheel;

class StockCylinderTest : public QObject {
  Q_OBJECT

 private slots:
  void measures();
  void limits();
};

void StockCylinderTest::measures() {
  const StockCylinder c{20, 30, -5};
  QCOMPARE(c.volume(), M_PI * 100 * 30);
  QCOMPARE(c.area(), M_PI * 20 * 30 + 2 * M_PI * 100);
  QCOMPARE(c.bounds().min(), Vec3(-10, -10, -5));
  QCOMPARE(c.bounds().max(), Vec3(10, 10, 25));
  QVERIFY(c.profile().point(0) == ProfilePoint(10, -5));
  QVERIFY(c.profile().point(1) == ProfilePoint(10, 25));
}

void StockCylinderTest::limits() {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  QVERIFY((StockCylinder{1e-6, 1e6, -1e7}).isSound());
  QVERIFY((StockCylinder{1e6, 1e-6, 1e7}).isSound());
  for (double bad : {0.0, -1.0, 1e-7, 1.1e6, nan, inf, -inf}) {
    QVERIFY(!(StockCylinder{bad, 1, 0}).isSound());
    QVERIFY(!(StockCylinder{1, bad, 0}).isSound());
  }
  for (double bad : {1.1e7, -1.1e7, nan, inf}) QVERIFY(!(StockCylinder{1, 1, bad}).isSound());
}

HANDWHEEL_TEST(StockCylinderTest)
#include "StockCylinderTest.moc"
