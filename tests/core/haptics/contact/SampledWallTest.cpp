// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <cmath>

#include "HapticDevices.h"
#include "TestClass.h"
#include "haptics/device/SimulatedDevice.h"
#include "haptics/safety/StiffnessLimit.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kPeriod = 0.001;  // s

// A sampled wall without any loop around it. Stiffness and damping in N/m and N·s/m here, the units of the literature.
struct Wall {
  double friction = 0.5;  // b of the device
  double delay = 0.0;     // s
  double damping = 0.0;   // B of the wall
  double seconds = 20.0;  // observed time
};

// Returns true if the swings shrink of a mass of 0.1 kg that sticks to the wall from both sides, let go at 100 mm/s.
bool isStable(const Wall& wall, double stiffness) {
  SimulatedDeviceSettings settings = simulatedDevice();
  settings.capabilities.inherentDamping = wall.friction / 1000.0;
  settings.capabilities.latency = wall.delay;
  settings.grip = {0.0, 0.0, 0.0, 0.0};
  VirtualClock clock;
  SimulatedDevice device(settings, PoseTrajectory(), clock);
  device.setStart(Vec3::Zero(), {100, 0, 0});
  if (!device.open(Progress())) return false;
  const int ticks = static_cast<int>(wall.seconds / kPeriod);
  double last = 0.0, early = 0.0, late = 0.0;
  for (int i = 0; i < ticks; ++i) {
    clock.set(i * kMillisecond);
    const double x = device.read().position.x();
    device.write({{-(stiffness * x + wall.damping * (x - last) / kPeriod) / 1000.0, 0, 0}, Vec3::Zero(), 0.0});
    last = x;
    if (i >= ticks / 4 && i < ticks / 2) early = std::max(early, std::abs(x));
    if (i >= ticks * 3 / 4) late = std::max(late, std::abs(x));
    if (std::abs(x) > 1e9) return false;
  }
  return late <= early;
}

double largestStableStiffness(const Wall& wall) {
  double stable = 0.0, unstable = 1e5;
  while (unstable - stable > 1e-3 * unstable) {
    const double middle = 0.5 * (stable + unstable);
    (isStable(wall, middle) ? stable : unstable) = middle;
  }
  return stable;
}

// Returns the stiffness in N/m that the program allows.
double rule(const Wall& wall) {
  return 1000.0 * stiffnessLimit({kPeriod, wall.delay, wall.friction / 1000.0}, wall.damping / 1000.0);
}

}  // namespace

class SampledWallTest : public QObject {
  Q_OBJECT

 private slots:
  // b in N·s/m, delay in s, and the largest stable stiffness in N/m that an independent program found (exact
  // zero-order-hold simulation of 0.1 kg at 1 kHz).
  void theRuleIsKept_data() {
    QTest::addColumn<double>("friction");
    QTest::addColumn<double>("delay");
    QTest::addColumn<double>("independent");
    QTest::addColumn<double>("seconds");
    QTest::newRow("0.5, 0") << 0.5 << 0.0 << 1000.8 << 20.0;
    QTest::newRow("0.5, 1 ms") << 0.5 << 0.001 << 333.8 << 20.0;
    QTest::newRow("2, 0") << 2.0 << 0.0 << 4013.0 << 20.0;
    QTest::newRow("2, 5 ms") << 2.0 << 0.005 << 370.0 << 20.0;
    QTest::newRow("2, 10 ms") << 2.0 << 0.01 << 197.0 << 20.0;
    QTest::newRow("5, 50 ms") << 5.0 << 0.05 << 124.5 << 60.0;
    QTest::newRow("5, 100 ms") << 5.0 << 0.1 << 67.6 << 60.0;
    QTest::newRow("5, 250 ms") << 5.0 << 0.25 << 29.2 << 120.0;
    QTest::newRow("5, 500 ms") << 5.0 << 0.5 << 15.1 << 240.0;
    QTest::newRow("20, 500 ms") << 20.0 << 0.5 << 62.2 << 240.0;
  }
  void theRuleIsKept() {
    QFETCH(double, friction);
    QFETCH(double, delay);
    QFETCH(double, independent);
    QFETCH(double, seconds);
    const Wall bare{friction, delay, 0.0, seconds};
    const double measured = largestStableStiffness(bare);
    QVERIFY2(measured >= rule(bare), qPrintable(QString("%1 below %2").arg(measured).arg(rule(bare))));
    QVERIFY2(qAbs(measured / independent - 1.0) < 0.02, qPrintable(QString::number(measured)));
    // The wall has damping, too; of either sign, since a lagging estimate may reverse it.
    for (const double share : {-0.5, 0.25, 0.5, 0.9}) {
      const Wall damped{friction, delay, share * friction, seconds};
      QVERIFY2(isStable(damped, rule(damped)), qPrintable(QString("B = %1 b").arg(share)));
    }
  }
};

HANDWHEEL_TEST(SampledWallTest)
#include "SampledWallTest.moc"
