// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ShapeModels.h"
#include "SheetView.h"
#include "mesh/selection/PreviewMesh.h"
#include "viewport/camera/CameraNavigation.h"

#include <QSignalSpy>
#include <QVBoxLayout>

using namespace handwheel;

class ViewportTest : public ViewportFixture {
  Q_OBJECT

  void showSheet(int cells = kCells) {
    m_mesh->setMesh(buildMesh(sheet(cells)).mesh);
    m_view->setCamera(sheetFromAbove());
    QTRY_VERIFY_WITH_TIMEOUT(m_view->isPickingReady(), 20000);
  }

 private slots:
  void picksTheFaceUnderTheCursor() {
    showSheet();
    for (const auto& [i, j] : {std::pair(0, 0), std::pair(3, 11), std::pair(19, 19)}) {
      const Pick lower = m_view->pickAt(onScreen(i + 0.7, j + 0.3)), upper = m_view->pickAt(onScreen(i + 0.3, j + 0.7));
      QCOMPARE(faceOf(lower), static_cast<Face>(2 * (j * kCells + i)));
      QCOMPARE(faceOf(upper), static_cast<Face>(2 * (j * kCells + i) + 1));
      QVERIFY((lower.point - Vec3(i + 0.7, j + 0.3, 0)).norm() < 1e-9);
    }
    QVERIFY(m_view->pickAt(onScreen(-1, 5)).isNothing());
  }

  void loopWinsWithinEightPixels() {
    showSheet();
    m_mesh->setLoops({squareLoop(0, Qt::blue)});
    const QPointF onLine = onScreen(10.3, 5);
    for (const double dy : {-7.5, 0.0, 7.5}) {
      const Pick pick = m_view->pickAt(onLine + QPointF(0, dy));
      QCOMPARE(loopOf(pick), 7);
      QCOMPARE(faceOf(pick), kNone);
      QVERIFY((pick.point - Vec3(10.3, 5, 0)).norm() < 1e-9);
    }
    for (const double dy : {-8.5, 8.5}) {
      QCOMPARE(loopOf(m_view->pickAt(onLine + QPointF(0, dy))), -1);
      QVERIFY(faceOf(m_view->pickAt(onLine + QPointF(0, dy))) != kNone);
    }
  }

  void hiddenLoopIsNotPicked() {
    showSheet();
    m_mesh->setLoops({squareLoop(-3, Qt::blue)});
    const Pick pick = m_view->pickAt(onScreen(10.3, 5));
    QCOMPARE(loopOf(pick), -1);
    QVERIFY(faceOf(pick) != kNone);
  }

  void clickAndHoverTellWhatIsThere() {
    showSheet();
    m_mesh->setLoops({squareLoop(0, Qt::blue)});
    QSignalSpy clicked(m_view.get(), &Viewport::clicked), hovered(m_view.get(), &Viewport::hovered);
    QTest::mouseMove(m_view.get(), onScreen(5, 10).toPoint());
    QTRY_VERIFY(!hovered.isEmpty());
    QCOMPARE(loopOf(hovered.last()[0].value<Pick>()), 7);
    QTest::mouseClick(m_view.get(), Qt::LeftButton, Qt::ShiftModifier, onScreen(5, 10).toPoint());
    QCOMPARE(clicked.size(), 1);
    QCOMPARE(loopOf(clicked[0][0].value<Pick>()), 7);
    QCOMPARE(clicked[0][1].value<Qt::KeyboardModifiers>(), Qt::ShiftModifier);
    QTest::mouseMove(m_view.get(), onScreen(-2, -1).toPoint());
    QTRY_VERIFY(hovered.last()[0].value<Pick>().isNothing());
  }

