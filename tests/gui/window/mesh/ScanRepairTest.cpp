// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../StlFiles.h"
#include "../WindowDriver.h"
#include "../WindowTestMain.h"

using namespace handwheel;
using namespace handwheel::test;

// A real scan, the Stanford bunny with its five holes (80, 42, 40, 39 and 22 edges), repaired by hand. Pictures of the
// steps go to the folder that HANDWHEEL_PICTURES names, for people to look at.
class ScanRepairTest : public QObject {
  Q_OBJECT

 private:
  static void picture(WindowDriver& driver, const char* name) {
    const QString folder = qEnvironmentVariable("HANDWHEEL_PICTURES");
    if (folder.isEmpty()) return;
    QTest::qWait(1500);  // flights end, patches are drawn
    QVERIFY(driver.window().grab().save(folder + "/" + QString::fromLatin1(name) + ".png"));
  }

 private slots:
  void bunny() {
    const QString data = qEnvironmentVariable("HANDWHEEL_DATA");
    if (data.isEmpty()) QSKIP("HANDWHEEL_DATA is not set");
    QTemporaryDir folder;
    WindowDriver driver;
    driver.click("quickActions/openFile");
    QVERIFY(driver.enterFileName("openDialog", data + "/scans/common-3d-test-models/stanford-bunny.obj"));
    QVERIFY(driver.settle());
    QCOMPARE(driver.count(DefectKind::Hole), 5);
    QCOMPARE(driver.text("figures"), QString::fromUtf8("69,451 triangles · 5 holes"));
    picture(driver, "bunny-1-opened");

    driver.clickDefect(DefectKind::Hole, 2);
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("previewStatus").contains("new triangle"), kPatienceMs);
    picture(driver, "bunny-2-preview");
    driver.click("fillHoleButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 4, kPatienceMs);
    QVERIFY(driver.settle());
    picture(driver, "bunny-3-filled");
    driver.click("quickActions/undo");
    QCOMPARE(driver.count(DefectKind::Hole), 5);
    QCOMPARE(driver.text("figures"), QString::fromUtf8("69,451 triangles · 5 holes"));
    QVERIFY(driver.settle());
    picture(driver, "bunny-4-undone");
    driver.click("quickActions/redo");
    QCOMPARE(driver.count(DefectKind::Hole), 4);

    driver.click("repairAllButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("stateHeadline"), "Watertight", kPatienceMs);
    picture(driver, "bunny-5-watertight");
    driver.choose("saveFileAs");
    const QString saved = folder.filePath("bunny.stl");
    QVERIFY(driver.enterFileName("saveDialog", saved));
    QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isWindowModified(), kPatienceMs);
    const auto triangles = readStl(saved);
    QVERIFY(triangles.size() > 69451);
    QCOMPARE(openEdges(triangles), 0);
    picture(driver, "bunny-6-saved");
  }
};

HANDWHEEL_WINDOW_TEST(ScanRepairTest)
#include "ScanRepairTest.moc"
