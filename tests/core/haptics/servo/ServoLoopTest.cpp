// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/servo/ServoLoop.h"

#include <QtTest>
#include <vector>

#include "HapticDevices.h"
#include "TestClass.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

struct LoopRig {
  std::shared_ptr<ScriptedDevice::Log> log = std::make_shared<ScriptedDevice::Log>();
  LateClock clock;
  Service service{"servo"};
  std::unique_ptr<ServoLoop> loop;

  explicit LoopRig(const ServoSettings& settings = {}) {
    loop = std::make_unique<ServoLoop>(std::make_unique<ScriptedDevice>(log), settings, clock, service);
  }
};

}  // namespace

class ServoLoopTest : public QObject {
  Q_OBJECT

 private slots:
  void ticksLieOnAGrid() {
    ServoSettings settings;
    settings.rate = 4000.0;
    LoopRig rig(settings);
    std::vector<std::int64_t> times;
    rig.log->onRead = [&](ScriptedDevice::Log&) { times.push_back(rig.clock.now()); };
    rig.loop->runTicks(100);
    QCOMPARE(times.size(), std::size_t{100});
    for (std::size_t i = 0; i < times.size(); ++i) QCOMPARE(times[i], static_cast<std::int64_t>(i) * 250'000);
    QCOMPARE(rig.loop->missedTicks(), std::uint64_t{0});
    QCOMPARE(rig.service.counters().ticks, std::uint64_t{100});
  }

  void theRateIsKeptInItsLimits() {
    for (const auto& [rate, period] : {std::pair{1.0, 2'000'000}, std::pair{1e9, 125'000}, std::pair{0.0, 1'000'000}}) {
      ServoSettings settings;
      settings.rate = rate;
      LoopRig rig(settings);
      rig.loop->runTicks(11);
      QCOMPARE(rig.clock.now(), std::int64_t{10} * period);
    }
  }

  // Two scenes between two ticks: the first may leap, the second is used.
  void aLeapThatWasAnnouncedStartsTheRamp() {
    LoopRig rig;
    rig.loop->setScene(sceneOf(wall(0.1)));
    rig.loop->runTicks(3000);
    rig.log->state.position = {1, 0, 0};
    rig.loop->runTicks(2000);
    QVERIFY(!rig.loop->latest().actions.has(SafetyAction::Ramp));
    rig.loop->setScene(sceneOf(wall(0.1), false));
    rig.loop->runTicks(1);
    QVERIFY(!rig.loop->latest().actions.has(SafetyAction::Ramp));
    rig.loop->setScene(sceneOf(wall(0.1), true));
    rig.loop->setScene(sceneOf(wall(0.1), false));
    rig.loop->runTicks(1);
    QVERIFY(rig.loop->latest().actions.has(SafetyAction::Ramp));
  }

  // 1 kHz, then 4 kHz: the new period applies, with the same scene, count and time; and the force rises from zero
  // again.
  void settingsChangeBetweenTicks() {
    LoopRig rig;
    double most = 0.0;  // N in a tick
    rig.log->onWrite = [&](const ScriptedDevice::Log& log, const DeviceForce& force) {
      most = std::max(most, (force.force - log.last.force).norm());
    };
    rig.loop->setScene(sceneOf([](const TipState&, ForceOut& out) { out.force = Vec3(1.0, 0.0, 0.0); }));
    rig.loop->runTicks(3000);
    QCOMPARE(rig.loop->latest().sent.force.x(), 1.0);
    QCOMPARE(rig.loop->measure().periods().binSeconds(), 0.001 / 64.0);
    const ServoSample before = rig.loop->latest();
    const std::int64_t start = rig.clock.now();
    ServoSettings settings;
    settings.rate = 4000.0;
    rig.loop->setSettings(settings);
    rig.log->last = {};  // a loop with a thread sends none when it stops
    most = 0.0;
    rig.loop->runTicks(12001);
    QVERIFY(rig.clock.now() - start <= 3'001 * kMillisecond);
    QVERIFY(rig.clock.now() - start >= 3'000 * kMillisecond);
    const ServoSample& after = rig.loop->latest();
    QCOMPARE(after.tick, before.tick + 12001);
    QVERIFY(std::abs(after.tip.time - before.tip.time - 3.0) < 0.0015);
    QCOMPARE(after.sent.force.x(), 1.0);
    QVERIFY(most < 0.01);
    QCOMPARE(rig.loop->measure().periods().binSeconds(), 0.00025 / 64.0);
  }

  // Woken 0.3 ms late again and again, the ticks do not drift off.
  void latenessDoesNotAddUp() {
    LoopRig rig;
    rig.clock.late = [] { return 300'000; };
    rig.loop->runTicks(1001);
    QCOMPARE(rig.clock.now(), 1000 * kMillisecond + 300'000);
    QVERIFY(qAbs(rig.loop->measure().lateness().quantile(0.5) - 300e-6) <= 5.001e-6);
  }

  // A tick that takes 50 ms: the ticks that it covers are left out and counted, and the next lies on the grid, alone.
  void anOverrunIsNotMadeUpForInABurst() {
    LoopRig rig;
    std::vector<std::int64_t> times;
    int n = 0;
    rig.log->onRead = [&](ScriptedDevice::Log&) {
      times.push_back(rig.clock.now());
      if (n++ == 10) rig.clock.set(rig.clock.now() + 50 * kMillisecond + 400'000);
    };
    rig.loop->runTicks(15);
    QCOMPARE(times[10], 10 * kMillisecond);
    QCOMPARE(times[11], 61 * kMillisecond);
    QCOMPARE(times[12], 62 * kMillisecond);
    QCOMPARE(rig.loop->missedTicks(), std::uint64_t{50});
  }

  // The clock set back by an hour does not stop the loop for an hour.
  void aClockThatGoesBackDoesNotStopTheLoop() {
    LoopRig rig;
    rig.clock.set(4'000'000 * kMillisecond);
    rig.loop->runTicks(10);
    int n = 0;
    rig.log->onRead = [&](ScriptedDevice::Log&) {
      if (n++ == 0) rig.clock.set(400'000 * kMillisecond);
    };
    rig.loop->runTicks(5);
    QVERIFY(rig.clock.now() < 400'010 * kMillisecond);
  }

  // A real thread on the machine's clock: it runs, reports its state, computes forces, and ends with zero force and a
  // closed device.
  void runsOnItsThread() {
    auto log = std::make_shared<ScriptedDevice::Log>();
    MonotonicClock clock;
    Service service("servo");
    {
      ServoLoop loop(std::make_unique<ScriptedDevice>(log), {}, clock, service);
      QCOMPARE(static_cast<int>(loop.realTime()), static_cast<int>(RealTimeState::NotRunning));
      loop.setScene(sceneOf([](const TipState&, ForceOut& out) { out.force = Vec3(0.1, 0, 0); }));
      loop.start();
      bool hasForce = false, hasOrder = true;
      std::uint64_t next = 0;
      ServoSample sample;
      while (!hasForce) {
        if (!loop.nextSample(sample)) continue;
        hasOrder &= sample.tick == next++;
        hasForce = sample.sent.force.x() > 0.0;
      }
      QVERIFY(hasOrder);
      QVERIFY(loop.latest().hasSource);
      QVERIFY(loop.realTime() != RealTimeState::NotRunning);
      loop.setScene(sceneOf([](const TipState&, ForceOut& out) { out.force = Vec3(0.05, 0, 0); }));
      while (!loop.collect()) {
      }
      loop.stop();
      QVERIFY(log->last.isZero());
      QCOMPARE(log->closes, 0);
      loop.start();  // and again
      while (!loop.nextSample(sample)) {
      }
      loop.stop();
      QCOMPARE(static_cast<int>(loop.realTime()), static_cast<int>(RealTimeState::NotRunning));
    }
    QCOMPARE(log->closes, 1);
    QVERIFY(service.counters().ticks > 0);
    QVERIFY(service.counters().cpuMicroseconds > 0.0);
  }

  // An unplugged device has a closed end, too: nothing is read or written after the loop.
  void nothingRunsAfterStop() {
    auto log = std::make_shared<ScriptedDevice::Log>();
    MonotonicClock clock;
    Service service("servo");
    ServoLoop loop(std::make_unique<ScriptedDevice>(log), {}, clock, service);
    loop.start();
    loop.stop();
    const int reads = log->reads;
    QThread::msleep(5);
    QCOMPARE(log->reads, reads);
    loop.stop();  // twice does no harm
  }
};

HANDWHEEL_TEST(ServoLoopTest)
#include "ServoLoopTest.moc"
