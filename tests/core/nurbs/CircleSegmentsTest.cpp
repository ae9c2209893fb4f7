// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "nurbs/CircleSegments.h"

#include <rapidcheck.h>

#include <QTest>
#include <bit>
#include <cmath>

using namespace handwheel;

class CircleSegmentsTest : public QObject {
  Q_OBJECT

 private slots:
  void keepsTheToleranceAndNotMuchMore();
  void levelsAreHalves();
  void coarseTolerance();
  void onTheAxis();
  void refusesTooMany();
};

namespace {

double sagitta(double radius, std::uint32_t segments) {
  const double s = std::sin(M_PI / (2.0 * segments));
  return 2.0 * radius * s * s;
}

double powerOfTen(double low, double high) {
  return std::pow(10.0, low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6);
}

}  // namespace

void CircleSegmentsTest::keepsTheToleranceAndNotMuchMore() {
  QVERIFY(rc::check("from a share of 1e-14 of the radius to all of it", [] {
    const double radius = powerOfTen(-6, 6), tolerance = radius * powerOfTen(-14, 0);
    const auto segments = CircleSegments::make(radius, tolerance);
    RC_ASSERT(segments.has_value());
    RC_ASSERT(sagitta(radius, segments->count(0)) <= tolerance * (1 + 1e-9));
    if (segments->count(0) > CircleSegments::kLeast) RC_ASSERT(sagitta(radius, segments->count(0)) > 0.75 * tolerance);
  }));
}

void CircleSegmentsTest::levelsAreHalves() {
  QVERIFY(rc::check("each keeps the tolerance as far as it reaches", [] {
    const double radius = powerOfTen(-3, 3), tolerance = radius * powerOfTen(-9, -1);
    const auto segments = CircleSegments::make(radius, tolerance);
    RC_ASSERT(segments.has_value());
    RC_ASSERT(segments->count(segments->levels()) >= 8u && segments->count(segments->levels()) <= 15u);
    RC_ASSERT((segments->count(segments->levels()) << segments->levels()) == segments->count(0));
    for (int level = 0; level <= segments->levels(); ++level) {
      RC_ASSERT(segments->levelOf(segments->count(level)) == level);
      RC_ASSERT(std::abs(sagitta(segments->reach(level), segments->count(level)) / tolerance - 1) < 1e-12);
    }
    const double smaller = radius * powerOfTen(-9, 0);
    const int level = segments->levelAt(smaller);
    RC_ASSERT(sagitta(smaller, segments->count(level)) <= tolerance * (1 + 1e-9));
    if (level < segments->levels()) RC_ASSERT(sagitta(smaller, segments->count(level + 1)) > tolerance * (1 - 1e-9));
  }));
}

void CircleSegmentsTest::coarseTolerance() {
  for (double tolerance : {0.1, 1.0, 2.0, 1e9}) {
    const auto segments = CircleSegments::make(1.0, tolerance);
    QCOMPARE(segments->count(0), 8u);
    QCOMPARE(segments->levels(), 0);
  }
  QCOMPARE(CircleSegments::make(1.0, 1.0 - std::cos(M_PI / 100.0) + 1e-12)->count(0), 104u);  // 13 · 8
}

void CircleSegmentsTest::onTheAxis() {
  const auto segments = CircleSegments::make(10.0, 1e-3);
  QCOMPARE(segments->levelAt(0.0), segments->levels());
  QCOMPARE(CircleSegments::make(0.0, 1e-3)->count(0), 8u);
}

void CircleSegmentsTest::refusesTooMany() {
  QVERIFY(!CircleSegments::make(1e6, 1e-15));
  QVERIFY(!CircleSegments::make(1.0, 0.0));
  QVERIFY(CircleSegments::make(1e6, 1e-9));
}

HANDWHEEL_TEST(CircleSegmentsTest)
#include "CircleSegmentsTest.moc"
