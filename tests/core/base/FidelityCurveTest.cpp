// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/FidelityCurve.h"

#include <rapidcheck.h>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

FidelitySetting linear(double standard) {
  FidelitySetting s;
  s.id = "test.linear";
  s.least = 0.0;
  s.largest = 100.0;
  s.standard = standard;
  return s;
}

FidelityRow row(double value, double error, double cost) {
  FidelityRow r;
  r.value = value;
  r.error = error;
  r.cost = cost;
  return r;
}

// Returns error = 1 / cost at costs 1, 10, 100, ... 10^(n-1); the value is the exponent.
std::vector<CurvePoint> reciprocal(int n) {
  std::vector<CurvePoint> curve;
  for (int i = 0; i < n; ++i) curve.push_back({double(i), std::pow(10.0, -i), std::pow(10.0, i)});
  return curve;
}

// A few costs and errors, so that many coincide.
rc::Gen<std::vector<CurvePoint>> smallCurves() {
  return rc::gen::map(rc::gen::container<std::vector<std::pair<int, int>>>(
                          rc::gen::pair(rc::gen::inRange(0, 6), rc::gen::inRange(0, 6))),
                      [](const std::vector<std::pair<int, int>>& pairs) {
                        std::vector<CurvePoint> curve;
                        for (const auto& [error, cost] : pairs) {
                          curve.push_back({double(curve.size()), error == 5 ? kInfinity : error, 1.0 + cost});
                        }
                        return curve;
                      });
}

bool beats(const CurvePoint& a, const CurvePoint& b) {
  return a.error <= b.error && a.cost <= b.cost && (a.error < b.error || a.cost < b.cost);
}

}  // namespace

class FidelityCurveTest : public QObject {
  Q_OBJECT

 private slots:
  void curveTakesTheWorstCase();
  void relativeCurveGivesEachCaseTheSameSay();
  void frontIsWhatNothingBeats();
  void kneeOfReciprocalIsTheGeometricMean();
  void kneeOfACorner();
  void noKnee();
  void presetsOfReciprocal();
  void presetsKeepTheDefaultWhereNothingTellsValuesApart();
  void presetsAreOrdered();
  void fit();
};

void FidelityCurveTest::curveTakesTheWorstCase() {
  const auto curve = curveOf(std::vector{row(2, 5, 1), row(1, 1, 9), row(2, 4, 3), row(1, 0, 10)});
  QCOMPARE(curve, (std::vector<CurvePoint>{{1, 1, 10}, {2, 5, 3}}));
  QVERIFY(curveOf({}).empty());
}

// Case a errs a thousand times as much as case b and never changes; the improvement of b must show all the same.
void FidelityCurveTest::relativeCurveGivesEachCaseTheSameSay() {
  std::vector<FidelityRow> rows{row(1, 1000, 10), row(2, 1000, 20), row(1, 4, 1), row(2, 1, 3)};
  for (std::size_t i = 0; i < 4; ++i) rows[i].testCase = i < 2 ? "a" : "b";
  QCOMPARE(relativeCurveOf(linear(2), rows), (std::vector<CurvePoint>{{1, 4, 0.5}, {2, 1, 1}}));
  QVERIFY(relativeCurveOf(linear(3), rows).empty());  // not measured at the default
  rows.resize(3);                                     // case b is not
  QVERIFY(relativeCurveOf(linear(2), rows).empty());
  // The default has no error: errors are shares of the largest error. No error anywhere stays none; no result stays
  // none.
  QCOMPARE(relativeCurveOf(linear(1), std::vector{row(1, 0, 2), row(2, 5, 1), row(3, 10, 4)}),
           (std::vector<CurvePoint>{{1, 0, 1}, {2, 0.5, 0.5}, {3, 1, 2}}));
  QCOMPARE(relativeCurveOf(linear(1), std::vector{row(1, 0, 2), row(2, 0, 1)}),
           (std::vector<CurvePoint>{{1, 0, 1}, {2, 0, 0.5}}));
  QCOMPARE(relativeCurveOf(linear(1), std::vector{row(1, 3, 2), row(2, kInfinity, 1)}).back().error, kInfinity);
}

void FidelityCurveTest::frontIsWhatNothingBeats() {
  QVERIFY(rc::check("the front holds what no other point beats", [] {
    const std::vector<CurvePoint> curve = *smallCurves();
    const std::vector<CurvePoint> front = paretoFront(curve);
    for (const CurvePoint& p : curve) {
      const bool isBeaten = std::any_of(curve.begin(), curve.end(), [&](const CurvePoint& q) { return beats(q, p); });
      const bool isThere = std::any_of(front.begin(), front.end(),
                                       [&](const CurvePoint& q) { return q.error == p.error && q.cost == p.cost; });
      RC_ASSERT(isThere == (!isBeaten && std::isfinite(p.error)));
    }
    for (std::size_t i = 1; i < front.size(); ++i) {
      RC_ASSERT(front[i - 1].cost < front[i].cost && front[i - 1].error > front[i].error);
    }
  }));
}

