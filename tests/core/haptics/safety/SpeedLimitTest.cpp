// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/safety/SpeedLimit.h"

#include <QtTest>
#include <limits>

using namespace handwheel;

namespace {

SafetySettings speedLimitSettings() {
  SafetySettings s;
  s.dampingSpeed = 100.0;
  s.cutSpeed = 300.0;
  s.speedDamping = 0.02;
  return s;
}

}  // namespace

class SpeedLimitTest : public QObject {
  Q_OBJECT

 private slots:
  void dampingGrowsFromNothing() {
    const SpeedLimit limit(speedLimitSettings());
    QVERIFY(limit.damping({100, 0, 0}).isZero(0.0));
    QVERIFY(limit.damping(Vec3::Zero()).isZero(0.0));
    QVERIFY(limit.damping({100.001, 0, 0}).norm() < 1e-4);  // continuous
    QVERIFY((limit.damping({0, 200, 0}) - Vec3(0, -0.5 * 0.02 * 200.0, 0)).norm() < 1e-12);
    QVERIFY((limit.damping({0, 0, -300}) - Vec3(0, 0, 0.02 * 300.0)).norm() < 1e-12);
    QVERIFY((limit.damping({0, 0, -600}) - Vec3(0, 0, 0.02 * 600.0)).norm() < 1e-12);
  }

  // The force is cut at 300 mm/s, and not restored at 299.
  void theCutStaysUntilTheTipIsSlow() {
    SpeedLimit limit(speedLimitSettings());
    QVERIFY(!limit.cuts(299.0));
    QVERIFY(limit.cuts(300.0));
    QVERIFY(limit.cuts(150.0));
    QVERIFY(limit.cuts(100.0));
    QVERIFY(!limit.cuts(99.0));
    QVERIFY(!limit.cuts(299.0));
  }

  void hugeSpeedsAreCut() {
    SpeedLimit limit(speedLimitSettings());
    QVERIFY(limit.cuts(1e300));
    QVERIFY(limit.cuts(std::numeric_limits<double>::infinity()));
  }
};

HANDWHEEL_TEST(SpeedLimitTest)
#include "SpeedLimitTest.moc"
