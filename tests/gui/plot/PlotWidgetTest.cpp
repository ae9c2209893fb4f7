// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "plot/PlotWidget.h"

#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

Plot plotWidgetTrade() {
  Plot plot;
  plot.title = "Trade";
  plot.x = {"Cost", "ms", true};
  plot.y = {"Error", "", false};
  plot.series = {{"fast", {{1, 10}, {10, std::nan("")}, {100, 0.5}}, true}, {"slow", {{2, 8}, {20, 3}}, true}};
  return plot;
}

QPoint pixelOf(const PlotWidget& widget, std::size_t series, std::size_t point) {
  const PlotLayout layout(widget.plot(), widget.rect(), QFontMetricsF(widget.font()));
  return layout.toScreen(widget.plot().series[series].points[point]).toPoint();
}

// Without a window on a screen there is no cursor, but the same event.
void moveTo(PlotWidget& widget, const QPoint& pixel) {
  QMouseEvent move(QEvent::MouseMove, pixel, widget.mapToGlobal(pixel), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&widget, &move);
}

}  // namespace

class PlotWidgetTest : public QObject {
  Q_OBJECT

 private slots:
  void cursorReadsTheNearestPoint();
  void keysWalkAlongThePoints();
  void anotherPlot();
  void nothingToRead();
};

void PlotWidgetTest::cursorReadsTheNearestPoint() {
  PlotWidget widget;
  widget.resize(480, 320);
  widget.setPlot(plotWidgetTrade());
  const QImage plain = widget.grab().toImage();
  const QSignalSpy spy(&widget, &PlotWidget::readingChanged);
  moveTo(widget, pixelOf(widget, 1, 1) + QPoint(5, 5));
  QCOMPARE(widget.reading(), QString("slow: 20 ms, 3"));
  QCOMPARE(widget.accessibleDescription(), widget.reading());
  QVERIFY(widget.grab().toImage() != plain);
  moveTo(widget, pixelOf(widget, 0, 2));
  QCOMPARE(widget.reading(), QString("fast: 100 ms, 0.5"));
  moveTo(widget, QPoint(1, 1));
  QCOMPARE(widget.reading(), QString());
  QCOMPARE(spy.count(), 3);
  QCOMPARE(widget.grab().toImage(), plain);
}

void PlotWidgetTest::keysWalkAlongThePoints() {
  PlotWidget widget;
  widget.resize(480, 320);
  widget.setPlot(plotWidgetTrade());
  const auto after = [&](Qt::Key key) {
    QTest::keyClick(&widget, key);
    return widget.reading();
  };
  QCOMPARE(after(Qt::Key_Right), QString("fast: 1 ms, 10"));
  QCOMPARE(after(Qt::Key_Left), QString("fast: 1 ms, 10"));      // there is none before
  QCOMPARE(after(Qt::Key_Right), QString("fast: 100 ms, 0.5"));  // values that are no number are skipped
  QCOMPARE(after(Qt::Key_Right), QString("fast: 100 ms, 0.5"));
  QCOMPARE(after(Qt::Key_Down), QString("slow: 20 ms, 3"));  // the last of a shorter series
  QCOMPARE(after(Qt::Key_Down), QString("slow: 20 ms, 3"));
  QCOMPARE(after(Qt::Key_Left), QString("slow: 2 ms, 8"));
  QCOMPARE(after(Qt::Key_Up), QString("fast: 1 ms, 10"));
  QCOMPARE(after(Qt::Key_Escape), QString());
}

void PlotWidgetTest::anotherPlot() {
  PlotWidget widget;
  widget.resize(480, 320);
  widget.setPlot(plotWidgetTrade());
  QTest::keyClick(&widget, Qt::Key_Down);
  Plot other = plotWidgetTrade();
  other.series.clear();
  other.title = "Other";
  widget.setPlot(other);  // the point that was read out no longer exists
  QCOMPARE(widget.reading(), QString());
  QCOMPARE(widget.accessibleName(), QString("Other"));
  widget.grab();
}

void PlotWidgetTest::nothingToRead() {
  PlotWidget widget;
  widget.resize(3, 3);
  for (Qt::Key key : {Qt::Key_Right, Qt::Key_Up, Qt::Key_Escape}) QTest::keyClick(&widget, key);
  moveTo(widget, QPoint(1, 1));
  QCOMPARE(widget.reading(), QString());
  widget.setPlot(plotWidgetTrade());
  widget.grab();
}

HANDWHEEL_WIDGET_TEST(PlotWidgetTest)
#include "PlotWidgetTest.moc"
