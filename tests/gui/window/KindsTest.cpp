// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "viewport/surface/PartsLayer.h"
#include "window/documents/FileFilters.h"

#include <QDockWidget>

using namespace handwheel;
using namespace handwheel::test;

// Workpieces and robot cells in the window: opened, changed by field and slider, undone, saved and opened again.
class KindsTest : public QObject {
  Q_OBJECT

 private slots:
  void aWorkpieceFromStartPageToFile() {
    const QTemporaryDir folder;
    WindowDriver driver;
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 1);
    QCOMPARE(driver.find<QDockWidget>("kindDock")->windowTitle(), QStringLiteral("Stock"));
    const QString before = driver.text("figures");

    driver.edit("diameter", "2in");
    QVERIFY(driver.text("figures") != before);
    driver.edit("length", "50*2.5");
    driver.click("quickActions/undo");
    driver.click("quickActions/undo");
    QCOMPARE(driver.text("figures"), before);
    driver.click("quickActions/redo");
    driver.click("quickActions/redo");

    const QString path = folder.filePath("bar.handwheel");
    driver.click("quickActions/saveFile");
    QVERIFY(driver.enterFileName("saveDialog", path));
    QVERIFY(driver.settle());
    QVERIFY(!driver.window().isWindowModified());
    const QString saved = driver.text("figures");

    WindowDriver second;
    QVERIFY(second.open(path));
    QCOMPARE(second.text("figures"), saved);
    QVERIFY(!second.window().isWindowModified());
  }

  // Files have the drawing of the kind that reads them; what none reads, of the one that writes it.
  void filesAreDrawnByTheirEndings() {
    const BuiltInKinds registered(builtInKinds());
    const DocumentKinds& kinds = registered.set.documents;
    for (const auto& [name, drawing] : {std::pair{"a.STL", "kind-mesh"},
                                        {"a.3mf", "kind-mesh"},
                                        {"a.urdf", "kind-cell"},
                                        {"a.step", "kind-mesh"},
                                        {"a.handwheel", "handwheel"},
                                        {"a.txt", "file"}}) {
      QCOMPARE(iconNameFor(kinds, name), QString::fromLatin1(drawing));
    }
  }

  // Each tile of the start page opens a document that was shipped, which is not written over.
  void everyTileOpensASample() {
    for (const auto& [tile, name] : {std::pair{"sampleTile", "scan-with-holes.stl"},
                                     {"latheTile", "shaft-stock.handwheel"},
                                     {"lessonTile", "first-lesson.exercise.json"},
                                     {"cellTile", "robot-cell.handwheel"}}) {
      WindowDriver driver;
      driver.click(tile);
      QVERIFY(driver.settle());
      QCOMPARE(driver.tabs(), 1);
      QCOMPARE(driver.find<QTabBar>("documentTabBar")->tabText(0), QString::fromLatin1(name));
      driver.click("quickActions/saveFile");
      QTRY_VERIFY(driver.window().findChild<QFileDialog*>("saveDialog"));
      driver.window().findChild<QFileDialog*>("saveDialog")->reject();
    }
  }

  // "Press N to see the first one, then Enter to close it."
  void theScanTileDoesWhatItSays() {
    WindowDriver driver;
    driver.click("sampleTile");
    QVERIFY(driver.settle());
    const int before = driver.count(DefectKind::Hole);
    QVERIFY(before > 0);
    auto* view = driver.find<Viewport>("viewport");
    view->setFocus();
    QTest::keyClick(view, Qt::Key_N);
    QVERIFY(driver.settle());
    QTRY_VERIFY(driver.find<QAction>("fillHole")->isEnabled());
    QTest::keyClick(view, Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), before - 1, kPatienceMs);
  }

  void aRobotMovesByItsSliders() {
    WindowDriver driver;
    driver.choose("openRobotSample");
    QVERIFY(driver.settle());
    QCOMPARE(driver.find<QDockWidget>("kindDock")->windowTitle(), QStringLiteral("Cell"));
    const QImage before = driver.find<Viewport>("viewport")->grabImage();
    driver.edit("joint.joint_2", "45");
    QVERIFY(driver.window().isWindowModified());
    QVERIFY(driver.find<Viewport>("viewport")->grabImage() != before);
    driver.click("quickActions/undo");
    QVERIFY(!driver.window().isWindowModified());
  }

  // While a link is dragged its joint, value and limits stand beside the cursor; they go with the release.
  void aDraggedJointTellsItsValue() {
    WindowDriver driver;
    driver.choose("openRobotSample");
    QVERIFY(driver.settle());
    auto* view = driver.find<Viewport>("viewport");
    QTRY_VERIFY(view->isPickingReady());
    const auto* readout = driver.find<QLabel>("toolReadout");
    // The hand of the arm is what sees most of its joints below it; anything that is no part of the foot will do.
    QPoint grip;
    for (int y = 20; y < view->height() && grip.isNull(); y += 10) {
      for (int x = 20; x < view->width() && grip.isNull(); x += 10) {
        const ViewRay ray = view->rayAt(QPointF(x, y));
        if (!partOf(view->pickAlong(ray.origin, ray.direction)).empty()) grip = {x, y};
      }
    }
    QVERIFY(!grip.isNull());
    QTest::mousePress(view, Qt::LeftButton, {}, grip);
    QVERIFY(!readout->isVisible());
    const QPoint to = grip + QPoint(40, 25);
    QMouseEvent move(QEvent::MouseMove, to, view->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(view, &move);
    QVERIFY(readout->isVisible());
    QVERIFY2(readout->text().contains("joint_") && readout->text().contains(QStringLiteral("°")),
             qPrintable(readout->text()));
    QVERIFY2(readout->text().contains(" to "), qPrintable(readout->text()));
    QVERIFY(view->rect().contains(readout->geometry()));
    QTest::mouseRelease(view, Qt::LeftButton, {}, to);
    QVERIFY(!readout->isVisible());
    QVERIFY(driver.settle());
  }
};

HANDWHEEL_WINDOW_TEST(KindsTest)
#include "KindsTest.moc"
