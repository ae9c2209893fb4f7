// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/servo/TimingHistogram.h"

#include <rapidcheck.h>
#include <QtTest>
#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

using namespace handwheel;

class TimingHistogramTest : public QObject {
  Q_OBJECT

 private slots:
  void binsHoldTheirTimes() {
    TimingHistogram histogram(0.5);
    for (const double t : {0.0, 0.49, 0.5, 1.2, -3.0, 1e9, std::numeric_limits<double>::infinity()}) histogram.add(t);
    histogram.add(std::numeric_limits<double>::quiet_NaN());
    const auto counts = histogram.counts();
    QCOMPARE(counts[0], std::uint64_t{4});
    QCOMPARE(counts[1], std::uint64_t{1});
    QCOMPARE(counts[2], std::uint64_t{1});
    QCOMPARE(counts[TimingHistogram::kBins - 1], std::uint64_t{2});
    QCOMPARE(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}), std::uint64_t{8});
  }

  void quantilesAreThoseOfTheTimesToABin() {
    QCOMPARE(TimingHistogram(1.0).quantile(0.5), 0.0);
    QVERIFY(rc::check("to a bin", [] {
      const auto times = *rc::gen::nonEmpty(rc::gen::container<std::vector<double>>(
          rc::gen::map(rc::gen::inRange(0, 25000), [](int i) { return i * 0.01; })));
      TimingHistogram histogram(1.0);
      for (const double t : times) histogram.add(t);
      std::vector<double> sorted = times;
      std::sort(sorted.begin(), sorted.end());
      for (const double share : {0.01, 0.5, 0.99, 1.0}) {
        const auto rank = static_cast<std::size_t>(std::ceil(share * sorted.size())) - 1;
        const double measured = histogram.quantile(share);
        RC_ASSERT(measured >= sorted[rank] && measured <= sorted[rank] + 1.0 + 1e-9);
      }
    }));
  }
};

HANDWHEEL_TEST(TimingHistogramTest)
#include "TimingHistogramTest.moc"
