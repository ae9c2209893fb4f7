// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <limits>

#include "TickRig.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

// What a device, a scene and the machine can do wrong, and the hand must not feel.
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
  // The tip in contact, the device says NaN: nothing in that very tick, the scene never sees it, and back by the ramp.
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
    if (where == 0) state.position.y() = kNan;
    if (where == 1) state.orientation.x() = kNan;
    if (where == 2) state.velocity.z() = -std::numeric_limits<double>::infinity();
    if (where == 3) state.gripper = kNan;
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
    rig.channel.scenes.publish(sceneOf([](const TipState&, ForceOut& out) { out.force.x() = kNan; }));
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
};

QTEST_GUILESS_MAIN(ServoTickFaultsTest)
#include "ServoTickFaultsTest.moc"
