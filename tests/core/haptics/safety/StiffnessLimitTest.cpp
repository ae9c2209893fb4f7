// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/safety/StiffnessLimit.h"

#include <QtTest>
#include <limits>

using namespace handwheel;

class StiffnessLimitTest : public QObject {
  Q_OBJECT

 private slots:
  // b = 0.5 N·s/m at 1 kHz carries 1000 N/m; with 1 ms of delay a third of it.
  void isTheRule() {
    QCOMPARE(stiffnessLimit({0.001, 0.0, 0.0005}, 0.0), 1.0);
    QCOMPARE(stiffnessLimit({0.001, 0.001, 0.0005}, 0.0), 1.0 / 3.0);
    QCOMPARE(stiffnessLimit({0.001, 0.0, 0.005}, 0.003), 4.0);
    QCOMPARE(stiffnessLimit({0.001, 0.0, 0.005}, -0.003), 4.0);
  }

  void nothingWithoutSpareDamping() {
    QCOMPARE(stiffnessLimit({0.001, 0.0, 0.002}, 0.002), 0.0);
    QCOMPARE(stiffnessLimit({0.001, 0.0, 0.0}, 0.0), 0.0);
    QCOMPARE(stiffnessLimit({0.0, 0.0, 0.002}, 0.0), 0.0);
    QCOMPARE(stiffnessLimit({0.001, 0.0, std::numeric_limits<double>::quiet_NaN()}, 0.0), 0.0);
  }
};

HANDWHEEL_TEST(StiffnessLimitTest)
#include "StiffnessLimitTest.moc"
