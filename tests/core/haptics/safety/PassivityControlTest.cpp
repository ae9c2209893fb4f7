// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/safety/PassivityControl.h"

#include <rapidcheck.h>
#include <QtTest>

using namespace handwheel;

namespace {

SafetySettings settings(double inherentDamping, double controlDamping) {
  SafetySettings s;
  s.nominalPeriod = 0.001;
  s.inherentDamping = inherentDamping;
  s.controlDamping = controlDamping;
  s.energyLimit = 1e6;
  return s;
}

// Returns a number between a and b.
double between(double a, double b) {
  return a + (b - a) * *rc::gen::inRange(0, 10001) / 10000.0;
}

}  // namespace

class PassivityControlTest : public QObject {
  Q_OBJECT

 private slots:
  // A constant force of 2 N over 3 mm takes 6 N·mm from the hand, and gives them back on the return.
  void workIsForceTimesDistance() {
    PassivityControl control(settings(0.0, 0.0));
    control.observe({0, 0, 0}, 0.001);
    control.sent({-2, 0, 0});
    control.observe({3, 0, 0}, 0.001);
    QCOMPARE(control.energy(), 6.0);
    control.sent({-2, 0, 0});
    control.observe({1, 5, -7}, 0.001);  // across the force nothing is done
    QCOMPARE(control.energy(), 2.0);
    control.sent({-2, 0, 0});
    control.observe({-1, 5, -7}, 0.001);
    QCOMPARE(control.energy(), -2.0);
  }

  // A wall that one can leave and enter again is bounded, too: the friction of the last free step pays for the depth.
  void aWallAtTheBoundNeverShowsADeficit() {
    QVERIFY(rc::check("no deficit at the bound", [] {
      const double period = between(1e-4, 2e-3), damping = between(1e-4, 0.02);
      const double stiffness = 2.0 * damping / period;
      PassivityControl control(settings(damping, 1.0));
      for (int i = 0; i < 200; ++i) {
        const double x = i == 0 ? -1.0 : between(-2, 2);  // one comes from outside
        control.observe({x, 0, 0}, period);
        RC_ASSERT(control.energy() >= -1e-9 * (1.0 + stiffness));
        control.sent({x > 0.0 ? -stiffness * x : 0.0, 0, 0});
      }
    }));
  }

  // Colgate's bound: the sampled spring makes K/2·dx² each step, the friction of the device takes b·dx²/T. On any path,
  // there is no deficit up to K = 2b/T.
  void aSpringAtTheBoundNeverShowsADeficit() {
    QVERIFY(rc::check("no deficit at the bound", [] {
      const double period = between(1e-4, 2e-3), damping = between(1e-4, 0.02);
      const double stiffness = 2.0 * damping / period;
      PassivityControl control(settings(damping, 1.0));
      Vec3 tip = Vec3::Zero();
      double most = 0.0;
      for (int i = 0; i < 200; ++i) {
        control.observe(tip, period);
        most = std::max(most, 0.5 * stiffness * tip.squaredNorm());
        RC_ASSERT(control.energy() >= -1e-9 * (1.0 + most));
        control.sent(-stiffness * tip);
        tip = Vec3(between(-2, 2), between(-2, 2), between(-2, 2));
      }
    }));
  }

  // Above it, moving to and fro over the same distance makes K/2 - b/T times dx² a step: here (5 - 2/0.001·0.001)·1.
  void aSpringAboveTheBoundDoes() {
    PassivityControl control(settings(0.002, 0.0));
    const double stiffness = 10.0;
    double tip = 0.5;
    for (int i = 0; i <= 10; ++i) {
      control.observe({tip, 0, 0}, 0.001);
      control.sent({-stiffness * tip, 0, 0});
      tip = -tip;
    }
    // Ten steps of 1 mm; the ends store the same energy, so only losses and friction count.
    QVERIFY(qAbs(control.energy() - 10.0 * (0.002 / 0.001 - 0.5 * stiffness)) < 1e-9);
  }

  // At the same velocity the correction dissipates the whole deficit in one period.
  void theCorrectionTakesTheDeficitBack() {
    PassivityControl control(settings(0.0, 100.0));
    control.observe({0, 0, 0}, 0.001);
    control.sent({4, 0, 0});
    control.observe({0.5, 0, 0}, 0.001);  // pushed along: 2 N·mm given away
    QCOMPARE(control.energy(), -2.0);
    const Vec3 force = control.correction();
    QVERIFY(force.x() < 0.0);
    control.sent(force);
    control.observe({1.0, 0, 0}, 0.001);
    QVERIFY(qAbs(control.energy()) < 1e-12);
  }

