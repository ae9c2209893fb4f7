// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "document/DisplayUnitEdit.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"

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

  // A job of a document that takes as long as the test wants, and changes the display unit.
  static void startChange(WindowDriver& driver, DocumentTab& tab, QSemaphore& release) {
    driver.useAllThreads();
    Job job;
    job.name = QStringLiteral("Changing the unit");
    job.document = &tab.document;
    job.work = [&tab, &release](Progress) -> Job::Finish {
      release.acquire();
      return [&tab] { tab.document.commit("unit", std::make_unique<DisplayUnitEdit>(LengthUnit::Inch)); };
    };
    driver.find<JobRunner>("jobs")->start(std::move(job));
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
  // Cancelling a repair does not cancel the save that ran meanwhile.
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

  // Esc in the view is the tool's and the selection's first; what is being saved is left alone.
  void escapeCancelsTheRepair() {
    WindowDriver driver;
    const QString path = openHalfRepaired(driver, "escape.stl");
    auto* view = driver.find<Viewport>("viewport");
    view->setFocus();
    driver.clickDefect(DefectKind::Hole, 0);
    driver.hold();
    driver.choose("saveFile");
    driver.choose("repairAll");
    driver.clickDefect(DefectKind::Hole, 0);
    view->setFocus();
    QTest::keyClick(view, Qt::Key_Escape);
    QTRY_VERIFY(!driver.find<QWidget>("holeSettings")->isVisible());
    QVERIFY(driver.find<QToolButton>("jobMore")->isVisible());
    QTest::keyClick(view, Qt::Key_Escape);
    QTRY_VERIFY(!driver.find<QToolButton>("jobMore")->isVisible());
    driver.release();
    QVERIFY(driver.settle());
    QCOMPARE(driver.count(DefectKind::Hole), 1);
    QVERIFY(!driver.window().isWindowModified());
    QCOMPARE(openEdges(readStl(path)), 4);
  }

  // The document in the other tab works on.
  void escapeLeavesTheJobsOfOtherDocuments() {
    QSemaphore release;
    WindowDriver driver;
    const auto atEnd = qScopeGuard([&] { release.release(2); });  // also if the test fails
    openHalfRepaired(driver, "first.stl");
    DocumentTab* const first = driver.find<DocumentTabs>("tabRow")->current();
    openHalfRepaired(driver, "second.stl");
    DocumentTab* const second = driver.find<DocumentTabs>("tabRow")->current();
    startChange(driver, *first, release);
    auto* const view = driver.find<Viewport>("viewport");
    view->setFocus();
    QTest::keyClick(view, Qt::Key_Escape);
    QVERIFY(driver.find<QWidget>("jobBar")->isVisible());
    QVERIFY2(driver.tip("jobName").contains("first.stl"), qPrintable(driver.tip("jobName")));
    // Also not from a panel, which is that of the document in view.
    auto* const list = driver.find<QWidget>("defectList");
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Escape);
    QVERIFY(!driver.find<QWidget>("messageBar")->isVisible());

    startChange(driver, *second, release);
    QTest::keyClick(list, Qt::Key_Escape);
    QTRY_VERIFY(driver.find<QWidget>("messageBar")->isVisible());
    const QString said = driver.text("messageText");
    QVERIFY2(said.contains("Changing the unit") && said.contains("cancelled") && said.contains("second.stl"),
             qPrintable(said));
    release.release(2);
    QVERIFY(driver.settle());
    QCOMPARE(first->document.displayUnit(), LengthUnit::Inch);
    QCOMPARE(second->document.displayUnit(), LengthUnit::Millimetre);
  }

  // Minutes of work in one tab are no matter to the others.
  void anInstantChangeDoesNotWaitForAnotherDocument() {
    QSemaphore release;
    WindowDriver driver;
    const auto atEnd = qScopeGuard([&] { release.release(2); });  // also if the test fails
    driver.useAllThreads();
    openHalfRepaired(driver, "slow.stl");
    DocumentTab* const slow = driver.find<DocumentTabs>("tabRow")->current();
    openHalfRepaired(driver, "quick.stl");
    startChange(driver, *slow, release);
    driver.clickDefect(DefectKind::Hole, 0);
    driver.click("fillHoleButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 0, kPatienceMs);
    QVERIFY2(driver.tip("jobName").contains("slow.stl"), qPrintable(driver.tip("jobName")));
    QCOMPARE(slow->document.displayUnit(), LengthUnit::Millimetre);
    release.release();
    QVERIFY(driver.settle());
    QCOMPARE(slow->document.displayUnit(), LengthUnit::Inch);
  }

  void closingADocumentLeavesTheJobsOfOthers() {
    QSemaphore release;
    WindowDriver driver;
    const auto atEnd = qScopeGuard([&] { release.release(2); });  // also if the test fails
    openHalfRepaired(driver, "kept.stl");
    auto* const tabs = driver.find<DocumentTabs>("tabRow");
    DocumentTab* const kept = tabs->current();
    openHalfRepaired(driver, "closed.stl");
    startChange(driver, *kept, release);
    startChange(driver, *tabs->current(), release);
    QVERIFY(driver.find<QToolButton>("jobMore")->isVisible());
    tabs->close(tabs->current());
    QTRY_VERIFY(!driver.find<QToolButton>("jobMore")->isVisible());
    QVERIFY2(driver.tip("jobName").contains("kept.stl"), qPrintable(driver.tip("jobName")));
    release.release(2);
    QVERIFY(driver.settle());
    QCOMPARE(kept->document.displayUnit(), LengthUnit::Inch);
  }

  // Whoever cancels something that was asked for reads that it is cancelled, also if no document has it.
  void aCancelledOpeningIsReported() {
    WindowDriver driver;
    const QString path = m_folder.filePath("opened.stl");
    writeStl(path, quadTorus(12, 8, {}));
    driver.hold();
    driver.window().openPaths({path});
    driver.click("jobCancel");
    QTRY_VERIFY(driver.find<QWidget>("messageBar")->isVisible());
    const QString said = driver.text("messageText");
    QVERIFY2(said.contains("opened.stl") && said.contains("cancelled"), qPrintable(said));
    driver.release();
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 0);
  }

  // A second click must not reduce what the first is reducing.
  void aReductionIsNotStartedTwice() {
    WindowDriver driver;
    openHalfRepaired(driver, "twice.stl");
    driver.find<QAction>("decimateTool")->trigger();
    const auto commit = [&] { return driver.find<QAbstractButton>("toolAction/commit"); };  // made anew at times
    QTRY_VERIFY(commit()->isEnabled());
    driver.hold();
    commit()->click();
    QTRY_VERIFY(!commit()->isEnabled());
    QVERIFY2(commit()->toolTip().contains("is running"), qPrintable(commit()->toolTip()));
    driver.release();
    QVERIFY(driver.settle());
    driver.find<QAction>("undo")->trigger();
    QTRY_VERIFY(commit()->isEnabled());
  }

  // Each job is in the list, and can be cancelled there. Nobody has to read the log to know what was not saved.
  void aCancelledSaveIsReported() {
    WindowDriver driver;
    const QString path = openHalfRepaired(driver, "list.stl");
    driver.hold();
    driver.choose("repairAll");
    driver.choose("saveFile");
    driver.click("jobMore");
    QCOMPARE(shownJobs(driver).size(), 2);
    QVERIFY2(shownJobs(driver)[1].contains("list.stl"), qPrintable(shownJobs(driver).join('\n')));
    driver.click("jobCancel/1");
    driver.release();
    QTRY_VERIFY_WITH_TIMEOUT(driver.find<QWidget>("messageBar")->isVisible(), kPatienceMs);
    QVERIFY2(driver.text("messageText").contains("list.stl"), qPrintable(driver.text("messageText")));
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
