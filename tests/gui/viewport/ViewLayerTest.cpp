// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PointsLayer.h"
#include "ShapeModels.h"
#include "SheetView.h"

#include <QSignalSpy>

using namespace handwheel;
using test::PointsLayer;

namespace {

const double kDotArea = PointsLayer::kDot * PointsLayer::kDot;  // VTK draws squares

}  // namespace

// A layer that the viewport does not know, beside a mesh.
class ViewLayerTest : public ViewportFixture {
  Q_OBJECT

  std::shared_ptr<PointsLayer> m_points;
  QImage m_plain;  // without points

  void show(std::vector<Vec3> points) {
    m_points->setPoints(std::move(points));
    m_view->setCamera(sheetFromAbove());
  }
  double dotsDrawn() { return silhouette(m_view->grabImage(), m_plain).area / kDotArea; }

 private slots:
  void init() {
    makeView();
    m_points = std::make_shared<PointsLayer>();
    m_mesh->setMesh(buildMesh(sheet(kCells)).mesh);
    m_view->setCamera(sheetFromAbove());
    QTRY_VERIFY_WITH_TIMEOUT(m_view->isPickingReady(), 20000);
    m_plain = m_view->grabImage();
    m_view->addLayer(m_points);
  }

  void isDrawnWhereItsPointsAre() {
    show({{4, 6, 1}, {15, 12, 1}, {8, 8, -1}});  // the last one is below the sheet
    const Silhouette drawn = silhouette(m_view->grabImage(), m_plain);
    QVERIFY(std::abs(drawn.area / kDotArea - 2.0) < 0.3);
    const QPointF middle = (onScreen(4, 6) + onScreen(15, 12)) / 2.0;
    QVERIFY((drawn.centroid - Eigen::Vector2d(middle.x(), middle.y())).norm() < 1.0);
    show({});
    QCOMPARE(m_view->grabImage(), m_plain);
  }

  void isClippedByThePlane() {
    show({{4, 6, 1}, {15, 12, 1}});
    m_view->setClipPlane({Vec3::UnitX(), 10.0, true});
    m_points->setVisible(false);
    m_plain = m_view->grabImage();  // half of the sheet
    m_points->setVisible(true);
    QVERIFY(std::abs(dotsDrawn() - 1.0) < 0.2);
    QVERIFY(m_view->pickAt(onScreen(15, 12)).isNothing());
    QCOMPARE(m_view->pickAt(onScreen(4, 6)).layer, m_points.get());
  }

  void isHiddenAndShownWithoutBeingBuiltAgain() {
    show({{4, 6, 1}, {15, 12, 1}, {30, 12, 1}});
    m_view->grabImage();
    QVERIFY(m_view->bounds().max().x() == 30.0);
    const int built = m_view->blocksBuilt();
    m_points->setVisible(false);
    QCOMPARE(m_view->grabImage(), m_plain);
    QVERIFY(faceOf(m_view->pickAt(onScreen(4, 6))) != kNone);
    QVERIFY(m_view->bounds().max().x() == 20.0);
    m_points->setVisible(true);
    QVERIFY(dotsDrawn() > 1.5);
    QCOMPARE(m_view->blocksBuilt(), built);
  }

  void isPickedBeforeTheSurfaceBehindIt() {
    show({{4, 6, 1}, {8, 8, -1}});
    const Pick point = m_view->pickAt(onScreen(4, 6) + QPointF(3, 0));
    QCOMPARE(point.layer, m_points.get());
    QCOMPARE(point.element, std::uint64_t{0});
    QCOMPARE(point.point, Vec3(4, 6, 1));
    QVERIFY(point.isNear && std::abs(point.distance - 3.0) < 1e-9);
    QVERIFY(faceOf(m_view->pickAt(onScreen(4, 6) + QPointF(PointsLayer::kReach + 1, 0))) != kNone);
    QVERIFY(faceOf(m_view->pickAt(onScreen(8, 8))) != kNone);  // the sheet hides the other one
    QVERIFY(partOf(point).empty() && faceOf(point) == kNone && loopOf(point) == -1);
  }

