// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <limits>
#include <random>

#include "TestClass.h"
#include "TickRig.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kServoTickFaultsNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

// Faults of a device, a scene and the machine that the hand must not feel.
class ServoTickFaultsTest : public QObject {
  Q_OBJECT

 private slots:
  void numbersThatAreNone_data() {
    QTest::addColumn<int>("where");
    QTest::newRow("position") << 0;
    QTest::newRow("orientation") << 1;
    QTest::newRow("velocity") << 2;
    QTest::newRow("gripper") << 3;
    QTest::newRow("orientation of zeros") << 4;
  }
  // The tip in contact, the device reports NaN: no force in that very tick, the scene never sees it, and the force
  // returns by the ramp.
  void numbersThatAreNone() {
    QFETCH(int, where);
    Rig rig;
    bool isAlwaysFinite = true;
    auto feel = wall(1.0);
    rig.channel.scenes.publish(sceneOf([&](const TipState& tip, ForceOut& out) {
      isAlwaysFinite &= tip.position.allFinite() && tip.orientation.coeffs().allFinite() && tip.velocity.allFinite();
      feel(tip, out);
    }));
    rig.pressTo(2.0);
    const DeviceState good = rig.log->state;
    DeviceState& state = rig.log->state;
    state.hasVelocity = where == 2;
    if (where == 0) state.position.y() = kServoTickFaultsNan;
    if (where == 1) state.orientation.x() = kServoTickFaultsNan;
    if (where == 2) state.velocity.z() = -std::numeric_limits<double>::infinity();
    if (where == 3) state.gripper = kServoTickFaultsNan;
    if (where == 4) state.orientation.coeffs().setZero();
    ServoSample sample = rig.run();
    QVERIFY(sample.sent.isZero());
    QVERIFY(sample.actions.has(SafetyAction::DeviceFault));
    QVERIFY(!sample.hasSource);
    state = good;
    sample = rig.run();
    QVERIFY(sample.tip.isRestart);
    QVERIFY(sample.actions.has(SafetyAction::Ramp));
    QVERIFY(sample.sent.isZero());
    sample = rig.runMany(2500);
    QVERIFY((sample.sent.force - Vec3(-2, 0, 0)).norm() < 1e-9);
    QVERIFY(isAlwaysFinite);
  }

  void notReadyMeansNoForce_data() {
    QTest::addColumn<int>("status");
    QTest::newRow("unplugged") << static_cast<int>(DeviceStatus::Absent);
    QTest::newRow("starting") << static_cast<int>(DeviceStatus::Starting);
    QTest::newRow("needs homing") << static_cast<int>(DeviceStatus::NeedsHoming);
    QTest::newRow("failed") << static_cast<int>(DeviceStatus::Failed);
  }
  // Unplugged in contact, and plugged in again elsewhere: no force at once, none when it comes back.
  void notReadyMeansNoForce() {
    QFETCH(int, status);
    Rig rig;
    rig.channel.scenes.publish(sceneOf(wall(1.0)));
    rig.pressTo(2.0);
    rig.log->state.status = static_cast<DeviceStatus>(status);
    ServoSample sample = rig.run();
    QVERIFY(sample.sent.isZero());
    QVERIFY(rig.log->last.isZero());
    QCOMPARE(static_cast<int>(sample.device.status), status);
    rig.runMany(100);
    rig.log->state.status = DeviceStatus::Ready;
    rig.log->state.position = {5, 0, 0};
    sample = rig.run();
    QVERIFY(sample.sent.isZero());
    QVERIFY(sample.tip.isRestart);
    QVERIFY(!rig.run().tip.isRestart);
  }

  // A scene of NaN: nothing is sent, and the rest of the program sees why.
  void aSceneOfNaNSendsNothing() {
    Rig rig;
    rig.channel.scenes.publish(sceneOf([](const TipState&, ForceOut& out) { out.force.x() = kServoTickFaultsNan; }));
    const ServoSample sample = rig.runMany(100);
    QVERIFY(sample.sent.isZero());
    QVERIFY(sample.actions.has(SafetyAction::NotFinite));
  }

