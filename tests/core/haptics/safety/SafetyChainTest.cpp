// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/safety/SafetyChain.h"

#include <rapidcheck.h>
#include <QtTest>
#include <limits>

using namespace handwheel;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

SafetySettings safetyChainSettings() {
  SafetySettings s;
  s.inherentDamping = 0.005;
  s.controlDamping = 0.02;
  s.energyLimit = 1000.0;
  s.speedDamping = 0.01;
  s.rampTime = 0.1;
  s.rampWait = 0.05;
  s.slewRate = 1000.0;
  s.maxForce = 8.0;
  return s;
}

SafetyInput asking(const Vec3& force) {
  SafetyInput input;
  input.asked.force = force;
  return input;
}

// Returns a chain whose ramp is over.
SafetyChain running() {
  SafetyChain chain(safetyChainSettings());
  for (int i = 0; i < 200; ++i) chain.process(asking(Vec3::Zero()));
  return chain;
}

Vec3 settled(SafetyChain& chain, const Vec3& force) {
  Vec3 sent = Vec3::Zero();
  for (int i = 0; i < 20; ++i) sent = chain.process(asking(force)).sent.force;
  return sent;
}

double anyNumber() {
  return *rc::gen::oneOf(rc::gen::element(0.0, -0.0, kNan, kInf, -kInf, 1e308, -1e308, 5e-324, 1.0, -3.0, 1e7),
                         rc::gen::map(rc::gen::inRange(-100000, 100000), [](int i) { return i * 1e-3; }));
}

Vec3 safetyChainAnyVector() {
  const double x = anyNumber(), y = anyNumber(), z = anyNumber();
  return {x, y, z};
}

}  // namespace

class SafetyChainTest : public QObject {
  Q_OBJECT

 private slots:
  void whatIsHarmlessPassesUntouched() {
    SafetyChain chain = running();
    const Vec3 force(0.3, -0.2, 0.1);
    const SafetyOutput output = chain.process(asking(force));
    QVERIFY(output.sent.force == force);
    QVERIFY(output.actions.isEmpty());
  }

  void startsWithTheRamp() {
    SafetyChain chain(safetyChainSettings());
    const SafetyOutput first = chain.process(asking({5, 0, 0}));
    QVERIFY(first.sent.isZero());
    QVERIFY(first.actions.has(SafetyAction::Ramp));
    QVERIFY(settled(chain, {5, 0, 0}).isZero(0.0));
  }

  // A fault gives zero in the same tick, although the slew limit allows 1 N a tick; then the ramp follows.
  void faultsGoToZeroAtOnce_data() {
    QTest::addColumn<int>("fault");
    QTest::addColumn<std::uint32_t>("action");
    QTest::newRow("force NaN") << 0 << static_cast<std::uint32_t>(SafetyAction::NotFinite);
    QTest::newRow("torque infinite") << 1 << static_cast<std::uint32_t>(SafetyAction::NotFinite);
    QTest::newRow("position NaN") << 2 << static_cast<std::uint32_t>(SafetyAction::DeviceFault);
    QTest::newRow("velocity infinite") << 3 << static_cast<std::uint32_t>(SafetyAction::DeviceFault);
    QTest::newRow("not ready") << 4 << static_cast<std::uint32_t>(SafetyAction::DeviceFault);
    QTest::newRow("far away") << 5 << static_cast<std::uint32_t>(SafetyAction::DeviceFault);
    QTest::newRow("no period") << 6 << static_cast<std::uint32_t>(SafetyAction::DeviceFault);
    QTest::newRow("at 10 m/s") << 7 << static_cast<std::uint32_t>(SafetyAction::SpeedCut);
  }
  void faultsGoToZeroAtOnce() {
    QFETCH(int, fault);
    QFETCH(std::uint32_t, action);
    SafetyChain chain = running();
    const Vec3 force(6, 0, 0);
    QCOMPARE(settled(chain, force), force);
    SafetyInput input = asking(force);
    if (fault == 0) input.asked.force.y() = kNan;
    if (fault == 1) input.asked.torque.z() = kInf;
    if (fault == 2) input.position.x() = kNan;
    if (fault == 3) input.velocity.z() = kInf;
    if (fault == 4) input.isDeviceReady = false;
    if (fault == 5) input.position.x() = 1e10;
    if (fault == 6) input.period = 0.0;
    if (fault == 7) input.velocity.x() = 10'000.0;
    const SafetyOutput output = chain.process(input);
    QVERIFY(output.sent.isZero());
    QCOMPARE(output.actions.bits(), action);
    const SafetyOutput next = chain.process(asking(force));
    QVERIFY(next.sent.isZero());
    QVERIFY(next.actions.has(SafetyAction::Ramp));
  }

