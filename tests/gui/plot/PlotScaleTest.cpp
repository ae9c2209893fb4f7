// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "plot/PlotScale.h"

#include <rapidcheck.h>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>

using namespace handwheel;

class PlotScaleTest : public QObject {
  Q_OBJECT

 private slots:
  void linear();
  void logarithmic();
  void whatIsNoNumberCountsForNothing();
  void everythingFits();
  void labels_data();
  void labels();
};

void PlotScaleTest::linear() {
  const double values[] = {0.0, 3.0, 10.0};
  const PlotScale s = scaleFor(values, false);
  QCOMPARE(s.least, 0.0);  // no room below a natural zero
  QVERIFY(s.largest > 10.0 && s.largest < 11.0);
  QCOMPARE(s.ticks, (std::vector<double>{0, 2, 4, 6, 8, 10}));
  QCOMPARE(s.positionOf(s.least), 0.0);
  QCOMPARE(s.positionOf(s.largest), 1.0);
}

void PlotScaleTest::logarithmic() {
  const double values[] = {1e-4, 1.0};
  const PlotScale s = scaleFor(values, true);
  QVERIFY(s.logarithmic);
  QCOMPARE(s.ticks.size(), std::size_t{5});
  for (int k = 0; k < 5; ++k)
    QVERIFY(std::abs(s.ticks[static_cast<std::size_t>(k)] / std::pow(10.0, k - 4) - 1) < 1e-12);
  QVERIFY(std::abs(s.positionOf(1e-2) - 0.5) < 1e-12);
  const double withZero[] = {0.0, 1.0};
  QVERIFY(!scaleFor(withZero, true).logarithmic);
  const double narrow[] = {1.0, 8.0};  // less than a decade: 2 and 5 help
  QCOMPARE(scaleFor(narrow, true).ticks, (std::vector<double>{1, 2, 5}));
}

void PlotScaleTest::whatIsNoNumberCountsForNothing() {
  const double infinity = std::numeric_limits<double>::infinity();
  const double values[] = {std::nan(""), 1.0, infinity, 2.0, -infinity, 1e305};
  const PlotScale s = scaleFor(values, false);
  QVERIFY(s.least > 0.9 && s.largest < 2.1);
  const double none[] = {std::nan("")};
  QCOMPARE(scaleFor(none, true).largest, 1.0);
  QCOMPARE(scaleFor({}, false).least, 0.0);
}

// For any numbers: each lies inside, ticks too, and there are neither none nor too many.
void PlotScaleTest::everythingFits() {
  QVERIFY(rc::check("values and ticks lie inside, in order", [] {
    const int size = *rc::gen::inRange(-290, 291), detail = *rc::gen::inRange(-14, 3);
    std::vector<double> values;
    for (int digits : *rc::gen::nonEmpty<std::vector<int>>()) {
      values.push_back(std::pow(10.0, size) * (1.0 + std::pow(10.0, detail) * std::abs(digits % 1000)));
    }
    const bool logarithmic = *rc::gen::arbitrary<bool>();
    const PlotScale s = scaleFor(values, logarithmic);
    for (double v : values) RC_ASSERT(s.positionOf(v) >= 0.0 && s.positionOf(v) <= 1.0);
    for (double t : s.ticks) RC_ASSERT(s.positionOf(t) >= -1e-9 && s.positionOf(t) <= 1.0 + 1e-9);
    RC_ASSERT(std::is_sorted(s.ticks.begin(), s.ticks.end()));
    RC_ASSERT(s.ticks.size() <= 13u);
    if (!logarithmic && detail > -10) RC_ASSERT(s.ticks.size() >= 2u);
  }));
}

void PlotScaleTest::labels_data() {
  QTest::addColumn<double>("tick");
  QTest::addColumn<double>("step");
  QTest::addColumn<QString>("label");
  QTest::newRow("zero") << 0.0 << 1.0 << "0";
  QTest::newRow("whole") << 20.0 << 10.0 << "20";
  QTest::newRow("digits as the step") << 1.0 << 0.25 << "1.0";
  QTest::newRow("small step") << 0.35 << 0.05 << "0.35";
  QTest::newRow("rounding") << 3 * 0.1 << 0.1 << "0.3";
  QTest::newRow("large") << 2e6 << 1e6 << "2·10⁶";
  QTest::newRow("small") << 1e-5 << 1e-5 << "10⁻⁵";
  QTest::newRow("negative") << -40.0 << 20.0 << "-40";
}

void PlotScaleTest::labels() {
  QFETCH(double, tick);
  QFETCH(double, step);
  QFETCH(QString, label);
  PlotScale scale;
  scale.ticks = {tick, tick + step};
  QCOMPARE(tickLabel(tick, scale, QLocale::c()), label);
  QCOMPARE(tickLabel(0.5, scaleFor(std::vector{0.0, 1.0}, false), QLocale(QLocale::German)), QString("0,5"));
}

HANDWHEEL_TEST(PlotScaleTest)
#include "PlotScaleTest.moc"
