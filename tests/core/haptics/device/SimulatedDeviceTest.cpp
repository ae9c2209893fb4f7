// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/device/SimulatedDevice.h"

#include <QtTest>
#include <cmath>
#include <random>

#include "HapticDevices.h"
#include "TestClass.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Returns 0.1 kg with 2 N·s/m, in nobody's hand.
SimulatedDeviceSettings loose(double friction = 0.002) {
  SimulatedDeviceSettings settings = simulatedDevice();
  settings.capabilities.inherentDamping = friction;
  settings.grip = {0.0, 0.0, 0.0, 0.0};
  return settings;
}

std::int64_t nanoseconds(double seconds) {
  return std::llround(seconds * 1e9);
}

}  // namespace

class SimulatedDeviceTest : public QObject {
  Q_OBJECT

 private slots:
  void isAbsentUntilOpen() {
    VirtualClock clock;
    SimulatedDevice device(loose(), PoseTrajectory({{0.0, {1, 2, 3}}}), clock);
    QVERIFY(device.read().status == DeviceStatus::Absent);
    QVERIFY(device.open(Progress()).hasValue());
    QVERIFY(device.read().status == DeviceStatus::Ready);
    QCOMPARE(device.read().position, Vec3(1, 2, 3));
    device.close();
    QVERIFY(device.read().status == DeviceStatus::Absent);
  }

  // v(t) = u + (v0 - u)·exp(-b·t/m) with u = F/b, for any sampling; friction 0 as its limit.
  void aPushedMassMovesAsTheSolution_data() {
    QTest::addColumn<double>("friction");
    QTest::newRow("2 N·s/m") << 0.002;
    QTest::newRow("next to none") << 1e-9;
    QTest::newRow("none") << 0.0;
    QTest::newRow("much") << 1.0;
  }
  void aPushedMassMovesAsTheSolution() {
    QFETCH(double, friction);
    VirtualClock clock;
    SimulatedDevice device(loose(friction), PoseTrajectory({{0.0, {0, 0, 0}}}), clock);
    QVERIFY(device.open(Progress()).hasValue());
    device.setStart({1, 0, 0}, {0, 50, 0});
    device.read();
    device.write({{0.3, 0, 0}, Vec3::Zero(), 0.0});
    std::mt19937 random(7);
    const double mass = 1e-4;  // N·s²/mm
    for (double t = 0.0; t < 0.5;) {
      t += std::uniform_real_distribution<double>(1e-5, 5e-3)(random);
      clock.set(nanoseconds(t));
      const double time = static_cast<double>(nanoseconds(t)) * 1e-9;
      const double e = std::exp(-friction * time / mass);
      // A series is used where the closed form has no digits left.
      const bool isFree = friction < 1e-8;
      const double z = friction * time / mass;
      const double x = isFree ? 0.5 * 0.3 / mass * time * time * (1 - z / 3)
                              : 0.3 / friction * time - 0.3 / friction * mass / friction * (1 - e);
      const double y = isFree ? 50 * time * (1 - z / 2) : 50 * mass / friction * (1 - e);
      const Vec3 expected(1 + x, y, 0);
      QVERIFY((device.read().position - expected).norm() <= 1e-8 * (1.0 + expected.norm()));
    }
  }

  // Held by a spring and a damper: the step response of a damped oscillator, to the second order of the steps.
  void aHandPullsAsAnOscillator() {
    SimulatedDeviceSettings settings = loose(0.0005);
    settings.grip = {0.2, 0.0015, 0.0, 100.0};
    VirtualClock clock;
    SimulatedDevice device(settings, PoseTrajectory({{0.0, {5, 0, 0}}}), clock);
    QVERIFY(device.open(Progress()).hasValue());
    device.setStart({0, 0, 0}, {0, 0, 0});
    device.read();
    const double mass = 1e-4, half = 0.5 * 0.002 / mass, omega = std::sqrt(0.2 / mass - half * half);
    for (int i = 1; i <= 400; ++i) {
      clock.set(i * kMillisecond);
      const double t = i * 0.001;
      const double x = 5.0 - 5.0 * std::exp(-half * t) * (std::cos(omega * t) + half / omega * std::sin(omega * t));
      QVERIFY(qAbs(device.read().position.x() - x) < 2e-3);
    }
  }