  // A force that may leap comes down by the slew limit, 1 N a tick, and up by the ramp.
  void aLeapIsSlewedDownAndRampedUp() {
    SafetyChain chain = running();
    QCOMPARE(settled(chain, {6, 0, 0}), Vec3(6, 0, 0));
    SafetyInput input = asking({6, 0, 0});
    input.isDiscontinuous = true;
    QVERIFY((chain.process(input).sent.force - Vec3(5, 0, 0)).norm() < 1e-12);
    Vec3 last(5, 0, 0);
    bool hasRested = false;
    for (int i = 0; i < 200; ++i) {
      const Vec3 sent = chain.process(asking({6, 0, 0})).sent.force;
      QVERIFY((sent - last).norm() <= 1.0 + 1e-12);
      hasRested |= sent.isZero(0.0);
      if (hasRested) QVERIFY(sent.x() - last.x() <= 6.0 * 0.01 + 1e-12);  // 6 N in 100 ticks
      last = sent;
    }
    QVERIFY(hasRested);
    QCOMPARE(last, Vec3(6, 0, 0));
  }

  void tellsWhichStageActed() {
    SafetyChain chain = running();
    QVERIFY(chain.process(asking({3, 0, 0})).actions.has(SafetyAction::Slew));
    SafetyOutput output;
    for (int i = 0; i < 20; ++i) output = chain.process(asking({20, 0, 0}));
    QVERIFY(output.actions.has(SafetyAction::Clamp));
    QVERIFY((output.sent.force - Vec3(8, 0, 0)).norm() < 1e-12);

    SafetyInput input = asking({1, 0, 0});
    input.velocity = {0, 2000, 0};
    QVERIFY(chain.process(input).actions.has(SafetyAction::SpeedDamping));
    for (int i = 0; i < 8; ++i) {
      input = asking({1, 0, 0});
      input.isFresh = false;
      output = chain.process(input);
    }
    QVERIFY(output.actions.has(SafetyAction::Watchdog));
  }

  // A silent scene: first its force is held, then only the damping, then nothing.
  void silenceLeavesDampingAndThenNothing() {
    SafetyChain chain = running();
    QCOMPARE(settled(chain, {2, 0, 0}), Vec3(2, 0, 0));
    SafetyInput input = asking({2, 0, 0});
    input.isFresh = false;
    input.velocity = {0, 50, 0};
    Vec3 sent;
    for (int i = 0; i < 30; ++i) sent = chain.process(input).sent.force;
    QVERIFY((sent - Vec3(0, -0.01 * 50, 0)).norm() < 1e-12);
    for (int i = 0; i < 100; ++i) sent = chain.process(input).sent.force;
    QVERIFY(sent.isZero(0.0));
  }

  // The observer counts the force sent and held, not the one asked for: clamped 8 N over 1 mm, not 100.
  void theObserverCountsWhatWasSent() {
    SafetySettings s = safetyChainSettings();
    s.inherentDamping = 0.0;
    s.slewRate = 1e9;
    SafetyChain chain(s);
    for (int i = 0; i < 200; ++i) chain.process(asking(Vec3::Zero()));
    chain.process(asking({-100, 0, 0}));
    SafetyInput input = asking({-100, 0, 0});
    input.position = {1, 0, 0};
    QVERIFY(qAbs(chain.process(input).energy - 8.0) < 1e-12);
  }

  // A force that pushes the hand along generates energy: it is damped, in the direction of the motion.
  void whatMakesEnergyIsDamped() {
    SafetyChain chain = running();
    double x = 0.0;
    bool hasActed = false;
    for (int i = 0; i < 50; ++i) {
      SafetyInput input = asking({0.5, 0, 0});
      x += 0.05;
      input.position = {x, 0, 0};
      const SafetyOutput output = chain.process(input);
      if (output.energy >= 0.0) continue;
      hasActed = true;
      QVERIFY(output.actions.has(SafetyAction::Passivity));
      QVERIFY(output.sent.force.x() < 0.5);
    }
    QVERIFY(hasActed);
  }

  // A device without motors for torque and gripper gets none, which is no fault.
  void whatTheDeviceDoesNotGiveIsLeftOut() {
    SafetyChain chain = running();
    SafetyInput input = asking({0.5, 0, 0});
    input.asked.torque = {5, 5, 5};
    input.asked.gripper = 3;
    const SafetyOutput output = chain.process(input);
    QVERIFY(output.actions.isEmpty());
    QVERIFY(output.sent.torque.isZero(0.0));
    QCOMPARE(output.sent.gripper, 0.0);
  }

