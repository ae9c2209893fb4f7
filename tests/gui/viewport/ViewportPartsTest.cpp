// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ShapeModels.h"
#include "SheetView.h"

#include <QSignalSpy>

using namespace handwheel;

// Models of parts with poses, such as robot cells, in the view.
class ViewportPartsTest : public ViewportFixture {
  Q_OBJECT

 private slots:
  void partsArePickedByName() {
    const auto box = shared(boxSoup({2, 2, 2}));
    DisplayModel model{{{"left", box}, {"right", box}}};
    model.parts[1].pose.translation() = Vec3(10, 10, 0);
    m_parts->setParts(model.parts);
    m_view->setCamera(sheetFromAbove());
    QTRY_VERIFY(m_view->isPickingReady());
    QCOMPARE(partOf(m_view->pickAt(onScreen(1, 1))), "left");
    QCOMPARE(partOf(m_view->pickAt(onScreen(11, 11))), "right");
    QVERIFY((m_view->pickAt(onScreen(11, 11.5)).point - Vec3(11, 11.5, 2)).norm() < 1e-9);
    m_view->grabImage();
    QCOMPARE(m_view->blocksBuilt(), 1);
    // The part is moved, not rebuilt: picking follows at once.
    model.parts[1].pose.translation() = Vec3(15, 5, 0);
    m_parts->setParts(model.parts);
    QVERIFY(m_view->isPickingReady());
    QVERIFY(m_view->pickAt(onScreen(11, 11)).isNothing());
    QSignalSpy hovered(m_view.get(), &Viewport::hovered);
    QTest::mouseMove(m_view.get(), onScreen(16, 6).toPoint());
    QTRY_VERIFY(!hovered.isEmpty());
    QCOMPARE(partOf(hovered.last()[0].value<Pick>()), "right");
    m_view->grabImage();
    QCOMPARE(m_view->blocksBuilt(), 1);
    QVERIFY((m_view->bounds().max() - Vec3(17, 7, 2)).norm() < 1e-12);
    model.parts.pop_back();
    m_parts->setParts(model.parts);
    QVERIFY(hovered.last()[0].value<Pick>().isNothing());
  }

  void meshAndPartsAreShownTogether() {
    m_mesh->setMesh(buildMesh(sheet(kCells)).mesh);
    m_view->setCamera(sheetFromAbove());
    DisplayModel model{{{"box", shared(boxSoup({2, 2, 2}))}}};
    model.parts[0].pose.translation() = Vec3(10, 10, 0);
    m_parts->setParts(model.parts);
    QTRY_VERIFY(m_view->isPickingReady());
    QCOMPARE(partOf(m_view->pickAt(onScreen(11, 11))), "box");
    QVERIFY(faceOf(m_view->pickAt(onScreen(5.3, 5.2))) != kNone);
    clear();
    QVERIFY(m_view->pickAt(onScreen(11, 11)).isNothing());
    QVERIFY(m_view->bounds().isEmpty());
  }

  void aModelOfPartsIsFitted() {
    DisplayModel model{{{"box", shared(boxSoup({2, 2, 2}))}}};
    model.parts[0].pose.translation() = Vec3(1e6, 0, 0);
    m_parts->setParts(model.parts);
    m_view->setStandardView(StandardView::Top);
    QVERIFY((m_view->camera().centre.head<2>() - Eigen::Vector2d(1e6 + 1, 1)).norm() < 1e-6);
    QVERIFY(std::abs(m_view->camera().height - 2 / 0.86) < 1e-6);
  }
};

HANDWHEEL_DISPLAY_TEST(ViewportPartsTest)

#include "ViewportPartsTest.moc"
