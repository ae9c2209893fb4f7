// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/FidelityFit.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr double kFidelityFitInfinity = std::numeric_limits<double>::infinity();

// A setting from 1 to 1e6 whose default is 1.
FidelitySetting settingOf(const std::string& id, FidelityBudget budget) {
  FidelitySetting s;
  s.id = id;
  s.label = id;
  s.scale = FidelityScale::Logarithmic;
  s.least = 1.0;
  s.largest = 1e6;
  s.standard = 1.0;
  s.presets = {1.0, 2.0, 4.0};
  s.error = {"error", "mm"};
  s.cost = {"cost", "us"};
  s.budget = budget;
  return s;
}

// Returns a candidate whose cost doubles when the error halves: a value v errs 1 / v and costs `unit` times v, for v =
// 1, 2, 4 … 2^19.
FitCandidate doubling(const std::string& id, FidelityBudget budget, double unit = 1.0) {
  FitCandidate c{settingOf(id, budget), {}};
  for (int i = 0; i < 20; ++i) c.curve.push_back({std::ldexp(1.0, i), std::ldexp(1.0, -i), unit * std::ldexp(1.0, i)});
  return c;
}

double valueOf(const FidelityFit& fit, const FitCandidate& candidate) {
  return fit.values.of(candidate.setting);
}

}  // namespace

class FidelityFitTest : public QObject {
  Q_OBJECT

 private slots:
  // A third of a period of 1000 us stays free: the largest power of two up to 666.7.
  void aThirdIsSpared() {
    const std::vector<FitCandidate> one{doubling("a", FidelityBudget::Tick)};
    const FidelityFit fit = chooseWithinBudgets(one);
    QCOMPARE(valueOf(fit, one[0]), 512.0);
    QCOMPARE(fit.shares.size(), std::size_t{1});
    QCOMPARE(fit.shares[0].used, 512.0);
    QCOMPARE(fit.shares[0].limit, 1000.0);
    QVERIFY(!fit.settings[0].isOver);
  }

  // Three share it: 2/3 · 1000 / 3 = 222 each.
  void settingsShare() {
    const std::vector<FitCandidate> three{doubling("a", FidelityBudget::Tick), doubling("b", FidelityBudget::Tick, 3.0),
                                          doubling("c", FidelityBudget::Tick, 200.0)};
    const FidelityFit fit = chooseWithinBudgets(three);
    QCOMPARE(valueOf(fit, three[0]), 128.0);
    QCOMPARE(valueOf(fit, three[1]), 64.0);
    QCOMPARE(valueOf(fit, three[2]), 1.0);
    QCOMPARE(fit.shares[0].used, 128.0 + 192.0 + 200.0);
  }

  // The rate is chosen first: 1 us for each tick, so up to 666,666 of them; the rest of a tick, and the stiffness that
  // so many ticks carry, follow from it.
  void theRateComesFirst() {
    std::vector<FitCandidate> all{doubling("stiffness", FidelityBudget::Rate),
                                  doubling("tolerance", FidelityBudget::Tick, 0.1),
                                  doubling("rate", FidelityBudget::Core)};
    const FidelityFit fit = chooseWithinBudgets(all);
    const double rate = std::ldexp(1.0, 19);
    QCOMPARE(valueOf(fit, all[2]), rate);
    QCOMPARE(valueOf(fit, all[0]), std::ldexp(1.0, 18));  // 2/3 of it: the next power of two below
    QCOMPARE(fit.shares[1].limit, 1e6 / rate);
    QCOMPARE(valueOf(fit, all[1]), 8.0);  // 0.1 v <= 2/3 · 1.907
    QVERIFY(fit.shares[0].budget == FidelityBudget::Core && fit.shares[2].budget == FidelityBudget::Rate);
  }

  // Two settings that each make the same fill longer: both together stay within 2/3 of a second. From 10 ms there is a
  // factor of 66.7, of which each may take √66.7 = 8.16.
  void costsOfOneFillMultiply() {
    const std::vector<FitCandidate> two{doubling("a", FidelityBudget::Fill, 10.0),
                                        doubling("b", FidelityBudget::Fill, 5.0)};
    const FidelityFit fit = chooseWithinBudgets(two);
    QCOMPARE(valueOf(fit, two[0]), 8.0);
    QCOMPARE(valueOf(fit, two[1]), 8.0);
    QCOMPARE(fit.shares[0].used, 640.0);
  }

  void whatCannotFitIsCheapestAndSaysSo() {
    const std::vector<FitCandidate> one{doubling("a", FidelityBudget::Frame, 20.0)};
    const FidelityFit fit = chooseWithinBudgets(one);
    QCOMPARE(valueOf(fit, one[0]), 1.0);
    QVERIFY(fit.settings[0].isOver);
    QCOMPARE(fit.shares[0].used, 20.0);
  }

