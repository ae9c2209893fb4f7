// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/servo/PeriodQuantile.h"

#include <QtTest>
#include <algorithm>
#include <random>
#include <vector>

using namespace handwheel;

class PeriodQuantileTest : public QObject {
  Q_OBJECT

 private slots:
  void assumesUntilAWindowIsFull() {
    PeriodQuantile usual(1e-5, 0.002);
    for (std::uint32_t i = 1; i < PeriodQuantile::kWindow; ++i) {
      usual.add(0.001);
      QCOMPARE(usual.value(), 0.002);
    }
    usual.add(0.001);
    QCOMPARE(usual.value(), 0.001);
  }

  // Ten in a thousand may be arbitrarily late; eleven count.
  void rareOnesDoNotCount() {
    for (const int rare : {0, 10, 11}) {
      PeriodQuantile usual(1e-5, 0.0);
      for (int i = 0; i < 1000; ++i) usual.add(i < rare ? 0.0025 : 0.001);
      QCOMPARE(usual.value(), rare > 10 ? 0.0025 : 0.001);
    }
  }

  // Compared with the sorted times, it is right to the step, from above.
  void isTheQuantileToTheResolution() {
    std::mt19937 random(3);
    std::exponential_distribution<double> late(1.0 / 5e-5);
    for (int run = 0; run < 20; ++run) {
      PeriodQuantile usual(1e-5, 0.0);
      std::vector<double> times(1000);
      for (double& t : times) usual.add(t = 0.001 + late(random));
      std::sort(times.begin(), times.end());
      QVERIFY(usual.value() >= times[989]);
      QVERIFY(usual.value() <= times[989] + 1e-5);
    }
  }

  void timesOutOfRange() {
    PeriodQuantile usual(1e-5, 0.0);
    for (int i = 0; i < 1000; ++i) usual.add(i % 2 ? 1e6 : -1.0);
    QCOMPARE(usual.value(), 1e6);
  }
};

HANDWHEEL_TEST(PeriodQuantileTest)
#include "PeriodQuantileTest.moc"
