// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/safety/ForceRamp.h"

#include <rapidcheck.h>
#include <QtTest>

using namespace handwheel;

namespace {

SafetySettings forceRampSettings() {
  SafetySettings s;
  s.nominalPeriod = 0.001;
  s.rampTime = 0.5;
  s.rampThreshold = 0.2;
  s.rampWait = 0.25;
  return s;
}

}  // namespace

class ForceRampTest : public QObject {
  Q_OBJECT

 private slots:
  // In free space the ramp starts at once and takes its full time.
  void risesInProportionToTime() {
    ForceRamp ramp(forceRampSettings());
    for (int i = 0; i < 500; ++i) QVERIFY(qAbs(ramp.gain(0.1, 0.001) - i * 0.002) < 1e-9);
    QCOMPARE(ramp.gain(5.0, 0.001), 1.0);
    QCOMPARE(ramp.gain(5.0, 0.001), 1.0);
  }

  // Inside a wall nothing is sent until the tip leaves it, or the wait is over.
  void waitsForASmallForceOrATime() {
    ForceRamp ramp(forceRampSettings());
    for (int i = 1; i < 100; ++i) QCOMPARE(ramp.gain(3.0, 0.001), 0.0);
    QCOMPARE(ramp.gain(0.19, 0.001), 0.0);  // it starts here
    QVERIFY(qAbs(ramp.gain(3.0, 0.001) - 0.002) < 1e-12);

    ForceRamp patient(forceRampSettings());
    int ticks = 0;
    while (patient.gain(3.0, 0.001) == 0.0) ++ticks;
    QVERIFY(qAbs(ticks - 250) <= 1);
  }

  void startsAgain() {
    ForceRamp ramp(forceRampSettings());
    for (int i = 0; i < 600; ++i) ramp.gain(0.0, 0.001);
    QCOMPARE(ramp.gain(0.0, 0.001), 1.0);
    ramp.restart();
    QCOMPARE(ramp.gain(0.0, 0.001), 0.0);
  }

  // For ticks of any lateness, a step is no larger than that of two in time; and it ends at 1.
  void aLateTickMakesNoStep() {
    QVERIFY(rc::check("bounded steps", [] {
      ForceRamp ramp(forceRampSettings());
      double last = 0.0;
      for (int i = 0; i < 600 && last < 1.0; ++i) {
        const double gain = ramp.gain(0.0, *rc::gen::inRange(1, 100000) * 1e-6);
        RC_ASSERT(gain >= last);
        RC_ASSERT(gain - last <= 2.0 * 0.001 / 0.5 + 1e-12);
        last = gain;
      }
      RC_ASSERT(last <= 1.0);
    }));
  }
};

HANDWHEEL_TEST(ForceRampTest)
#include "ForceRampTest.moc"
