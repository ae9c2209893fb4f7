// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/FidelitySweep.h"

#include <rapidcheck.h>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <set>

using namespace handwheel;

namespace {

FidelitySetting fidelitySweepChord() {
  FidelitySetting s;
  s.id = "nurbs.chord_mm";
  s.label = "Chord";
  s.scale = FidelityScale::Logarithmic;
  s.least = 1e-4;
  s.largest = 1.0;
  s.standard = 0.03;
  s.presets = {0.1, 0.03, 0.001};
  s.error = {"largest distance", "mm"};
  s.cost = {"CPU time", "ms"};
  return s;
}

// Returns a case whose error is the value, and whose costs are those of the list, one after the other.
FidelityCase withCosts(std::vector<double> costs) {
  auto next = std::make_shared<std::size_t>(0);
  return {"list", "closed form", [costs, next](double value, std::uint64_t, Progress) {
            return FidelitySample{value, costs[(*next)++ % costs.size()]};
          }};
}

}  // namespace

class FidelitySweepTest : public QObject {
  Q_OBJECT

 private slots:
  void valuesCoverTheRange();
  void choicesAreAllTaken();
  void medianAndDeviation();
  void rows();
  void repeatsGoRound();
  void cancelled();
  void csv();
};

void FidelitySweepTest::valuesCoverTheRange() {
  // The default and the preset Draft lie on the grid of decades or off it, and occur exactly once in both cases.
  const std::vector<double> values = sweepValues(fidelitySweepChord(), 5);
  QCOMPARE(values.size(), std::size_t{6});
  const double expected[] = {1e-4, 1e-3, 1e-2, 0.03, 0.1, 1.0};
  for (std::size_t i = 0; i < 6; ++i) QVERIFY(std::abs(values[i] / expected[i] - 1.0) < 1e-12);
  for (double exact : {0.001, 0.03, 0.1}) QVERIFY(std::binary_search(values.begin(), values.end(), exact));
  QVERIFY(rc::check("ascending, each once, from end to end", [](int steps) {
    const std::vector<double> v = sweepValues(fidelitySweepChord(), std::abs(steps) % 40);
    RC_ASSERT(std::is_sorted(v.begin(), v.end()));
    RC_ASSERT(std::set<double>(v.begin(), v.end()).size() == v.size());
    RC_ASSERT(v.front() == 1e-4 && v.back() == 1.0);
  }));
}

void FidelitySweepTest::choicesAreAllTaken() {
  FidelitySetting s;
  setChoices(s, {"ear", "minimal", "refined", "fair"});
  QCOMPARE(sweepValues(s, 2), (std::vector<double>{0, 1, 2, 3}));
}

void FidelitySweepTest::medianAndDeviation() {
  QCOMPARE(median({3, 1, 100}), 3.0);
  QCOMPARE(median({4, 1, 2, 100}), 3.0);
  QCOMPARE(median({7}), 7.0);
  QCOMPARE(medianDeviation({3, 1, 100}), 2.0);  // 0, 2, 97
  QCOMPARE(medianDeviation({5, 5, 5, 900}), 0.0);
}

void FidelitySweepTest::rows() {
  const auto swept = sweep(fidelitySweepChord(), std::vector{withCosts({2.0, 9.0, 4.0})}, {2, 3, 77});
  QVERIFY(swept);
  const std::vector<FidelityRow>& r = *swept;
  QCOMPARE(r.size(), sweepValues(fidelitySweepChord(), 2).size());
  for (const FidelityRow& row : r) {
    QCOMPARE(row.setting, std::string("nurbs.chord_mm"));
    QCOMPARE(row.error, row.value);
    QCOMPARE(row.errorUnit, std::string("mm"));
    QCOMPARE(row.costUnit, std::string("ms"));
    QCOMPARE(row.repeats, 3);
    QCOMPARE(row.seed, std::uint64_t{77});
    QCOMPARE(row.truth, std::string("closed form"));
  }
}

// Five values, two repeats: the list's entries 0…4 are the first round, 5…9 the second.
void FidelitySweepTest::repeatsGoRound() {
  const auto swept =
      sweep(fidelitySweepChord(), std::vector{withCosts({1, 2, 3, 4, 5, 11, 12, 13, 14, 15})}, {2, 2, 1});
  QCOMPARE(swept.value().size(), std::size_t{5});
  for (std::size_t i = 0; i < 5; ++i) {
    QCOMPARE(swept.value()[i].cost, 6.0 + static_cast<double>(i));
    QCOMPARE(swept.value()[i].spread, 5.0);
  }
}

void FidelitySweepTest::cancelled() {
  JobState state;
  int runs = 0;
  const FidelityCase stopping{"stopping", "none", [&](double, std::uint64_t, Progress) {
                                if (++runs == 3) state.cancelled = true;
                                return FidelitySample{};
                              }};
  const auto swept = sweep(fidelitySweepChord(), std::vector{stopping}, {}, Progress(state));
  QVERIFY(!swept && swept.error().code == ErrorCode::Cancelled);
  QCOMPARE(runs, 3);
  JobState whole;
  QVERIFY(sweep(fidelitySweepChord(), std::vector{withCosts({1.0})}, {}, Progress(whole)));
  QCOMPARE(whole.fraction.load(), 1.0);
}

void FidelitySweepTest::csv() {
  FidelityRow row;
  row.setting = "a.b";
  row.value = 0.5;
  row.testCase = "torn, \"badly\"";
  row.error = std::numeric_limits<double>::infinity();
  row.errorUnit = "vertices";
  row.cost = 1.25;
  row.costUnit = "ms";
  row.spread = 0.0;
  row.repeats = 5;
  row.seed = 1;
  row.truth = "closed form";
  QCOMPARE(csvOf(fidelitySweepChord(), std::vector{row}),
           std::string("a.b,0.5,\"torn, \"\"badly\"\"\",inf,vertices,1.25,ms,0,5,1,closed form\n"));
  FidelitySetting method;
  setChoices(method, {"ear", "fair"});
  row.value = 1;
  QVERIFY(csvOf(method, std::vector{row}).starts_with("a.b,fair,"));
  QCOMPARE(std::count(kFidelityCsvHeader.begin(), kFidelityCsvHeader.end(), ','), 10);
}

HANDWHEEL_TEST(FidelitySweepTest)
#include "FidelitySweepTest.moc"
