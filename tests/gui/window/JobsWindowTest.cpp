// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"

using namespace handwheel;
using namespace handwheel::test;

// Several jobs at once, and what becomes of the others when one of them is cancelled.
class JobsWindowTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  // With two holes, of which one is filled: so there is something to save and something to repair.
  QString openHalfRepaired(WindowDriver& driver, const char* name) {
    const QString path = m_folder.filePath(QString::fromLatin1(name));
    writeStl(path, quadTorus(48, 24, {{3, 5}, {20, 11}}));
    if (!driver.open(path)) qFatal("the file does not open");
    driver.clickDefect(DefectKind::Hole, 0);
    driver.click("fillHoleButton");
    if (!QTest::qWaitFor([&] { return driver.window().isWindowModified(); }, kPatienceMs)) qFatal("nothing is filled");
    if (!driver.settle()) qFatal("no end");
    return path;
  }

  static QStringList shownJobs(WindowDriver& driver) {
    QStringList names;
    auto* list = driver.find<QWidget>("jobList");
    for (auto* label : list->findChildren<QLabel*>()) {
      if (label->isVisible() && label->objectName().startsWith("jobName")) names << label->text();
    }
    return names;
  }

 private slots:
  // Who cancels a repair still wants what was saved while it ran.
  void aSaveGoesOnWhenTheRepairIsCancelled() {
    WindowDriver driver;
    const QString path = openHalfRepaired(driver, "both.stl");
    driver.hold();
    driver.choose("repairAll");
    driver.choose("saveFile");
    QVERIFY(driver.text("jobName").contains("Repairing"));
    driver.click("jobCancel");
    driver.release();
    QVERIFY(driver.settle());
    QVERIFY(!driver.window().isWindowModified());
    QCOMPARE(driver.count(DefectKind::Hole), 1);
    QCOMPARE(openEdges(readStl(path)), 4);
  }

  // Each job is in the list, and can be cancelled there. Nobody has to read the log to know what was not saved.
  void aCancelledSaveIsTold() {
    WindowDriver driver;
    const QString path = openHalfRepaired(driver, "told.stl");
    driver.hold();
    driver.choose("repairAll");
    driver.choose("saveFile");
    driver.click("jobMore");
    QCOMPARE(shownJobs(driver).size(), 2);
    QVERIFY2(shownJobs(driver)[1].contains("told.stl"), qPrintable(shownJobs(driver).join('\n')));
    driver.click("jobCancel/1");
    driver.release();
    QVERIFY(driver.find<QWidget>("messageBar")->isVisible());
    QVERIFY2(driver.text("messageText").contains("told.stl"), qPrintable(driver.text("messageText")));
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 0, kPatienceMs);  // the repair went on
    QVERIFY(driver.settle());
    QVERIFY(driver.window().isWindowModified());
    QCOMPARE(openEdges(readStl(path)), 8);
    driver.click("messageAction");
    QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isWindowModified(), kPatienceMs);
    QCOMPARE(openEdges(readStl(path)), 0);
  }
};

HANDWHEEL_WINDOW_TEST(JobsWindowTest)
#include "JobsWindowTest.moc"