// The point of 1 / x furthest below the line through its ends has the slope of that line: the root of the product.
void FidelityCurveTest::kneeOfReciprocalIsTheGeometricMean() {
  for (int n : {3, 5, 7}) {
    const auto front = paretoFront(reciprocal(n));
    QCOMPARE(front.size(), static_cast<std::size_t>(n));
    QCOMPARE(kneeOf(front).value(), static_cast<std::size_t>(n / 2));
  }
}

// Errors fall steeply to a corner and hardly after it, in any units.
void FidelityCurveTest::kneeOfACorner() {
  std::vector<CurvePoint> front{{0, 1000, 1}, {1, 500, 2}, {2, 10, 3}, {3, 9, 50}, {4, 8, 100}};
  QCOMPARE(kneeOf(front).value(), std::size_t{2});
  for (CurvePoint& p : front) p = {p.value, 1e-9 * p.error, 1e6 * p.cost};
  QCOMPARE(kneeOf(front).value(), std::size_t{2});
}

void FidelityCurveTest::noKnee() {
  QVERIFY(!kneeOf(std::vector<CurvePoint>{}));
  QVERIFY(!kneeOf(std::vector<CurvePoint>{{0, 1, 1}}));
  QVERIFY(!kneeOf(std::vector<CurvePoint>{{0, 1, 1}, {1, 0, 2}}));
  QVERIFY(!kneeOf(std::vector<CurvePoint>{{0, 2, 0}, {1, 1, 1}, {2, 0, 2}}));    // straight
  QVERIFY(!kneeOf(std::vector<CurvePoint>{{0, 10, 0}, {1, 9, 5}, {2, 0, 10}}));  // bulging outwards
}

void FidelityCurveTest::presetsOfReciprocal() {
  // Seven decades: the knee is the fourth; ten times its error is one decade away, a hundred times its cost two.
  const auto presets = derivedPresets(linear(0), reciprocal(7));
  QVERIFY(presets);
  QCOMPARE(*presets, (std::array{2.0, 3.0, 5.0}));
  QVERIFY(!derivedPresets(linear(0), std::vector<CurvePoint>{}));
  QVERIFY(!derivedPresets(linear(0), std::vector<CurvePoint>{{1, kInfinity, 1}}));
}

void FidelityCurveTest::presetsKeepTheDefaultWhereNothingTellsValuesApart() {
  // The errors are equal everywhere, the costs within the noise.
  const std::vector<CurvePoint> flat{{0, 1, 1.00}, {10, 1, 1.03}, {20, 1, 1.01}, {30, 1, 1.2}};
  QCOMPARE(derivedPresets(linear(12), flat).value(), (std::array{10.0, 10.0, 10.0}));
  QCOMPARE(derivedPresets(linear(30), flat).value(), (std::array{20.0, 20.0, 20.0}));  // 30 costs more than noise
}

void FidelityCurveTest::presetsAreOrdered() {
  QVERIFY(rc::check("error falls and cost rises from Draft to Exact", [] {
    const std::vector<CurvePoint> curve = *smallCurves();
    const auto presets = derivedPresets(linear(3), curve);
    const auto at = [&](double value) { return curve[static_cast<std::size_t>(value)]; };
    if (!presets) {
      RC_ASSERT(paretoFront(curve).empty());
      return;
    }
    const CurvePoint draft = at((*presets)[0]), balanced = at((*presets)[1]), exact = at((*presets)[2]);
    RC_ASSERT(exact.error <= balanced.error && balanced.error <= draft.error);
    const double noise = 1.0 + kCostNoise;
    RC_ASSERT(draft.cost <= noise * balanced.cost && balanced.cost <= noise * exact.cost);
  }));
}

void FidelityCurveTest::fit() {
  const auto curve = reciprocal(5);
  QCOMPARE(fitToBudget(curve, 150.0).value().value, 2.0);  // 100 is two thirds of it
  QCOMPARE(fitToBudget(curve, 149.0).value().value, 1.0);
  QCOMPARE(fitToBudget(curve, 1e9).value().value, 4.0);
  QVERIFY(!fitToBudget(curve, 1.0));
}

HANDWHEEL_TEST(FidelityCurveTest)
#include "FidelityCurveTest.moc"
