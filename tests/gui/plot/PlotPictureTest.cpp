// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "document/DocumentErrors.h"
#include "plot/PlotExport.h"
#include "plot/PlotLayout.h"

#include <sys/stat.h>
#include <QFile>
#include <QPainter>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <filesystem>
#include <limits>

using namespace handwheel;

namespace {

constexpr QSize kSize(480, 320);

Plot trade() {
  Plot plot;
  plot.title = "mesh.fill_method";
  plot.x = {"CPU time of a fill", "ms", true};
  plot.y = {"RMS distance", "mm", true};
  plot.series = {{"sphere, cut", {{1, 0.5}, {10, 0.05}, {100, 0.01}}, true},
                 {"torus \"thin\"", {{2, 0.3}, {20, std::nan("")}, {200, 0.02}}, true}};
  plot.marks = {{{10, 0.05}, "Balanced"}};
  return plot;
}

// Returns the number of pixels that are nearly of this colour.
int pixelsLike(const QImage& image, const QColor& colour, const QRect& where) {
  int count = 0;
  for (int y = where.top(); y <= where.bottom(); ++y) {
    for (int x = where.left(); x <= where.right(); ++x) {
      const QColor c = image.pixelColor(x, y);
      count +=
          std::abs(c.red() - colour.red()) + std::abs(c.green() - colour.green()) + std::abs(c.blue() - colour.blue()) <
          24;
    }
  }
  return count;
}

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class PlotPictureTest : public QObject {
  Q_OBJECT

 private slots:
  void pointsAreWhereTheirValuesAre_data();
  void pointsAreWhereTheirValuesAre();
  void oneMorePlotOneMoreCell();
  void barsStandOnTheAxis_data();
  void barsStandOnTheAxis();
  void linesWithoutPoints();
  void strangePlots();
  void files();
  void csv();
};

void PlotPictureTest::pointsAreWhereTheirValuesAre_data() {
  QTest::addColumn<ThemeKind>("theme");
  QTest::newRow("light") << ThemeKind::Light;
  QTest::newRow("dark") << ThemeKind::Dark;
}

void PlotPictureTest::pointsAreWhereTheirValuesAre() {
  QFETCH(ThemeKind, theme);
  Plot plot = trade();
  plot.series.resize(1);
  plot.marks.clear();
  const QImage image = plotImage(std::vector{plot}, kSize, theme);
  QCOMPARE(image.size(), kSize);
  QCOMPARE(image.pixelColor(1, 1), themeColours(theme).window);
  QFont font;
  font.setPixelSize(13);
  const PlotLayout layout(plot, QRectF(QPointF(), kSize), QFontMetricsF(font));
  const QColor colour = theme == ThemeKind::Dark ? QColor(0x0072b2).lighter(135) : QColor(0x0072b2);
  int atPoints = 0;
  for (const QPointF& p : plot.series[0].points) {
    const QPoint at = layout.toScreen(p).toPoint();
    QVERIFY(pixelsLike(image, colour, QRect(at - QPoint(2, 2), QSize(4, 4))) > 8);
    atPoints += pixelsLike(image, colour, QRect(at - QPoint(5, 5), QSize(10, 10)));
  }
  // Besides, only the line between them has that colour.
  const int elsewhere = pixelsLike(image, colour, image.rect()) - atPoints;
  QVERIFY2(elsewhere > 50 && elsewhere < 2000, qPrintable(QString::number(elsewhere)));
  // The ground is that of the theme; titles and numbers stand out from it.
  QVERIFY(pixelsLike(image, themeColours(theme).base, image.rect()) > kSize.width() * kSize.height() / 3);
  QVERIFY(pixelsLike(image, themeColours(theme).text, image.rect()) > 50);
}

void PlotPictureTest::barsStandOnTheAxis_data() {
  QTest::addColumn<bool>("logarithmic");
  QTest::newRow("linear") << false;
  QTest::newRow("logarithmic") << true;
}

// Above the axis the middle of each bar has its colour up to its value, and not beyond.
void PlotPictureTest::barsStandOnTheAxis() {
  QFETCH(bool, logarithmic);
  Plot plot;
  plot.y.logarithmic = logarithmic;
  PlotSeries bars{"bars", {{-1.0, 2.0}, {0.0, 8.0}, {1.0, 5.0}}};
  bars.barWidth = 1.0;
  bars.bars = {Qt::blue, Qt::green, Qt::red};
  plot.series = {bars};
  const QImage image = plotImage({&plot, 1}, kSize, ThemeKind::Light);
  QFont font;
  font.setPixelSize(13);
  const PlotLayout layout(plot, QRectF(QPointF(), kSize), QFontMetricsF(font));
  QVERIFY(logarithmic || layout.y().least <= 0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const QPointF top = layout.toScreen(bars.points[i]);
    const int x = static_cast<int>(top.x()), y = static_cast<int>(top.y());
    const int foot = static_cast<int>(logarithmic ? layout.frame().bottom() : layout.toScreen({0.0, 0.0}).y());
    QCOMPARE(image.pixelColor(x, y + 4), bars.bars[i]);
    QCOMPARE(image.pixelColor(x, foot - 4), bars.bars[i]);
    QVERIFY(image.pixelColor(x, y - 4) != bars.bars[i]);
  }
}

// A point without its shape leaves nothing but the line, as thin at the point as beside it. Both points lie between
// lines of the grid.
void PlotPictureTest::linesWithoutPoints() {
  Plot plot;
  plot.series = {{"level", {{-1.0, 1.0}, {0.25, 1.0}, {1.0, 1.0}}}};
  QFont font;
  font.setPixelSize(13);
  const PlotLayout layout(plot, QRectF(QPointF(), kSize), QFontMetricsF(font));
  const QPoint at = layout.toScreen({0.25, 1.0}).toPoint(), beside = layout.toScreen({0.7, 1.0}).toPoint();
  const auto inked = [&](const QPoint& point) {
    const QImage image = plotImage({&plot, 1}, kSize, ThemeKind::Light);
    const QRect around(point - QPoint(2, 8), point + QPoint(2, 8));
    return around.width() * around.height() - pixelsLike(image, themeColours(ThemeKind::Light).base, around);
  };
  QVERIFY(inked(at) > inked(beside));
  plot.series[0].dotted = false;
  QCOMPARE(inked(at), inked(beside));
  QVERIFY(inked(at) > 0);
}

void PlotPictureTest::oneMorePlotOneMoreCell() {
  QCOMPARE(plotImage(std::vector(1, trade()), kSize, ThemeKind::Light).size(), kSize);
  QCOMPARE(plotImage(std::vector(2, trade()), kSize, ThemeKind::Light).size(), QSize(960, 320));
  QCOMPARE(plotImage(std::vector(3, trade()), kSize, ThemeKind::Light).size(), QSize(960, 640));
  QCOMPARE(plotImage(std::vector(5, trade()), kSize, ThemeKind::Light).size(), QSize(1440, 640));
  QCOMPARE(plotImage(std::vector(2, trade()), kSize, ThemeKind::Light, 2.0).size(), QSize(1920, 640));
  const QImage two = plotImage(std::vector(2, trade()), kSize, ThemeKind::Light);
  QCOMPARE(two.copy(0, 0, 480, 320), two.copy(480, 0, 480, 320));
}

// No plot of a caller makes it crash or hang.
void PlotPictureTest::strangePlots() {
  const double infinity = std::numeric_limits<double>::infinity();
  Plot empty;
  Plot odd = trade();
  odd.series[0].points = {{0, 0}, {-1, 1e308}, {infinity, -infinity}, {std::nan(""), 1}, {1e-320, 5e-324}, {1e308, 2}};
  odd.marks = {{{infinity, 0}, "away"}, {{-5, 1}, "below"}};
  Plot single = trade();
  single.series = {{"one", {{3, 3}}, true}};
  single.marks.clear();
  for (const Plot& plot : {empty, odd, single}) {
    QVERIFY(!plotImage(std::vector{plot}, kSize, ThemeKind::Dark).isNull());
    plotImage(std::vector{plot}, QSize(5, 5), ThemeKind::Light);
  }
  QVERIFY(!plotImage({}, kSize, ThemeKind::Light).isNull());
}

void PlotPictureTest::files() {
  QTemporaryDir folder;
  const std::vector plots{trade()};
  for (const char* name : {"a.png", "a.svg", "a.CSV"}) {
    QVERIFY(exportPlots(plots, folder.filePath(name), kSize, ThemeKind::Light));
  }
  const QImage png(folder.filePath("a.png"));
  QCOMPARE(png.size(), 2 * kSize);
  QCOMPARE(contentOf(folder.filePath("a.CSV")), plotCsv(plots));
  // The SVG file shows what the picture shows.
  QSvgRenderer svg(folder.filePath("a.svg"));
  QVERIFY(svg.isValid());
  QCOMPARE(svg.viewBox(), QRect(QPoint(), kSize));
  QImage drawn(kSize, QImage::Format_RGB32);
  QPainter painter(&drawn);
  svg.render(&painter);
  painter.end();
  const QImage direct = plotImage(plots, kSize, ThemeKind::Light);
  const QColor blue(0x0072b2);
  const double ratio = double(pixelsLike(drawn, blue, drawn.rect())) / pixelsLike(direct, blue, direct.rect());
  QVERIFY2(ratio > 0.8 && ratio < 1.25, qPrintable(QString::number(ratio)));

  const Status wrongEnding = exportPlots(plots, folder.filePath("a.bmp"), kSize, ThemeKind::Light);
  QVERIFY(!wrongEnding && wrongEnding.error().code == DocumentError::ExtensionUnknown);
  const Status noFolder = exportPlots(plots, folder.filePath("none/a.png"), kSize, ThemeKind::Light);
  QVERIFY(!noFolder && noFolder.error().code == ErrorCode::WriteFailed);

  // A link stays a link, and anything but a regular file is left alone.
  QVERIFY(QFile::link("a.png", folder.filePath("link.png")));
  QVERIFY(exportPlots(plots, folder.filePath("link.png"), kSize, ThemeKind::Dark));
  QVERIFY(QFileInfo(folder.filePath("link.png")).isSymLink());
  QVERIFY(QImage(folder.filePath("a.png")) != png);
  const std::filesystem::path pipe = folder.filePath("pipe").toStdString();
  QCOMPARE(mkfifo(pipe.c_str(), 0600), 0);
  QVERIFY(QFile::link("pipe", folder.filePath("pipe.csv")));
  const Status noFile = exportPlots(plots, folder.filePath("pipe.csv"), kSize, ThemeKind::Light);
  QVERIFY(!noFile && noFile.error().code == ErrorCode::WriteFailed);
  QVERIFY(std::filesystem::is_fifo(pipe) && QFileInfo(folder.filePath("pipe.csv")).isSymLink());
}

void PlotPictureTest::csv() {
  QCOMPARE(plotCsv(std::vector{trade()}), QByteArray("plot,series,x,y\n"
                                                     "mesh.fill_method,\"sphere, cut\",1,0.5\n"
                                                     "mesh.fill_method,\"sphere, cut\",10,0.05\n"
                                                     "mesh.fill_method,\"sphere, cut\",100,0.01\n"
                                                     "mesh.fill_method,\"torus \"\"thin\"\"\",2,0.3\n"
                                                     "mesh.fill_method,\"torus \"\"thin\"\"\",20,nan\n"
                                                     "mesh.fill_method,\"torus \"\"thin\"\"\",200,0.02\n"));
}

HANDWHEEL_WIDGET_TEST(PlotPictureTest)
#include "PlotPictureTest.moc"