  // A tick 50 ms late, in a wall: the force starts from nothing, comes back without a step, and no burst follows.
  void aTickFiftyMillisecondsLate() {
    Rig rig;
    rig.channel.scenes.publish(sceneOf(wall(1.0)));
    rig.pressTo(2.0);
    ServoSample sample = rig.run(50 * kMillisecond);
    QVERIFY(sample.actions.has(SafetyAction::Watchdog));
    QVERIFY(sample.tip.period <= 0.004 + 1e-12);
    Vec3 last = sample.sent.force;
    QVERIFY(last.norm() < 1e-9);
    for (int i = 0; i < 300; ++i) {
      sample = rig.run();
      QVERIFY((sample.sent.force - last).norm() <= 2.0 * 0.01 + 1e-9);  // 2 N within 100 ticks
      last = sample.sent.force;
    }
    QVERIFY((last - Vec3(-2, 0, 0)).norm() < 1e-9);
  }

  // The clock goes back an hour, stands still, goes on an hour: finite, and the time of the scene only goes on.
  void theClockJumps() {
    Rig rig;
    rig.channel.scenes.publish(sceneOf(wall(1.0)));
    double time = rig.pressTo(2.0).tip.time;
    const std::int64_t hour = 3'600'000 * kMillisecond;
    for (const std::int64_t step : {-hour, std::int64_t{0}, hour, kMillisecond, 4 * hour, -2 * hour}) {
      const ServoSample sample = rig.run(step);
      QVERIFY(sample.sent.force.allFinite() && sample.sent.force.norm() <= 8.0);
      QVERIFY(sample.tip.time > time && sample.tip.time < time + 0.01);
      QVERIFY(sample.tip.period > 0.0 && sample.tip.period <= 0.004 + 1e-12);
      time = sample.tip.time;
    }
    QVERIFY((rig.runMany(300).sent.force - Vec3(-2, 0, 0)).norm() < 1e-9);
  }

  // At 10 m/s through the wall: cut, not followed.
  void tenMetresASecond() {
    Rig rig;
    rig.channel.scenes.publish(sceneOf(wall(1.0)));
    rig.pressTo(2.0);
    ServoSample sample;
    for (int i = 0; i < 20; ++i) {
      rig.log->state.position.x() += 10.0;
      sample = rig.run();
    }
    QVERIFY(sample.actions.has(SafetyAction::SpeedCut));
    QVERIFY(sample.sent.isZero());
  }

  // One wrong reading, 40 mm away for a tick at any rate: no force for it, although the velocity over ten milliseconds
  // is below the cut.
  void oneWrongReading() {
    for (const std::int64_t period : {kMillisecond / 8, kMillisecond / 4, kMillisecond, 2 * kMillisecond}) {
      Rig rig;
      ServoSettings settings;
      settings.rate = 1e9 / static_cast<double>(period);
      ServoTick tick(rig.device, settings, rig.clock, rig.channel);
      rig.channel.scenes.publish(sceneOf(wall(0.05)));
      std::int64_t time = 0;
      const auto run = [&](int count) {
        for (int i = 0; i < count; ++i) tick.run(time += period);
        return rig.channel.latest.read();
      };
      rig.log->state.position = {-1, 0, 0};
      run(20000);
      for (; rig.log->state.position.x() < 2.0; rig.log->state.position.x() += 0.01) run(1);
      QVERIFY(run(100).sent.force.x() < -0.09);
      rig.log->state.position.x() += 40.0;
      const ServoSample wrong = run(1);
      QVERIFY(wrong.actions.has(SafetyAction::SpeedCut));
      QVERIFY(wrong.sent.isZero());
    }
  }

