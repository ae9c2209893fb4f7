// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"

#include <QComboBox>
#include <QMessageBox>
#include <QTimer>
#include <chrono>
#include <filesystem>

using namespace handwheel;
using namespace handwheel::test;

// Parts of a document that a file of another program cannot hold are reported when it is saved.
class IncompleteSaveTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  // Opens a file with two holes, and marks one.
  QString openMarked(WindowDriver& driver, const char* name) {
    const QString path = m_folder.filePath(QString::fromLatin1(name));
    writeStl(path, quadTorus(48, 24, {{3, 5}, {20, 11}}));
    if (!driver.open(path)) qFatal("the file does not open");
    driver.clickDefect(DefectKind::Hole, 0);
    driver.click("keepOpenButton");
    if (driver.count(DefectKind::KeptOpen) != 1) qFatal("nothing is kept open");
    return path;
  }
  static bool save(WindowDriver& driver) {
    driver.choose("saveFile");
    return driver.settle() && !driver.window().isWindowModified();
  }
  static bool hasMessage(WindowDriver& driver) { return driver.find<QWidget>("messageBar")->isVisible(); }

 private slots:
  // The file is written as it was requested; the container that is offered holds the mark.
  void marksAreReportedAndAContainerIsOffered() {
    WindowDriver driver;
    const QString path = openMarked(driver, "marked.stl");
    QVERIFY(save(driver));
    QCOMPARE(openEdges(readStl(path)), 8);
    QVERIFY(hasMessage(driver));
    QVERIFY2(driver.text("messageText").contains("keep open"), qPrintable(driver.text("messageText")));
    driver.click("messageAction");
    const QString container = m_folder.filePath("marked.handwheel");
    QTRY_VERIFY(driver.window().findChild<QFileDialog*>("saveDialog"));
    QCOMPARE(driver.find<QFileDialog>("saveDialog")->selectedFiles(), QStringList(container));
    QVERIFY(driver.enterFileName("saveDialog", container));
    QVERIFY(driver.settle());
    QVERIFY(!hasMessage(driver));
    driver.click("closeTab");
    QVERIFY(driver.open(container));
    QCOMPARE(driver.count(DefectKind::KeptOpen), 1);
  }

  // A file that another program wrote meanwhile is not replaced without a question.
  void aFileThatChangedIsNotReplaced() {
    WindowDriver driver;
    const QString path = openMarked(driver, "changed.stl");
    writeStl(path, quadTorus(12, 8, {}));
    const auto now = std::filesystem::last_write_time(path.toStdString());
    std::filesystem::last_write_time(path.toStdString(), now + std::chrono::seconds(2));
    QVERIFY(!save(driver));
    QVERIFY2(driver.text("messageText").contains("another program"), qPrintable(driver.text("messageText")));
    QCOMPARE(openEdges(readStl(path)), 0);
    driver.click("messageOther");
    QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isWindowModified(), kPatienceMs);
    QVERIFY(driver.settle());
    QCOMPARE(openEdges(readStl(path)), 8);
    // Now it is the document's own again.
    driver.clickDefect(DefectKind::Hole, 0);
    driver.click("fillHoleButton");
    QTRY_VERIFY_WITH_TIMEOUT(driver.window().isWindowModified(), kPatienceMs);
    QVERIFY(save(driver));
  }

  // A change during a save is saved by the next save: no other program has written the file.
  void aChangeDuringASaveIsSavedNext() {
    WindowDriver driver;
    const QString path = openMarked(driver, "slow.stl");
    driver.hold();
    driver.choose("saveFile");
    auto* unit = driver.find<QWidget>("property/display_unit")->findChild<QComboBox*>();
    unit->setCurrentIndex(unit->findText("in"));
    emit unit->activated(unit->currentIndex());
    driver.release();
    QVERIFY(driver.settle());
    QVERIFY(driver.window().isWindowModified());
    QVERIFY2(save(driver), qPrintable(driver.text("messageText")));
    QCOMPARE(openEdges(readStl(path)), 8);
  }

  void twoQuickSavesAreNoForeignChange() {
    WindowDriver driver;
    openMarked(driver, "quick.stl");
    driver.hold();
    driver.choose("saveFile");
    driver.choose("saveFile");
    driver.release();
    QVERIFY(driver.settle());
    QVERIFY(!driver.window().isWindowModified());
    QVERIFY2(!driver.text("messageText").contains("another program"), qPrintable(driver.text("messageText")));
  }

  // A report that was read is not repeated at each save, unless there is something new.
  void itIsReportedOnce() {
    WindowDriver driver;
    openMarked(driver, "once.stl");
    QVERIFY(save(driver));
    driver.click("messageClose");
    driver.clickDefect(DefectKind::Hole, 0);
    driver.click("fillHoleButton");
    QTRY_VERIFY_WITH_TIMEOUT(driver.window().isWindowModified(), kPatienceMs);
    QVERIFY(save(driver));
    QVERIFY(!hasMessage(driver));
    auto* unit = driver.find<QWidget>("property/display_unit")->findChild<QComboBox*>();
    unit->setCurrentIndex(unit->findText("in"));
    emit unit->activated(unit->currentIndex());
    QTRY_VERIFY(driver.window().isWindowModified());
    QVERIFY(save(driver));
    QVERIFY(hasMessage(driver));
    QVERIFY2(driver.text("messageText").contains("display unit"), qPrintable(driver.text("messageText")));
  }

  // A closed document could not be saved any more: it stays open until its user knows.
  void closingWaitsUntilItWasReported() {
    WindowDriver driver;
    const QString path = openMarked(driver, "closed.stl");
    QTimer::singleShot(200, qApp, [] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!box) qFatal("nobody asks");
      QTest::mouseClick(box->button(QMessageBox::Save), Qt::LeftButton);
    });
    driver.click("closeTab");
    QTRY_VERIFY_WITH_TIMEOUT(hasMessage(driver), kPatienceMs);
    QCOMPARE(driver.tabs(), 1);
    QVERIFY(!driver.window().isWindowModified());
    driver.click("closeTab");
    QCOMPARE(driver.tabs(), 0);
  }

  void whatIsWholeIsNotReported() {
    WindowDriver driver;
    openMarked(driver, "whole.stl");
    driver.click("quickActions/undo");
    driver.clickDefect(DefectKind::Hole, 0);
    driver.click("fillHoleButton");
    QTRY_VERIFY_WITH_TIMEOUT(driver.window().isWindowModified(), kPatienceMs);
    QVERIFY(save(driver));
    QVERIFY(!hasMessage(driver));
  }
};

HANDWHEEL_WINDOW_TEST(IncompleteSaveTest)
#include "IncompleteSaveTest.moc"