  // 2 N hold the hand 2/k off, unless it has an integral part: that brings it back.
  void theIntegralTakesTheOffsetAway() {
    for (const double integral : {0.0, 2.0}) {
      SimulatedDeviceSettings settings = loose();
      settings.grip = {0.5, 0.01, integral, 100.0};
      VirtualClock clock;
      SimulatedDevice device(settings, PoseTrajectory({{0.0, {0, 0, 0}}}), clock);
      QVERIFY(device.open(Progress()).hasValue());
      device.read();
      device.write({{2, 0, 0}, Vec3::Zero(), 0.0});
      clock.set(nanoseconds(10.0));
      QVERIFY(qAbs(device.read().position.x() - (integral == 0.0 ? 4.0 : 0.0)) < 1e-3);
    }
  }

  // A hand yields: against 5 N with at most 3 the tip goes with the 5.
  void aHandIsOnlySoStrong() {
    SimulatedDeviceSettings settings = loose();
    settings.grip = {1.0, 0.01, 0.0, 3.0};
    VirtualClock clock;
    SimulatedDevice device(settings, PoseTrajectory({{0.0, {0, 0, 0}}}), clock);
    QVERIFY(device.open(Progress()).hasValue());
    device.read();
    device.write({{5, 0, 0}, Vec3::Zero(), 0.0});
    clock.set(nanoseconds(2.0));
    QVERIFY(device.read().position.x() > 10.0);
  }

  // Forces act 7 ms late and not before; they arrive in their order.
  void aForceActsLate() {
    SimulatedDeviceSettings settings = loose();
    settings.capabilities.latency = 0.007;
    VirtualClock clock;
    SimulatedDevice device(settings, PoseTrajectory({{0.0, {0, 0, 0}}}), clock);
    QVERIFY(device.open(Progress()).hasValue());
    device.read();
    device.write({{1, 0, 0}, Vec3::Zero(), 0.0});
    clock.set(kMillisecond);
    device.read();
    device.write({});
    clock.set(7 * kMillisecond);
    QCOMPARE(device.read().position, Vec3(0, 0, 0));
    clock.set(8 * kMillisecond);
    // The force is 1 ms of 1 N from rest, then the mass coasts.
    const double mass = 1e-4, b = 0.002, e = std::exp(-b * 0.001 / mass);
    const double x = 0.001 / b - mass / (b * b) * (1 - e), v = (1 - e) / b;
    QVERIFY(qAbs(device.read().position.x() - x) < 1e-9);
    clock.set(9 * kMillisecond);
    QVERIFY(qAbs(device.read().position.x() - (x + v * mass / b * (1 - e))) < 1e-9);
  }

  void commandedIsExact() {
    SimulatedDeviceSettings settings = simulatedDevice();
    settings.isCommanded = true;
    const PoseTrajectory path({{0.0, {0, 0, 0}}, {1.0, {3, 7, -1}, Eigen::Quaterniond::Identity(), 2}});
    VirtualClock clock;
    SimulatedDevice device(settings, path, clock);
    QVERIFY(device.open(Progress()).hasValue());
    for (int i = 0; i <= 1100; ++i) {
      clock.set(i * kMillisecond);
      const DeviceState state = device.read();
      QCOMPARE(state.position, path.at(static_cast<double>(clock.now()) / 1e9).position);
      device.write({{100, 0, 0}, Vec3::Zero(), 0.0});
    }
    QCOMPARE(device.read().buttons, 2u);
  }

  void withoutAPathTheHandGoesToItsTarget() {
    VirtualClock clock;
    SimulatedDevice device(simulatedDevice(), PoseTrajectory(), clock);
    device.setTarget({0.0, {1, 1, 1}});
    QVERIFY(device.open(Progress()).hasValue());
    QCOMPARE(device.read().position, Vec3(1, 1, 1));
    device.setTarget({0.0, {4, 1, 1}, Eigen::Quaterniond::Identity(), 1});
    clock.set(nanoseconds(5.0));
    const DeviceState state = device.read();
    QVERIFY((state.position - Vec3(4, 1, 1)).norm() < 1e-6);
    QCOMPARE(state.buttons, 1u);
  }

  // A clock that goes back moves nothing, and a step of an hour ends finite.
  void theClockJumps() {
    VirtualClock clock;
    SimulatedDevice device(simulatedDevice(), PoseTrajectory({{0.0, {0, 0, 0}}}), clock);
    QVERIFY(device.open(Progress()).hasValue());
    device.setStart({2, 0, 0}, {0, 0, 0});
    device.read();
    clock.set(10 * kMillisecond);
    const Vec3 there = device.read().position;
    clock.set(0);
    QCOMPARE(device.read().position, there);
    clock.set(nanoseconds(3600.0));
    QVERIFY(device.read().position.allFinite());
  }
};

HANDWHEEL_TEST(SimulatedDeviceTest)
#include "SimulatedDeviceTest.moc"
