// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SnapShapes.h"
#include "TestClass.h"

#include <rapidcheck.h>

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Returns a share of a range of `parts` equal steps.
double stepOf(int i, int parts) {
  return static_cast<double>(i) / parts;
}

// Returns numbers that no formula expects.
std::vector<double> strangeNumbers() {
  using Limits = std::numeric_limits<double>;
  return {Limits::quiet_NaN(),
          Limits::infinity(),
          -Limits::infinity(),
          Limits::denorm_min(),
          -1e-310,
          Limits::min(),
          Limits::max(),
          Limits::lowest(),
          -0.0,
          1e300};
}

}  // namespace

class SnapProfileTest : public QObject {
  Q_OBJECT

 private slots:
  void followsTheEquations();
  void peaksInTheMiddle();
  void nothingOutside();
  void jumpsNoMoreThanItsSlope();
  void onlyTheSpringLeaps();
  void keepsItsDigitsAtTheBorders();
  void strangeNumbersGiveNoForce();
};

void SnapProfileTest::followsTheEquations() {
  QVERIFY(rc::check([] {
    const double k = std::exp(0.01 * *rc::gen::inRange(-1000, 1000));
    const double ls = std::exp(0.01 * *rc::gen::inRange(-1000, 1000));
    const double x = ls * 1e-6 * *rc::gen::inRange(-1'000, 1'001'000);
    for (const SnapShape shape : kSnapShapes) {
      const auto expected = static_cast<double>(forceByEquation(shape, k, ls, x));
      RC_ASSERT(std::abs(SnapProfile(shape, k, ls).force(x) - expected) <= 1e-13 * k * ls);
    }
  }));
}

void SnapProfileTest::peaksInTheMiddle() {
  for (const SnapShape shape : kSmoothShapes) {
    const SnapProfile profile(shape, 3.0, 4.0);
    QCOMPARE(profile.force(2.0), 6.0);  // k ls/2
    QCOMPARE(profile.peak(), 6.0);
    for (int i = 0; i <= 1000; ++i) {
      const double x = 4.0 * stepOf(i, 1000);
      QVERIFY(profile.force(x) <= 6.0);
      QVERIFY(std::abs(profile.force(x) - profile.force(4.0 - x)) <= 1e-14);
    }
  }
  QCOMPARE(SnapProfile(SnapShape::Spring, 3.0, 4.0).peak(), 12.0);
}

void SnapProfileTest::nothingOutside() {
  using Limits = std::numeric_limits<double>;
  for (const SnapShape shape : kSnapShapes) {
    const SnapProfile profile(shape, 3.0, 4.0);
    for (const double x : {0.0, -0.0, -1.0, 4.0, 5.0, -Limits::infinity(), Limits::infinity(), Limits::quiet_NaN()})
      QCOMPARE(profile.force(x), 0.0);
  }
}

void SnapProfileTest::jumpsNoMoreThanItsSlope() {
  for (const SnapShape shape : kSmoothShapes) {
    const double k = 0.7, ls = 2.5;
    const SnapProfile profile(shape, k, ls);
    double steepest = 0.0;
    const int parts = 100'000;
    for (int i = -100; i < parts + 100; ++i) {
      const double from = ls * stepOf(i, parts), to = ls * stepOf(i + 1, parts);
      steepest = std::max(steepest, std::abs(profile.force(to) - profile.force(from)) / (to - from));
    }
    // The bound holds, and is tight.
    QVERIFY(steepest <= profile.largestSlope() * (1.0 + 1e-9));
    QVERIFY(steepest >= profile.largestSlope() * (1.0 - 1e-4));
    QVERIFY(std::abs(profile.largestSlope() - slopeByEquation(shape) * k) <= 1e-4 * k);
  }
}

void SnapProfileTest::onlyTheSpringLeaps() {
  const double k = 0.7, ls = 2.5, step = 1e-3;
  for (const SnapShape shape : kSnapShapes) {
    const SnapProfile profile(shape, k, ls);
    const double jump = std::abs(profile.force(ls) - profile.force(ls - step));
    if (shape == SnapShape::Spring) {
      QCOMPARE(profile.leap(), k * ls);
      QVERIFY(std::abs(jump - k * ls) <= k * step);
    } else {
      QCOMPARE(profile.leap(), 0.0);
      QVERIFY(jump <= profile.largestSlope() * step);
    }
  }
}

// F' at both borders is k, 2k and 9k / (e^4.5 - 1); by the unmodified equations the Gaussian's digits cancel there.
void SnapProfileTest::keepsItsDigitsAtTheBorders() {
  const double k = 0.7, ls = 2.0;
  const auto expected = [&](SnapShape shape) {
    return k * (shape == SnapShape::Triangular ? 1.0 : shape == SnapShape::Quadratic ? 2.0 : 9.0 / std::expm1(4.5));
  };
  for (const SnapShape shape : kSmoothShapes)
    for (const double x : {0x1p-30, 0x1p-40, 0x1p-50}) {
      const SnapProfile profile(shape, k, ls);
      QVERIFY(std::abs(profile.force(x) / x - expected(shape)) <= 10.0 * x + 1e-15);
      QVERIFY(std::abs(profile.force(ls - x) / x - expected(shape)) <= 10.0 * x + 1e-15);
    }
}

void SnapProfileTest::strangeNumbersGiveNoForce() {
  for (const SnapShape shape : kSnapShapes)
    for (const double k : strangeNumbers())
      for (const double ls : strangeNumbers())
        for (const double x : strangeNumbers()) {
          const SnapProfile profile(shape, k, ls);
          QVERIFY(std::isfinite(profile.force(x)) && profile.force(x) >= 0.0);
          if (!(k > 0.0 && k <= 1e100) || !(ls > 0.0 && ls <= 1e100)) {
            QCOMPARE(profile.force(x), 0.0);
            QCOMPARE(profile.largestSlope(), 0.0);
            QCOMPARE(profile.peak(), 0.0);
          }
        }
}

HANDWHEEL_TEST(SnapProfileTest)
#include "SnapProfileTest.moc"