  void isHoveredAndReported() {
    show({{4, 6, 1}, {15, 12, 1}});
    const QImage before = m_view->grabImage();
    QSignalSpy hovered(m_view.get(), &Viewport::hovered);
    QTest::mouseMove(m_view.get(), onScreen(15, 12).toPoint());
    QTRY_VERIFY(!hovered.isEmpty() && hovered.last()[0].value<Pick>().layer == m_points.get());
    QCOMPARE(m_points->hovered(), std::optional<std::uint64_t>(1));
    QCOMPARE(m_view->cursor().shape(), Qt::PointingHandCursor);
    QVERIFY(std::abs(silhouette(m_view->grabImage(), before).area / kDotArea - 1.0) < 0.3);  // in another colour
    m_points->movePoint(1, {12, 16, 1});  // its position changed: nothing is hovered until the mouse moves
    QVERIFY(hovered.last()[0].value<Pick>().isNothing() && !m_points->hovered());
    m_view->removeLayer(*m_points);
    QVERIFY(m_view->pickAt(onScreen(4, 6)).layer == m_mesh.get());
    QCOMPARE(m_view->grabImage(), m_plain);
  }

  // A sheet of 20 with a point far to its right: both are in the fitted view, the point at its position.
  void isFitted() {
    show({{60, 10, 0}});
    m_view->setStandardView(StandardView::Top);
    const CameraState camera = m_view->camera();
    QVERIFY(std::abs(camera.centre.x() - 30.0) < 1e-6);
    QVERIFY(std::abs(camera.height * 600 / 500 - 60 / 0.86) < 1e-6);
    // At a distance from the mesh far larger than its size, the drawing follows, and stays exact.
    m_mesh->setVisible(false);
    m_points->setPoints({{1e6, 0, 0}, {1e6 + 2, 0, 0}});
    m_view->setStandardView(StandardView::Top);
    QVERIFY((m_view->camera().centre - Vec3(1e6 + 1, 0, 0)).norm() < 1e-6);
  }

  // A change costs its block, and no frame is drawn when nothing changes.
  void buildsTheBlocksConcerned() {
    std::vector<Vec3> many;
    for (int i = 0; i < 2500; ++i) many.emplace_back(i % 50 * 0.4, i / 50 * 0.4, 1);
    const int before = m_view->blocksBuilt();
    show(many);
    m_view->grabImage();
    QCOMPARE(m_view->blocksBuilt(), before + 3);
    m_points->movePoint(1234, {1, 1, 2});
    m_view->grabImage();
    QCOMPARE(m_view->blocksBuilt(), before + 4);
    many[2100] = {2, 2, 2};  // all are given, one has moved
    m_points->movePoints(many);
    m_view->grabImage();
    QCOMPARE(m_view->blocksBuilt(), before + 6);  // with that of the point that moved back
    m_points->movePoints(many);
    m_view->grabImage();
    QCOMPARE(m_view->blocksBuilt(), before + 6);
    settle();
    const int frames = m_view->framesDrawn();
    QTest::qWait(200);
    QCOMPARE(m_view->framesDrawn(), frames);
    m_points->setVisible(false);
    settle();
    const int hidden = m_view->framesDrawn();
    m_points->movePoint(0, {1, 1, 2});  // hidden: uploaded when it is shown
    m_view->grabImage();
    QCOMPARE(m_view->blocksBuilt(), before + 6);
    m_points->setVisible(true);
    m_view->grabImage();
    QCOMPARE(m_view->blocksBuilt(), before + 7);
    QVERIFY(m_view->framesDrawn() > hidden);
  }
};

HANDWHEEL_DISPLAY_TEST(ViewLayerTest)

#include "ViewLayerTest.moc"
