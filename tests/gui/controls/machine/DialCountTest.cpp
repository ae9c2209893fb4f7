// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/machine/DialCount.h"

#include "TestClass.h"

#include <rapidcheck.h>

#include <cmath>

using namespace handwheel;

class DialCountTest : public QObject {
  Q_OBJECT

 private slots:
  void turnsAndRestAreTheReading();
  void stepsComeBack();
  void theRingDoesNotTurnTheWheel();
};

// For any sign: turns · divisions + rest is the reading, and the rest is within a turn.
void DialCountTest::turnsAndRestAreTheReading() {
  QVERIFY(rc::check("turns and rest are the reading", [] {
    DialCount count;
    const int perTurn = *rc::gen::inRange(1, 1001);
    const double division = *rc::gen::inRange(1, 10000) * 1e-4, thousandths = *rc::gen::inRange(-9000000, 9000000);
    count.setDivisions(perTurn, division);
    count.setZero(*rc::gen::inRange(-1000, 1000) * 0.25);
    count.setValue(count.zero() + thousandths * 1e-3 * division);
    RC_ASSERT(count.restOfTurn() >= 0.0 && count.restOfTurn() < perTurn);
    const double divisions = count.turns() * perTurn + count.restOfTurn();
    RC_ASSERT(std::abs(divisions * division - count.reading()) <= 1.01e-3 * division + 1e-9);
  }));
}

void DialCountTest::stepsComeBack() {
  QVERIFY(rc::check("as many tenths back as forth", [] {
    DialCount count;
    count.setDivisions(100, *rc::gen::element(0.01, 0.02, 0.05, 0.1, 1.0 / 3.0));
    const double start = *rc::gen::inRange(-100000, 100000) * 1e-3;
    count.setValue(start);
    const auto steps = *rc::gen::container<std::vector<int>>(rc::gen::inRange(-500, 500));
    int sum = 0;
    for (int step : steps) {
      count.setValue(count.after(step));
      sum += step;
    }
    count.setValue(count.after(-sum));
    RC_ASSERT(std::abs(count.value() - start) <= 1e-2 * 0.1 * count.mmPerDivision() + 1e-9);
  }));
}

// The crank shows the position of the slide; the ring is set on it.
void DialCountTest::theRingDoesNotTurnTheWheel() {
  DialCount count;
  count.setDivisions(50, 0.1);
  count.setValue(6.25);
  QCOMPARE(count.wheelDegrees(), 90.0);
  count.setZero(6.25);
  QCOMPARE(count.wheelDegrees(), 90.0);
  QCOMPARE(count.restOfTurn(), 0.0);
  count.setValue(-1.25);
  QCOMPARE(count.wheelDegrees(), 270.0);
}

HANDWHEEL_TEST(DialCountTest)
#include "DialCountTest.moc"
