// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "GlobeWindow.h"
#include "ShapeModels.h"

#include <QTreeWidget>

using namespace handwheel;
using namespace handwheel::test;

// Points instead of triangles, shown by the layer of a kind that the program does not have.
class GlobeViewTest : public QObject {
  Q_OBJECT

  // The view without the globe.
  static QImage hidden(GlobeWindow& globe) {
    globe.driver.choose("toggleDocument");
    const QImage image = globe.view->grabImage();
    globe.driver.choose("toggleDocument");
    return image;
  }
  // The point that is nearest to the viewer of the front.
  static std::uint64_t frontmost(GlobeWindow& globe) {
    const std::vector<Vec3>& points = globe.layer().points();
    const auto found =
        std::min_element(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); });
    return static_cast<std::uint64_t>(found - points.begin());
  }

  static std::uint64_t mostAlone(GlobeWindow& globe) {
    std::vector<QPointF> pixels;
    for (const Vec3& p : globe.layer().points()) pixels.push_back(globe.pixelOf(p));
    std::uint64_t best = 0;
    double farthest = 0.0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      double nearest = 1e300;
      for (std::size_t k = 0; k < pixels.size(); ++k)
        if (k != i)
          nearest = std::min(nearest, std::hypot(pixels[i].x() - pixels[k].x(), pixels[i].y() - pixels[k].y()));
      if (nearest > farthest) farthest = nearest, best = i;
    }
    return best;
  }

 private slots:
  // The size is that of the sphere on which the points lie.
  void isDrawn() {
    GlobeWindow globe;
    QVERIFY(globe.begin());
    const QImage with = globe.view->grabImage();
    const Silhouette drawn = silhouette(with, hidden(globe));
    const double dot = PointsLayer::kDot;
    const double left = globe.pixelOf({-10, 0, 0}).x(), right = globe.pixelOf({10, 0, 0}).x();
    QVERIFY2(std::abs(drawn.left - (left - dot / 2)) < 6, qPrintable(QString::number(drawn.left - left)));
    QVERIFY(std::abs(drawn.right - (right + dot / 2)) < 6);
    QVERIFY(std::abs(drawn.bottom - drawn.top - (right - left + dot)) < 12);
  }

  // By the command that clips all documents: half of the globe is left.
  void isClipped() {
    GlobeWindow globe;
    QVERIFY(globe.begin());
    const Silhouette whole = silhouette(globe.view->grabImage(), hidden(globe));
    globe.driver.choose("clipModel");
    QVERIFY(globe.view->clipPlane().on);
    globe.view->setClipPlane({Vec3::UnitX(), 0.0, true});
    const Silhouette half = silhouette(globe.view->grabImage(), hidden(globe));
    QVERIFY(std::abs(half.left - whole.left) < 3);
    QVERIFY(std::abs(half.right - (globe.pixelOf(Vec3::Zero()).x() + PointsLayer::kDot / 2)) < 6);
    QVERIFY(globe.view->pickAt(globe.pixelOf(globe.layer().points()[1000])).isNothing() ==
            (globe.layer().points()[1000].x() > 0.0));
  }

  void isHidden() {
    GlobeWindow globe;
    QVERIFY(globe.begin());
    const QPointF pixel = globe.pixelOf(globe.layer().points()[frontmost(globe)]);
    QVERIFY(!globe.view->pickAt(pixel).isNothing());
    const int built = globe.view->blocksBuilt();
    globe.driver.choose("toggleDocument");
    QVERIFY(globe.view->bounds().isEmpty() && globe.view->pickAt(pixel).isNothing());
    globe.driver.choose("toggleDocument");
    globe.view->grabImage();
    QVERIFY(!globe.view->pickAt(pixel).isNothing());
    QCOMPARE(globe.view->blocksBuilt(), built);  // it was kept
  }

  // With a second document in front the layer is empty; back again it is as before, from the same side.
  void followsTheDocument() {
    GlobeWindow globe;
    QVERIFY(globe.begin());
    const QImage before = globe.view->grabImage();
    globe.driver.choose("newWorkpiece");
    QVERIFY(globe.driver.settle());
    QVERIFY(globe.layer().points().empty());
    globe.driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    QVERIFY(globe.driver.settle());
    QCOMPARE(globe.layer().points().size(), 2 * kGlobePoints);
    QVERIFY(globe.view->camera().towardsViewer().isApprox(Vec3(0, -1, 0)));
    QVERIFY(silhouette(globe.view->grabImage(), before).area < 10);
  }

  void isPickedAndHovered() {
    GlobeWindow globe;
    QVERIFY(globe.begin());
    const std::uint64_t number = frontmost(globe);
    const Pick pick = globe.view->pickAt(globe.pixelOf(globe.layer().points()[number]));
    QVERIFY(pick.layer == &globe.layer() && pick.element == number && pick.isNear);
    // On the screen this one is the farthest from all others.
    const std::uint64_t alone = mostAlone(globe);
    const QPoint pixel = globe.pixelOf(globe.layer().points()[alone]).toPoint();
    globe.moveTo({5, 5}, {});
    QTRY_VERIFY(!globe.layer().hovered());
    globe.moveTo(pixel, {});
    QTRY_COMPARE(globe.layer().hovered().value_or(0), alone);
  }
};

HANDWHEEL_WINDOW_TEST(GlobeViewTest)
#include "GlobeViewTest.moc"