  // A difference below the accuracy of the measurement is no reason to leave the default.
  void equalValuesAreTheDefault() {
    FitCandidate c{settingOf("a", FidelityBudget::Tick), {{1.0, 0.0, 10.4}, {2.0, 0.0, 10.0}, {4.0, 0.0, 10.2}}};
    QCOMPARE(valueOf(chooseWithinBudgets(std::vector{c}), c), 1.0);
    c.curve[0].cost = 11.0;
    QCOMPARE(valueOf(chooseWithinBudgets(std::vector{c}), c), 2.0);
  }

  void whatHasNoBudgetIsBalanced() {
    const std::vector<FitCandidate> one{doubling("a", FidelityBudget::None)};
    const FidelityFit fit = chooseWithinBudgets(one);
    QCOMPARE(valueOf(fit, one[0]), 2.0);
    QVERIFY(fit.settings.empty() && fit.shares.empty());
  }

  void extremes() {
    QVERIFY(chooseWithinBudgets({}).settings.empty());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const FidelityBudget budget : {FidelityBudget::Core, FidelityBudget::Tick, FidelityBudget::Fill}) {
      const FidelitySetting s = settingOf("a", budget);
      QVERIFY(chooseWithinBudgets(std::vector{FitCandidate{s, {}}}).settings.empty());
      QVERIFY(chooseWithinBudgets(std::vector{FitCandidate{s, {{1.0, kFidelityFitInfinity, 1.0}, {2.0, 1.0, nan}}}})
                  .settings.empty());
      const std::vector free{FitCandidate{s, {{1.0, 1.0, 0.0}, {2.0, 0.5, 0.0}, {4.0, kFidelityFitInfinity, 0.0}}}};
      QCOMPARE(valueOf(chooseWithinBudgets(free), free[0]), 2.0);
      const std::vector endless{FitCandidate{s, {{1.0, 1.0, kFidelityFitInfinity}, {2.0, 2.0, 1e300}}}};
      const FidelityFit fit = chooseWithinBudgets(endless);
      QCOMPARE(valueOf(fit, endless[0]), 2.0);
      QVERIFY(fit.settings[0].isOver);
    }
  }

  // For any curves, the budget is kept with a third to spare unless a setting says that it could not, and no value
  // within its part is more accurate than the one that was taken.
  void anyCurves() {
    const bool holds = rc::check("a third is spared, and none is more accurate", [] {
      const auto budget =
          *rc::gen::element(FidelityBudget::Tick, FidelityBudget::Frame, FidelityBudget::Wait, FidelityBudget::Fill);
      std::vector<FitCandidate> all;
      const int n = *rc::gen::inRange(1, 5);
      for (int i = 0; i < n; ++i) {
        FitCandidate c{settingOf(std::string(1, static_cast<char>('a' + i)), budget), {}};
        const int points = *rc::gen::inRange(1, 12);
        for (int k = 0; k < points; ++k)
          c.curve.push_back({1.0 + k, *rc::gen::inRange(0, 20) / 7.0, *rc::gen::inRange(1, 4000) / 7.0});
        all.push_back(c);
      }
      const FidelityFit fit = chooseWithinBudgets(all);
      RC_ASSERT(fit.settings.size() == all.size());
      const bool isOver = std::any_of(fit.settings.begin(), fit.settings.end(), [](const auto& s) { return s.isOver; });
      RC_ASSERT(isOver || fit.shares[0].used <= kBudgetShare * fit.shares[0].limit * (1.0 + 1e-12));
      for (std::size_t i = 0; i < all.size() && budget != FidelityBudget::Fill; ++i) {
        for (const CurvePoint& p : all[i].curve)
          RC_ASSERT(p.cost > kBudgetShare * fit.shares[0].limit / n || p.error >= fit.settings[i].point.error);
      }
    });
    QVERIFY(holds);
  }

  // The error counts in multiples of the default, the cost in its own unit: a case with the largest error in mm has no
  // more weight.
  void candidatesOfRows() {
    const FidelitySetting s = settingOf("a", FidelityBudget::Tick);
    std::vector<FidelityRow> rows;
    for (const auto& [value, name, error, cost] :
         {std::tuple(1.0, "x", 100.0, 5.0), {2.0, "x", 90.0, 6.0}, {1.0, "y", 1.0, 50.0}, {2.0, "y", 3.0, 40.0}}) {
      FidelityRow row;
      row.setting = s.id;
      row.value = value;
      row.testCase = name;
      row.error = error;
      row.cost = cost;
      rows.push_back(row);
    }
    const FitCandidate c = fitCandidate(s, rows);
    QCOMPARE(c.curve.size(), std::size_t{2});
    QVERIFY((c.curve[0] == CurvePoint{1.0, 1.0, 50.0}));
    QVERIFY((c.curve[1] == CurvePoint{2.0, 3.0, 40.0}));
  }
};

HANDWHEEL_TEST(FidelityFitTest)
#include "FidelityFitTest.moc"