  // A hand of 1 m/s is not cut if a loop of 4 kHz reads a device of 1 kHz, whose packets come up to half a millisecond
  // early or late, and sometimes two at once.
  void packetsInABunchAreNoCut() {
    for (const bool isCounted : {true, false}) {
      Rig rig;
      ServoSettings settings;
      settings.rate = 4000.0;
      ServoTick tick(rig.device, settings, rig.clock, rig.channel);
      std::mt19937 random(7);
      std::uniform_real_distribution<double> early(-0.5e-3, 0.5e-3);
      std::uint32_t number = 0;
      double next = early(random);
      for (int i = 1; i <= 4000; ++i) {
        const double time = i / 4000.0;
        for (; next <= time; next = 1e-3 * number + early(random)) {
          rig.log->state.position.x() = 1000.0 * (0.001 * number);
          ++number;
        }
        rig.log->state.reading = isCounted ? number : 0;
        tick.run(i * kMillisecond / 4);
        const ServoSample sample = rig.channel.latest.read();
        QVERIFY2(!sample.actions.has(SafetyAction::SpeedCut), qPrintable(QString::number(i)));
        if (isCounted && i > 100) QVERIFY(!sample.actions.has(SafetyAction::Watchdog));
      }
    }
  }

  // The line falls silent in a wall: the device repeats its last reading. The force is held for 5 ms, gone after 10,
  // and nothing pushes a hand that was moving. With the next reading it comes back, without a step.
  void aSilentLineHoldsNoForce() {
    Rig rig;
    rig.log->onRead = [this](ScriptedDevice::Log& log) { log.state.reading += m_isSilent ? 0 : 1; };
    m_isSilent = false;
    rig.channel.scenes.publish(sceneOf(wall(1.0)));
    rig.pressTo(2.0);
    rig.log->state.hasVelocity = true;
    rig.log->state.velocity = {100, 0, 0};
    QVERIFY((rig.run().sent.force - Vec3(-2, 0, 0)).norm() < 1e-9);
    m_isSilent = true;
    for (int i = 1; i <= 200; ++i) {
      const ServoSample sample = rig.run();
      if (i <= 5) QVERIFY((sample.sent.force - Vec3(-2, 0, 0)).norm() < 1e-9);
      if (i >= 10) QVERIFY2(sample.sent.isZero(), qPrintable(QString::number(i)));
      if (i >= 10) QVERIFY(sample.actions.has(SafetyAction::Watchdog));
    }
    m_isSilent = false;
    rig.log->state.velocity.setZero();
    Vec3 last = Vec3::Zero();
    for (int i = 0; i < 200; ++i) {
      const Vec3 sent = rig.run().sent.force;
      QVERIFY((sent - last).norm() <= 2.0 * 0.01 + 1e-9);  // 2 N within 100 ticks
      last = sent;
    }
    QVERIFY((last - Vec3(-2, 0, 0)).norm() < 1e-9);
  }

  // A device without a count is measured on request: rest is no silence.
  void restIsNoSilence() {
    Rig rig;
    rig.channel.scenes.publish(sceneOf(wall(1.0)));
    rig.pressTo(2.0);
    QVERIFY((rig.runMany(500).sent.force - Vec3(-2, 0, 0)).norm() < 1e-9);
  }

  void aPauseStartsAnew() {
    Rig rig;
    rig.channel.scenes.publish(sceneOf(wall(1.0)));
    rig.pressTo(2.0);
    rig.tick.pause();
    const ServoSample sample = rig.run(10'000 * kMillisecond);
    QVERIFY(sample.tip.isRestart);
    QVERIFY(sample.sent.isZero());
    QVERIFY(!sample.actions.has(SafetyAction::Watchdog));
  }

 private:
  bool m_isSilent = false;
};

HANDWHEEL_TEST(ServoTickFaultsTest)
#include "ServoTickFaultsTest.moc"
