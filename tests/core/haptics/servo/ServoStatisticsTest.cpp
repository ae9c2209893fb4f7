// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/servo/ServoStatistics.h"

#include <QtTest>
#include <cmath>

#include "HapticDevices.h"
#include "TestClass.h"

using namespace handwheel;

class ServoStatisticsTest : public QObject {
  Q_OBJECT

 private slots:
  // b = 5 N·s/m. Periods of 1 ms but every fiftieth of 1.5 ms, 0.25 ms from reading to writing, 1 ms in the wire.
  void theLimitFollowsWhatWasMeasured() {
    DeviceCapabilities device = test::forceDevice();
    device.latency = 0.001;
    ServoStatistics measure(device, 0.005, 0.001);
    QVERIFY(qAbs(measure.stiffnessLimit() - 0.005 / (0.001 + 0.001)) < 1e-12);  // assumed: 2 ms
    double last = measure.stiffnessLimit(), largestStep = 0.0;
    for (int i = 0; i < 20000; ++i) {
      measure.addPeriod(i % 50 == 0 ? 0.0015 : 0.001);
      measure.addDelay(0.00025);
      largestStep = std::max(largestStep, std::abs(measure.stiffnessLimit() - last));
      last = measure.stiffnessLimit();
    }
    const double expected = 0.005 / (0.00075 + 0.00125);
    QVERIFY(qAbs(measure.stiffnessLimit() / expected - 1.0) < 1e-6);
    // Followed with half a second: a tick never changes it by more than 1/500 of the whole difference.
    QVERIFY(largestStep <= 0.002 * 5.0);
  }

  void notMoreThanTheMakerStates() {
    DeviceCapabilities device = test::forceDevice();
    device.maxStiffness = 3.0;
    ServoStatistics measure(device, 0.005, 0.001);
    for (int i = 0; i < 20000; ++i) measure.addPeriod(0.001);
    QVERIFY(measure.stiffnessLimit() <= 3.0);
    QVERIFY(measure.stiffnessLimit() > 3.0 - 1e-9);
  }

  void withoutMotorsThereIsNone() {
    DeviceCapabilities device = test::forceDevice();
    device.outputs = 0;
    ServoStatistics measure(device, 0.0, 0.001);
    for (int i = 0; i < 2000; ++i) measure.addPeriod(0.001);
    QVERIFY(std::isinf(measure.stiffnessLimit()));
  }
};

HANDWHEEL_TEST(ServoStatisticsTest)
#include "ServoStatisticsTest.moc"
