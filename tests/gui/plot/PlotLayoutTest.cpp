// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "plot/PlotLayout.h"

#include <QTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

Plot twoSeries() {
  Plot plot;
  plot.title = "Trade";
  plot.x = {"Cost", "ms", true};
  plot.y = {"Error", "mm", false};
  plot.series = {{"fast", {{1, 10}, {10, 5}, {100, 0}}, true},
                 {"slow", {{2, 8}, {20, std::numeric_limits<double>::infinity()}, {200, 1}}, true}};
  return plot;
}

}  // namespace

class PlotLayoutTest : public QObject {
  Q_OBJECT

 private slots:
  void frameLiesInside();
  void labelsDoNotOverlap();
  void rowsDoNotOverlap();
  void positions();
  void readings();
  void titles();
};

void PlotLayoutTest::frameLiesInside() {
  const QRectF area(100, 50, 600, 400);
  const PlotLayout layout(twoSeries(), area, QFontMetricsF(QGuiApplication::font()));
  QVERIFY(area.contains(layout.frame()));
  QVERIFY(layout.frame().width() > 450 && layout.frame().height() > 200);
}

// In a plot of any width with numbers of any length, zero has its label.
void PlotLayoutTest::labelsDoNotOverlap() {
  const QFontMetricsF metrics(QGuiApplication::font());
  Plot plot;
  plot.series = {{"one", {{-0.00167, 1}, {0.00167, 2}}, true}};
  std::size_t fewest = 100, most = 0;
  for (const double width : {150.0, 220.0, 300.0, 500.0, 2000.0}) {
    const PlotLayout layout(plot, QRectF(0, 0, width, 200), metrics);
    const std::vector<std::size_t> labelled = layout.labelledTicks(plot.locale, metrics);
    QVERIFY(!labelled.empty());
    double end = -1e300;
    bool hasZero = false;
    for (const std::size_t i : labelled) {
      const double tick = layout.x().ticks[i], middle = layout.toScreen({tick, 1}).x();
      const double half = 0.5 * metrics.horizontalAdvance(tickLabel(tick, layout.x(), plot.locale));
      QVERIFY(middle - half > end);
      end = middle + half;
      hasZero = hasZero || tick == 0.0;
    }
    QVERIFY(hasZero);
    fewest = std::min(fewest, labelled.size());
    most = std::max(most, labelled.size());
  }
  QVERIFY(fewest < most);
}

// The same in a plot of a few lines, for example beside a table.
void PlotLayoutTest::rowsDoNotOverlap() {
  const QFontMetricsF metrics(QGuiApplication::font());
  Plot plot;
  plot.series = {{"one", {{0, -1}, {1, 9}}, true}};
  std::size_t fewest = 100, most = 0;
  for (const double lines : {8.0, 10.0, 12.0, 20.0, 60.0}) {
    const PlotLayout layout(plot, QRectF(0, 0, 400, lines * metrics.height()), metrics);
    const std::vector<std::size_t> rows = layout.labelledRows(metrics);
    QVERIFY(!rows.empty());
    bool hasZero = false;
    double before = 1e300;  // pixels from the top
    for (const std::size_t i : rows) {
      const double tick = layout.y().ticks[i], middle = layout.toScreen({0.0, tick}).y();
      QVERIFY(before - middle >= metrics.height() - 1e-6);
      before = middle;
      hasZero = hasZero || tick == 0.0;
    }
    QVERIFY(hasZero);
    fewest = std::min(fewest, rows.size());
    most = std::max(most, rows.size());
  }
  QVERIFY(fewest < most);
}

void PlotLayoutTest::positions() {
  const PlotLayout layout(twoSeries(), QRectF(0, 0, 600, 400), QFontMetricsF(QGuiApplication::font()));
  for (const PlotSeries& s : twoSeries().series) {
    for (const QPointF& p : s.points) {
      QCOMPARE(layout.isShown(p), std::isfinite(p.y()));
      if (!layout.isShown(p)) continue;
      QVERIFY(layout.frame().adjusted(-1, -1, 1, 1).contains(layout.toScreen(p)));
    }
  }
  QVERIFY(!layout.isShown({0.0, 1.0}));  // not on a logarithmic axis
  // Up on the screen is more, to the right is more.
  QVERIFY(layout.toScreen({1, 10}).y() < layout.toScreen({1, 5}).y());
  QVERIFY(layout.toScreen({10, 5}).x() > layout.toScreen({1, 5}).x());
}

void PlotLayoutTest::readings() {
  const Plot plot = twoSeries();
  const PlotLayout layout(plot, QRectF(0, 0, 600, 400), QFontMetricsF(QGuiApplication::font()));
  for (std::size_t s = 0; s < 2; ++s) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!layout.isShown(plot.series[s].points[i])) continue;
      const auto reading = layout.readingAt(plot, layout.toScreen(plot.series[s].points[i]) + QPointF(2, -2), 8.0);
      QVERIFY(reading);
      QCOMPARE(reading->series, s);
      QCOMPARE(reading->point, i);
    }
  }
  QVERIFY(!layout.readingAt(plot, layout.toScreen({4, 2}), 8.0));
}

void PlotLayoutTest::titles() {
  QCOMPARE(axisTitle({"Cost", "ms", false}), QString("Cost (ms)"));
  QCOMPARE(axisTitle({"Cost", "", false}), QString("Cost"));
}

HANDWHEEL_WIDGET_TEST(PlotLayoutTest)
#include "PlotLayoutTest.moc"
