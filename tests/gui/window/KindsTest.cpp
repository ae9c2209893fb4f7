// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "controls/PropertyList.h"
#include "document/Document.h"

#include <QDockWidget>
#include <QUndoStack>

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

  void aRobotMovesByItsSliders() {
    WindowDriver driver;
    driver.choose("openRobotSample");
    QVERIFY(driver.settle());
    QCOMPARE(driver.find<QDockWidget>("kindDock")->windowTitle(), QStringLiteral("Joints"));
    const QImage before = driver.find<Viewport>("viewport")->grabImage();
    driver.edit("joint.joint_2", "45");
    QVERIFY(driver.window().isWindowModified());
    QVERIFY(driver.find<Viewport>("viewport")->grabImage() != before);
    driver.click("quickActions/undo");
    QVERIFY(!driver.window().isWindowModified());
  }
};

HANDWHEEL_WINDOW_TEST(KindsTest)
#include "KindsTest.moc"