  // Torque of a device that has motors for it: 25 N·mm a tick, up to 100; to zero at once if it is no number; slowly
  // back; and it fades when the scene is silent.
  void torqueIsLimitedAsForceIs() {
    SafetySettings s = safetyChainSettings();
    s.maxTorque = 100.0;
    s.torqueSlewRate = 25000.0;
    SafetyChain chain(s);
    for (int i = 0; i < 200; ++i) chain.process(asking(Vec3::Zero()));
    const auto turning = [](double z) {
      SafetyInput input;
      input.asked.torque = {0, 0, z};
      return input;
    };
    for (const double expected : {25.0, 50.0, 60.0, 60.0}) {
      const SafetyOutput output = chain.process(turning(60.0));
      QVERIFY((output.sent.torque - Vec3(0, 0, expected)).norm() < 1e-9);
      QVERIFY(output.sent.force.isZero(0.0));
      QCOMPARE(output.actions.isEmpty(), expected == 60.0 && !output.actions.has(SafetyAction::Slew));
    }
    for (const double expected : {85.0, 100.0, 100.0})
      QVERIFY((chain.process(turning(1e300)).sent.torque - Vec3(0, 0, expected)).norm() < 1e-9);
    SafetyInput silent = turning(100.0);
    silent.isFresh = false;
    for (int i = 0; i < 30; ++i) chain.process(silent);
    QVERIFY(chain.process(silent).sent.isZero());
    for (int i = 0; i < 300; ++i) chain.process(turning(60.0));
    QVERIFY((chain.process(turning(60.0)).sent.torque - Vec3(0, 0, 60)).norm() < 1e-9);
    const SafetyOutput broken = chain.process(turning(kNan));
    QVERIFY(broken.sent.isZero() && broken.actions.has(SafetyAction::NotFinite));
    Vec3 last = Vec3::Zero();
    for (int i = 0; i < 200; ++i) {
      const Vec3 sent = chain.process(turning(60.0)).sent.torque;
      QVERIFY((sent - last).norm() <= 60.0 * 0.01 + 1e-9);  // in 100 ticks
      last = sent;
    }
    QVERIFY((last - Vec3(0, 0, 60)).norm() < 1e-9);
  }

  void anyTorqueIsFiniteAndLimited() {
    QVERIFY(rc::check("any torque", [] {
      SafetySettings s = safetyChainSettings();
      s.maxTorque = 100.0;
      s.torqueSlewRate = 25000.0;
      SafetyChain chain(s);
      Vec3 last = Vec3::Zero();
      for (int i = 0; i < 100; ++i) {
        SafetyInput input;
        input.asked.torque = safetyChainAnyVector();
        if (*rc::gen::inRange(0, 2)) input.asked.torque = Vec3(*rc::gen::inRange(-300, 300), 1, 2);
        input.period = *rc::gen::element(0.001, 0.001, 0.0011, 0.05, 1e-9, 3600.0, kNan, 0.0);
        input.isFresh = *rc::gen::inRange(0, 8) != 0;
        input.isDiscontinuous = *rc::gen::inRange(0, 32) == 0;
        const SafetyOutput output = chain.process(input);
        RC_ASSERT(output.sent.torque.allFinite() && output.sent.torque.norm() <= 100.0 + 1e-9);
        RC_ASSERT(output.sent.isZero() || (output.sent.torque - last).norm() <= 50.0 + 1e-9);
        last = output.sent.torque;
      }
    }));
  }

  // For any input, the force is finite, within the device's limits, and never further from the last but for a fall to
  // zero.
  void alwaysFiniteAndLimited() {
    QVERIFY(rc::check("any input", [] {
      SafetyChain chain(safetyChainSettings());
      Vec3 last = Vec3::Zero();
      for (int i = 0; i < 100; ++i) {
        SafetyInput input;
        input.asked = {safetyChainAnyVector(), safetyChainAnyVector(), anyNumber()};
        if (*rc::gen::inRange(0, 2)) input.asked.force = Vec3(*rc::gen::inRange(-20, 20), 1, 2);
        input.position = safetyChainAnyVector();
        input.velocity = safetyChainAnyVector();
        if (*rc::gen::inRange(0, 4)) input.velocity = {10, 0, 0};
        if (*rc::gen::inRange(0, 4)) input.position = {0.1 * i, 0, 0};
        input.period = *rc::gen::element(0.001, 0.001, 0.0011, 0.05, 1e-9, 3600.0, kInf, kNan, -1.0, 0.0);
        input.isFresh = *rc::gen::inRange(0, 8) != 0;
        input.isDiscontinuous = *rc::gen::inRange(0, 32) == 0;
        const SafetyOutput output = chain.process(input);
        RC_ASSERT(output.sent.force.allFinite() && output.sent.torque.allFinite() &&
                  std::isfinite(output.sent.gripper));
        RC_ASSERT(std::isfinite(output.energy));
        RC_ASSERT(output.sent.force.norm() <= 8.0 + 1e-12);
        // 1 N/ms for at most two periods.
        RC_ASSERT(output.sent.isZero() || (output.sent.force - last).norm() <= 2.0 + 1e-9);
        last = output.sent.force;
      }
    }));
  }
};

HANDWHEEL_TEST(SafetyChainTest)
#include "SafetyChainTest.moc"
