// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ShapeModels.h"
#include "TestClass.h"
#include "viewport/overlay/Legend.h"
#include "viewport/overlay/LegendLayer.h"
#include "viewport/overlay/Overlay.h"
#include "viewport/overlay/StrokeText.h"

#include <rapidcheck.h>
#include <QtTest>
#include <functional>

using namespace handwheel;

namespace {

QImage overlayOf(const CameraState& camera) {
  QImage image(400, 300, QImage::Format_RGB888);
  image.fill(Qt::white);
  QPainter painter(&image);
  paintOverlay(painter, image.size(), camera, LengthUnit::Millimetre, sceneColours(false));
  return image;
}

QImage linesIn(const CameraState& camera, const std::vector<std::vector<Vec3>>& lines) {
  QImage image(400, 300, QImage::Format_RGB888);
  image.fill(Qt::white);
  QPainter painter(&image);
  paintLines(painter, CameraNavigation(camera, {400, 300}), lines, sceneColours(false));
  return image;
}

Silhouette inkOf(const QImage& image) {
  QImage blank(image.size(), image.format());
  blank.fill(Qt::white);
  return silhouette(image, blank);
}

}  // namespace

// Without an application object that has fonts, like the command line.
class OverlayTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }

  void scaleBarsAreRound_data() {
    QTest::addColumn<double>("unitsPerPixel");
    QTest::addColumn<int>("unit");
    QTest::addColumn<double>("pixels");
    QTest::addColumn<QString>("label");
    const auto row = [](double upp, LengthUnit unit, double pixels, const char* label) {
      QTest::newRow(label) << upp << static_cast<int>(unit) << pixels << QString::fromUtf8(label);
    };
    row(0.1, LengthUnit::Millimetre, 100, "10 mm");
    row(0.4, LengthUnit::Millimetre, 125, "50 mm");
    row(1e-4, LengthUnit::Millimetre, 100, "10 µm");
    row(10, LengthUnit::Millimetre, 100, "1 m");
    row(0.254, LengthUnit::Inch, 100, "1 in");
    row(1, LengthUnit::Centimetre, 100, "10 cm");
    row(1, LengthUnit::Metre, 100, "0.1 m");
  }

  void scaleBarsAreRound() {
    QFETCH(double, unitsPerPixel);
    QFETCH(int, unit);
    const ScaleBar bar = scaleBar(unitsPerPixel, 160, static_cast<LengthUnit>(unit));
    QTEST(bar.pixels, "pixels");
    QTEST(bar.label(), "label");
  }

  // The legend for the colours of another layer is the same as for coloured meshes; without a scale there is none.
  void aLayerWithALegendAlone() {
    const auto picture = [](const std::function<void(QPainter&, const QSizeF&)>& paint) {
      QImage image(400, 500, QImage::Format_RGB888);
      image.fill(Qt::white);
      QPainter painter(&image);
      paint(painter, image.size());
      return image;
    };
    const SceneColours colours = sceneColours(false);
    LegendLayer layer;
    const auto ofLayer = [&] {
      return picture([&](QPainter& painter, const QSizeF& size) {
        layer.paintOver(painter, size, LengthUnit::Millimetre, colours);
      });
    };
    const QImage blank = picture([](QPainter&, const QSizeF&) {});
    QVERIFY(ofLayer() == blank);
    layer.setScale(ColourScale{0.1});
    const QImage legend = picture([&](QPainter& painter, const QSizeF& size) {
      paintLegend(painter, size, ColourScale{0.1}, LengthUnit::Millimetre, colours);
    });
    QVERIFY(legend != blank && ofLayer() == legend);
    QVERIFY(layer.bounds().isEmpty());
    layer.setScale(std::nullopt);
    QVERIFY(ofLayer() == blank);
  }

  void scaleBarsFillTheirRoom() {
    QVERIFY(rc::check([] {
      const double upp = std::pow(10.0, *rc::gen::inRange(-9000, 9000) / 1000.0);
      const ScaleBar bar = scaleBar(upp, 160);
      RC_ASSERT(bar.pixels <= 160 * (1 + 1e-9));
      RC_ASSERT(bar.pixels > 160 / 2.5 * (1 - 1e-9));
      RC_ASSERT(std::abs(bar.length - bar.pixels * upp) < 1e-9 * bar.length);
    }));
  }

  // No single length is valid for the whole of a picture in perspective.
  void onlyParallelPicturesHaveAScaleBar() {
    CameraState camera;
    const QImage parallel = overlayOf(camera);
    camera.projection = Projection::Perspective;
    const QImage perspective = overlayOf(camera);
    QVERIFY(inkOf(parallel.copy(200, 200, 200, 100)).area > 100);
    QCOMPARE(inkOf(perspective.copy(200, 200, 200, 100)).area, 0.0);
    QVERIFY(inkOf(perspective.copy(0, 180, 140, 120)).area > 100);  // the axes stay
  }

  // From the front of the triad, x points right and y up.
  void axesPointInTheirDirections() {
    const QImage image = overlayOf(CameraState{});
    const auto inkIn = [&](const QColor& axis) {
      QImage blank(image.size(), image.format());
      blank.fill(Qt::white);
      return silhouette(image, blank, [&](QRgb c) { return difference(c, axis.rgb()) < 24; });
    };
    const Silhouette x = inkIn(QColor(0xe0, 0x4b, 0x43)), y = inkIn(QColor(0x4c, 0xa8, 0x4f));
    QVERIFY(x.area > 30 && y.area > 30);
    QVERIFY(x.centroid.x() > y.centroid.x() + 10);
    QVERIFY(y.centroid.y() < x.centroid.y() - 10);
  }

  void linesBreakBehindTheEye() {
    CameraState camera;
    camera.height = 3;  // a hundredth to the pixel
    camera.projection = Projection::Perspective;
    const double behind = 2 * camera.eyeDistance();
    const Silhouette line = inkOf(linesIn(camera, {{{-1, 0, 0}, {1, 0, 0}, {0, 1, behind}, {5, 5, behind}}}));
    QVERIFY(std::abs(line.right + 1 - line.left - 200) <= 6);
    QVERIFY(line.bottom - line.top <= 6);
    QVERIFY((line.centroid - Eigen::Vector2d(200, 150)).norm() < 1);
    QCOMPARE(inkOf(linesIn(camera, {{{0, 0, behind}, {1, 0, behind}}})).area, 0.0);
  }

  void strokesAreReadable() {
    const QString signs = QString::fromUtf8("0123456789XYZmµcin.,-");
    std::vector<QPainterPath> paths;
    for (const QChar sign : signs) {
      const QPainterPath path = strokeText(sign, 9);
      QVERIFY(!path.isEmpty());
      QVERIFY(path.boundingRect().top() >= -9 && path.boundingRect().bottom() <= 3);
      QVERIFY(path.boundingRect().right() <= strokeTextWidth(sign, 9) + 1e-9);
      for (const QPainterPath& other : paths) QVERIFY(!(path == other));
      paths.push_back(path);
    }
    QVERIFY(strokeText(QStringLiteral(" ?"), 9).isEmpty());
    QVERIFY(strokeTextWidth(QStringLiteral("10 mm"), 9) > strokeTextWidth(QStringLiteral("1 mm"), 9));
    QCOMPARE(strokeTextWidth({}, 9), 0.0);
  }
};

HANDWHEEL_TEST(OverlayTest)
#include "OverlayTest.moc"
