// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/device/ServoClock.h"

#include <QtTest>

using namespace handwheel;

class ServoClockTest : public QObject {
  Q_OBJECT

 private slots:
  // Never returns before the requested time, and at once when it has passed.
  void theMachinesClockWaits() {
    MonotonicClock clock;
    std::int64_t last = clock.now();
    for (int i = 0; i < 20; ++i) {
      const std::int64_t until = clock.now() + 200'000;
      clock.waitUntil(until);
      QVERIFY(clock.now() >= until);
      QVERIFY(clock.now() >= last);
      last = clock.now();
    }
    clock.waitUntil(0);
    clock.waitUntil(last - 1'000'000'000);
    QVERIFY(clock.now() >= last);
  }

  void virtualTimePassesByWaitingOnly() {
    VirtualClock clock;
    QCOMPARE(clock.now(), std::int64_t{0});
    clock.waitUntil(7);
    QCOMPARE(clock.now(), std::int64_t{7});
    clock.waitUntil(3);
    QCOMPARE(clock.now(), std::int64_t{7});
    clock.set(-5);
    QCOMPARE(clock.now(), std::int64_t{-5});
  }
};

HANDWHEEL_TEST(ServoClockTest)
#include "ServoClockTest.moc"
