// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/device/DeviceMotionEstimator.h"

#include <QtTest>
#include <limits>

using namespace handwheel;

namespace {

DeviceState at(double x, std::uint32_t reading) {
  DeviceState state;
  state.position = Vec3(x, 0, 0);
  state.reading = reading;
  state.status = DeviceStatus::Ready;
  return state;
}

}  // namespace

class DeviceMotionEstimatorTest : public QObject {
  Q_OBJECT

 private slots:
  // A device of 1 kHz read at 4 kHz, at 200 mm/s: the velocity is that of its readings, and holds between them.
  void onlyNewReadingsCount() {
    DeviceMotionEstimator motion(0.01, {0.00025, 0.001, 0.005});
    for (std::uint32_t i = 0; i < 400; ++i) {
      const std::uint32_t number = i / 4 + 1;
      const DeviceMotionEstimator::Seen seen = motion.add(at(0.2 * number, number), 0.00025);
      QCOMPARE(seen.isNew, i % 4 == 0);
      if (i < 8) continue;
      QVERIFY((seen.velocity - Vec3(200, 0, 0)).norm() < 1e-9);
      QVERIFY(std::abs(seen.stepSpeed - (seen.isNew ? 200.0 : 0.0)) < 1e-9);
    }
  }

  // The velocity that the device reports is used unless it is stale.
  void anOldVelocityIsNone() {
    DeviceMotionEstimator motion(0.01, {0.001, 0.001, 0.005});
    DeviceState state = at(0.0, 1);
    state.hasVelocity = true;
    state.velocity = Vec3(0, 70, 0);
    QCOMPARE(motion.add(state, 0.001).velocity, Vec3(0, 70, 0));
    for (int i = 1; i <= 20; ++i) {
      const DeviceMotionEstimator::Seen seen = motion.add(state, 0.001);
      QVERIFY(!seen.isNew);
      QCOMPARE(seen.velocity, i <= 5 ? Vec3(0, 70, 0) : Vec3(0, 0, 0));
    }
    ++state.reading;
    QVERIFY(motion.add(state, 0.001).isNew);
    QCOMPARE(motion.add(state, 0.001).velocity, Vec3(0, 70, 0));
  }

  // After 50 ms of silence 10 mm on: 200 mm/s. Two readings at once count with the time that the device takes for two.
  void theTimeIsThatBetweenTheReadings() {
    DeviceMotionEstimator motion(0.01, {0.001, 0.001, 0.005});
    QCOMPARE(motion.add(at(0.0, 7), 0.001).stepSpeed, 0.0);
    for (int i = 1; i < 50; ++i) motion.add(at(0.0, 7), 0.001);
    QVERIFY(std::abs(motion.add(at(10.0, 8), 0.001).stepSpeed - 200.0) < 1e-9);
    QVERIFY(std::abs(motion.add(at(12.0, 10), 0.001).stepSpeed - 1000.0) < 1e-9);
    // The count wraps around.
    motion.reset();
    const std::uint32_t last = std::numeric_limits<std::uint32_t>::max();
    QCOMPARE(motion.add(at(0.0, last), 0.001).stepSpeed, 0.0);
    QVERIFY(std::abs(motion.add(at(1.0, 1), 0.001).stepSpeed - 500.0) < 1e-9);
  }

  // A reading without a count is always new.
  void withoutACountEachIsNew() {
    DeviceMotionEstimator motion(0.01, {0.001, 0.001, 0.005});
    for (int i = 0; i < 30; ++i) QVERIFY(motion.add(at(1.0, 0), 0.001).isNew);
    QVERIFY(std::abs(motion.add(at(41.0, 0), 0.001).stepSpeed - 40000.0) < 1e-6);
  }
};

HANDWHEEL_TEST(DeviceMotionEstimatorTest)
#include "DeviceMotionEstimatorTest.moc"