  void theCorrectionIsLimitedAndOnlyForADeficit() {
    PassivityControl control(settings(0.0, 0.002));
    control.observe({0, 0, 0}, 0.001);
    control.sent({4, 0, 0});
    control.observe({0.5, 0, 0}, 0.001);
    QVERIFY((control.correction() - Vec3(-0.002 * 500.0, 0, 0)).norm() < 1e-12);
    control.sent({-8, 0, 0});
    control.observe({1.0, 0, 0}, 0.001);
    QVERIFY(control.energy() > 0.0);
    QVERIFY(control.correction().isZero(0.0));
  }

  // A tip at rest has no velocity to damp: no force, and no division by zero.
  void restIsNotCorrected() {
    PassivityControl control(settings(0.0, 1.0));
    control.observe({0, 0, 0}, 0.001);
    control.sent({4, 0, 0});
    control.observe({0.5, 0, 0}, 0.001);
    control.sent({0, 0, 0});
    control.observe({0.5, 0, 0}, 0.001);
    QVERIFY(control.energy() < 0.0);
    QVERIFY(control.correction().isZero(0.0));
  }

  // Free space earns no credit but that of the last step, 0.002·0.1²/0.001, and pays deficits by the friction.
  void freeSpaceEarnsNothing() {
    PassivityControl control(settings(0.002, 1.0));
    control.observe({0, 0, 0}, 0.001);
    for (int i = 1; i < 100; ++i) {
      control.sent(Vec3::Zero());
      control.observe({0.1 * i, 0, 0}, 0.001);
      QVERIFY(qAbs(control.energy() - 0.02) < 1e-9);
    }
    control.sent({1, 0, 0});
    control.observe({10.0, 0, 0}, 0.001);
    QVERIFY(qAbs(control.energy() - (0.02 - 0.1 + 0.02)) < 1e-9);
    control.sent(Vec3::Zero());
    control.observe({10.1, 0, 0}, 0.001);
    QVERIFY(qAbs(control.energy() - (-0.06 + 0.02)) < 1e-9);
  }

  // For 3 ms of latency, the force sent three ticks ago has acted.
  void aLateDeviceIsObservedLate() {
    SafetySettings s = settings(0.0, 0.0);
    s.latency = 0.003;
    PassivityControl control(s);
    control.observe({0, 0, 0}, 0.001);
    const double energies[] = {0, 0, 0, 1, 3, 6, 10};
    for (int i = 0; i < 7; ++i) {
      control.sent({-(i + 1.0), 0, 0});
      control.observe({i + 1.0, 0, 0}, 0.001);
      QCOMPARE(control.energy(), energies[i]);
    }
  }

  // For 1.25 ms of latency, the force of two ticks ago acts for a quarter of the period, then that of one.
  void latencyIsNoWholeNumberOfTicks() {
    SafetySettings s = settings(0.0, 0.0);
    s.latency = 0.00125;
    PassivityControl control(s);
    control.observe({0, 0, 0}, 0.001);
    control.sent({-4, 0, 0});
    control.observe({1, 0, 0}, 0.001);
    QCOMPARE(control.energy(), 0.0);
    control.sent({-8, 0, 0});
    control.observe({2, 0, 0}, 0.001);
    QCOMPARE(control.energy(), 3.0);
    control.sent({0, 0, 0});
    control.observe({3, 0, 0}, 0.001);
    QCOMPARE(control.energy(), 3.0 + 7.0);
    control.sent({0, 0, 0});
    control.observe({4, 0, 0}, 0.001);
    QCOMPARE(control.energy(), 10.0 + 2.0);
  }

  void creditEndsAtTheLimit() {
    SafetySettings s = settings(0.0, 1.0);
    s.energyLimit = 5.0;
    PassivityControl control(s);
    control.observe({0, 0, 0}, 0.001);
    control.sent({-2, 0, 0});
    control.observe({100, 0, 0}, 0.001);
    QCOMPARE(control.energy(), 5.0);
    control.reset();
    QCOMPARE(control.energy(), 0.0);
  }
};

HANDWHEEL_TEST(PassivityControlTest)
#include "PassivityControlTest.moc"
