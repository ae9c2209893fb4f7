// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
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
  void places();
  void readings();
  void titles();
};

void PlotLayoutTest::frameLiesInside() {
  const QRectF area(100, 50, 600, 400);
  const PlotLayout layout(twoSeries(), area, QFontMetricsF(QGuiApplication::font()));
  QVERIFY(area.contains(layout.frame()));
  QVERIFY(layout.frame().width() > 450 && layout.frame().height() > 200);
}

void PlotLayoutTest::places() {
  const PlotLayout layout(twoSeries(), QRectF(0, 0, 600, 400), QFontMetricsF(QGuiApplication::font()));
  for (const PlotSeries& s : twoSeries().series) {
    for (const QPointF& p : s.points) {
      QCOMPARE(layout.isShown(p), std::isfinite(p.y()));
      if (!layout.isShown(p)) continue;
      QVERIFY(layout.frame().adjusted(-1, -1, 1, 1).contains(layout.toScreen(p)));
    }
  }
  QVERIFY(!layout.isShown({0.0, 1.0}));  // no place on a logarithmic axis
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

QTEST_MAIN(PlotLayoutTest)
#include "PlotLayoutTest.moc"