  void middleDragTurnsAndIsNoClick() {
    showSheet();
    QSignalSpy clicked(m_view.get(), &Viewport::clicked);
    const QPoint from(300, 250), to(360, 250);
    const Vec3 pivot = m_view->pickAt(from).point;
    QTest::mousePress(m_view.get(), Qt::MiddleButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, to, m_view->mapToGlobal(to), Qt::NoButton, Qt::MiddleButton, Qt::NoModifier);
    QApplication::sendEvent(m_view.get(), &move);
    QTest::mouseRelease(m_view.get(), Qt::MiddleButton, {}, to);
    const CameraState turned = m_view->camera();
    QVERIFY(turned.orientation.angularDistance(sheetFromAbove().orientation) > 0.1);
    // The grabbed point stays at its position.
    const Vec2 after = CameraNavigation(turned, {600, 500}).toScreen(pivot);
    QVERIFY((after - Vec2(300, 250)).norm() < 1e-6);
    QVERIFY(clicked.isEmpty());
  }

  void leftDragOnTheModelLeavesTheCamera() {
    showSheet();
    const QPoint from(300, 250), to(360, 250);
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, to, m_view->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(m_view.get(), &move);
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, to);
    QCOMPARE(m_view->camera(), sheetFromAbove());
  }

  void cameraRoundTrip() {
    CameraState c;
    c.centre = Vec3(1, -2, 3e5);
    c.orientation = Eigen::Quaterniond(0.5, -0.5, 0.1, 0.7).normalized();
    c.height = 0.25;
    m_view->setCamera(c);
    QCOMPARE(m_view->camera(), c);
    m_mesh->setMesh(buildMesh(sheet(2)).mesh);  // a new model does not move the camera
    QCOMPARE(m_view->camera(), c);
  }

  void flightEndsAtItsGoal() {
    showSheet();
    m_view->flyTo(Box(Vec3(4, 4, 0), Vec3(6, 6, 0)), Vec3(0, 0, -2));
    const CameraState goal = m_view->camera();
    QVERIFY((goal.centre - Vec3(5, 5, 0)).norm() < 1e-9);
    QVERIFY((goal.towardsViewer() + Vec3::UnitZ()).norm() < 1e-9);
    QSignalSpy moved(m_view.get(), &Viewport::cameraChanged);
    QTRY_VERIFY(!moved.isEmpty());
    QTest::qWait(600);
    QCOMPARE(m_view->camera(), goal);
  }

  void aFittedModelMakesRoomForWhatCoversIt() {
    showSheet();
    m_view->setStandardView(StandardView::Top);
    const CameraState whole = m_view->camera();
    m_view->setCovered(200);
    const CameraState aside = m_view->camera();
    QVERIFY(aside.height > whole.height);
    QVERIFY(CameraNavigation(aside, {600, 500}).toScreen(Vec3(10, 0, 0)).y() < 300);  // its lower edge
    m_view->setCovered(250);
    QCOMPARE(m_view->camera(), aside);  // a card that grows zooms nothing
    m_view->setCovered(0);
    QCOMPARE(m_view->camera(), aside);  // uncovered pixels are used at the next fit
    m_view->setCamera(sheetFromAbove());
    m_view->setCovered(200);
    QCOMPARE(m_view->camera(), sheetFromAbove());  // set by the user
  }

  void drawsModelLoopAndMarks() {
    showSheet();
    const QColor loop(0x00, 0x72, 0xb2), dot(0xcc, 0x79, 0xa7), line(0x00, 0x9e, 0x73);
    QVERIFY(pixelsNear(m_view->grabImage(), loop) < 20);
    m_mesh->setLoops({squareLoop(0, loop)});
    m_mesh->setPointMarks({{{{2, 2, 0}, {18, 18, 0}}, dot}});
    m_mesh->setLineMarks({{{{Vec3(1, 10, 0), Vec3(4, 10, 0)}}, line}});
    const QImage image = m_view->grabImage();
    QCOMPARE(image.size(), m_view->size() * m_view->devicePixelRatioF());
    const int perimeter = 4 * 10 * 20;
    QVERIFY(pixelsNear(image, loop) > 2 * perimeter);
    QVERIFY(pixelsNear(image, loop) < 5 * perimeter);
    QVERIFY(pixelsNear(image, dot) > 40);
    QVERIFY(pixelsNear(image, line) > 60);
    // Sheet and background differ, and nothing shines through.
    QVERIFY(image.pixelColor(300, 250) != image.pixelColor(20, 20));
    QCOMPARE(image.pixelColor(300, 250).alpha(), 255);
  }

  void previewTintsTheModel() {
    showSheet();
    const QColor before = m_view->grabImage().pixelColor(300, 230);
    m_mesh->setPreview({{5, 5, 0}, {15, 5, 0}, {10, 16, 0}}, {{0, 1, 2}});
    const QColor with = m_view->grabImage().pixelColor(300, 230);
    QVERIFY(with.blue() - with.red() > before.blue() - before.red() + 30);
    m_mesh->setPreview({}, {});
    QCOMPARE(m_view->grabImage().pixelColor(300, 230), before);
  }

  void updateBuildsOnlyTheBlocksConcerned() {
    const int cells = 300;  // 180 000 faces: three blocks
    HalfEdgeMesh mesh = buildMesh(sheet(cells)).mesh;
    m_mesh->setMesh(mesh);
    m_view->setCamera(sheetFromAbove());
    m_view->grabImage();
    QCOMPARE(m_view->blocksBuilt(), 3);
    const Face inSecond = 100000;  // its neighbours are within a few rows of 600 faces
    mesh.removeFace(inSecond);
    m_mesh->updateMesh(mesh, {inSecond});
    m_view->grabImage();
    QCOMPARE(m_view->blocksBuilt(), 4);
    const Face lastOfFirst = 65535;  // shares corners with the next block
    mesh.removeFace(lastOfFirst);
    m_mesh->updateMesh(mesh, {lastOfFirst});
    m_view->grabImage();
    QCOMPARE(m_view->blocksBuilt(), 6);
  }

  // For versions at any rate, the last one stays; and the mesh when there is none any more.
  void aPreviewMeshReplacesTheMesh() {
    showSheet();
    const HalfEdgeMesh mesh = buildMesh(sheet(kCells)).mesh;
    const QPoint middle = onScreen(10.5, 10.5).toPoint();
    const QColor before = m_view->grabImage().pixelColor(middle);
    auto live = std::make_shared<PreviewMesh>(PreviewMesh{mesh, {}});
    for (Face f = 0; f < mesh.faceSlots(); ++f) {
      live->touched.add(f);
      live->mesh.removeFace(f);
      if (f % 50 == 0) m_mesh->setPreviewMesh(std::make_shared<PreviewMesh>(*live));
    }
    m_mesh->setPreviewMesh(live);
    const QImage empty = m_view->grabImage();
    QVERIFY(empty.pixelColor(middle) != before);
    QVERIFY(faceOf(m_view->pickAt(onScreen(10.7, 10.3))) != kNone);  // a face of the mesh
    m_mesh->setPreviewMesh(nullptr);
    QCOMPARE(m_view->grabImage().pixelColor(middle), before);
  }

  void removedFaceIsNoLongerPicked() {
    showSheet();
    HalfEdgeMesh mesh = buildMesh(sheet(kCells)).mesh;
    const Face gone = faceOf(m_view->pickAt(onScreen(10.7, 10.3)));
    mesh.removeFace(gone);
    m_mesh->updateMesh(mesh, {gone});
    QTRY_VERIFY_WITH_TIMEOUT(m_view->isPickingReady(), 20000);
    QVERIFY(m_view->pickAt(onScreen(10.7, 10.3)).isNothing());
  }

  // For a dock that floats: the widget gets another context and must draw on.
  void survivesAnotherContext() {
    showSheet();
    m_mesh->setLoops({squareLoop(0, QColor(0x00, 0x72, 0xb2))});
    const int before = pixelsNear(m_view->grabImage(), QColor(0x00, 0x72, 0xb2));
    QWidget host;
    host.resize(600, 500);
    auto* layout = new QVBoxLayout(&host);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view.get());
    host.show();
    QVERIFY(QTest::qWaitForWindowExposed(&host));
    QCOMPARE(m_view->size(), QSize(600, 500));
    QCOMPARE(pixelsNear(m_view->grabImage(), QColor(0x00, 0x72, 0xb2)), before);
    m_view.reset();
  }
};

HANDWHEEL_DISPLAY_TEST(ViewportTest)

#include "ViewportTest.moc"
