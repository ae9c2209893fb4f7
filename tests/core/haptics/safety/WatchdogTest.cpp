// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/safety/Watchdog.h"

#include <QtTest>

using namespace handwheel;

namespace {

SafetySettings watchdogSettings() {
  SafetySettings s;
  s.nominalPeriod = 0.001;
  s.staleTime = 0.005;
  s.fadeTime = 0.005;
  s.dampingTime = 0.1;
  s.recoveryTime = 0.1;
  return s;
}

}  // namespace

class WatchdogTest : public QObject {
  Q_OBJECT

 private slots:
  void newsInTimeChangeNothing() {
    Watchdog watchdog(watchdogSettings());
    for (int i = 0; i < 100; ++i) {
      const auto gains = watchdog.tick(i % 2 ? 0.0005 : 0.0015, true);
      QCOMPARE(gains.force, 1.0);
      QCOMPARE(gains.damping, 0.0);
    }
  }

  // The force is held for 5 ms, faded within 5 more to damping alone, and 100 ms later to nothing.
  void silenceFadesToDampingAndThenToNothing() {
    Watchdog watchdog(watchdogSettings());
    for (int i = 1; i <= 5; ++i) QVERIFY(qAbs(watchdog.tick(0.001, false).force - 1.0) < 1e-9);
    for (int i = 1; i <= 5; ++i) {
      const auto gains = watchdog.tick(0.001, false);
      QVERIFY(qAbs(gains.force - (1.0 - i / 5.0)) < 1e-9);
      QVERIFY(qAbs(gains.damping - i / 5.0) < 1e-9);
    }
    for (int i = 1; i < 100; ++i) QVERIFY(qAbs(watchdog.tick(0.001, false).damping - 1.0) < 1e-9);
    watchdog.tick(0.001, false);
    for (int i = 0; i < 1000; ++i) {
      const auto gains = watchdog.tick(0.001, false);
      QCOMPARE(gains.force, 0.0);
      QCOMPARE(gains.damping, 0.0);
    }
  }

  // The force is back within the recovery time, without a step.
  void newsBringTheForceBackSlowly() {
    Watchdog watchdog(watchdogSettings());
    for (int i = 0; i < 50; ++i) watchdog.tick(0.001, false);
    for (int i = 1; i <= 100; ++i) QVERIFY(qAbs(watchdog.tick(0.001, true).force - i * 0.01) < 1e-9);
    QCOMPARE(watchdog.tick(0.001, true).force, 1.0);
  }

  // A tick 50 ms late has held its force for all that time: it starts from nothing. One 4 ms late is allowed.
  void aVeryLateTickFadesToo() {
    Watchdog watchdog(watchdogSettings());
    QCOMPARE(watchdog.tick(0.005, true).force, 1.0);
    QCOMPARE(watchdog.tick(0.05, true).force, 0.0);
    QVERIFY(qAbs(watchdog.tick(0.001, true).force - 0.01) < 1e-9);
    QCOMPARE(watchdog.tick(1e9, true).force, 0.0);
    watchdog.reset();
    QCOMPARE(watchdog.tick(0.001, true).force, 1.0);
  }
};

HANDWHEEL_TEST(WatchdogTest)
#include "WatchdogTest.moc"
