// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LargeInputs.h"
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"

#include <QDockWidget>
#include <QMessageBox>
#include <QTimer>

using namespace handwheel;
using namespace handwheel::test;

// Closing changed documents: once, twice, while they are saved, when saving fails.
class ClosingTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  // Opens a file with one hole and fills it.
  void openChanged(WindowDriver& driver, const QString& path) {
    writeStl(path, quadTorus(24, 12, {{3, 5}}));
    QVERIFY(driver.open(path));
    driver.clickDefect(DefectKind::Hole, 0);
    QTRY_VERIFY_WITH_TIMEOUT(driver.find<QAction>("fillHole")->isEnabled(), kPatienceMs);
    driver.click("fillHoleButton");
    QTRY_VERIFY_WITH_TIMEOUT(driver.window().isWindowModified(), kPatienceMs);
    QVERIFY(driver.settle());
  }

  static QMessageBox* prompt() { return qobject_cast<QMessageBox*>(QApplication::activeModalWidget()); }
  static void press(QMessageBox::StandardButton answer) {
    if (auto* box = prompt()) QTest::mouseClick(box->button(answer), Qt::LeftButton);
  }
  // Clicks what closes the document, and answers the prompt.
  static bool closeAndAnswer(WindowDriver& driver, QMessageBox::StandardButton answer) {
    driver.click("closeTab");
    if (!QTest::qWaitFor([] { return prompt() != nullptr; }, kPatienceMs)) return false;
    press(answer);
    return QTest::qWaitFor([] { return !prompt(); }, kPatienceMs);
  }

 private slots:
  // The second time nobody asks: it is being closed. What was asked then was answered when the document was gone.
  void twiceWhileItIsSaved() {
    WindowDriver driver(kSmallWindow);
    const QString path = m_folder.filePath("twice.stl");
    openChanged(driver, path);
    driver.hold();
    QVERIFY(closeAndAnswer(driver, QMessageBox::Save));
    driver.click("closeTab");
    const bool askedAgain = QTest::qWaitFor([] { return prompt() != nullptr; }, 100);
    driver.release();
    QTRY_COMPARE_WITH_TIMEOUT(driver.tabs(), 0, kPatienceMs);
    press(QMessageBox::Save);  // if anything is asked
    QVERIFY(driver.settle());
    QVERIFY(!askedAgain && !prompt());
    QCOMPARE(openEdges(readStl(path)), 0);
    QVERIFY(driver.window().isVisible());
  }

  // Quitting waits for the save that closes the document.
  void quittingWhileItIsSaved() {
    WindowDriver driver(kSmallWindow);
    const QString path = m_folder.filePath("quit.stl");
    openChanged(driver, path);
    driver.hold();
    QVERIFY(closeAndAnswer(driver, QMessageBox::Save));
    driver.window().close();
    QVERIFY(!prompt());
    QTest::qWait(50);
    QVERIFY(driver.window().isVisible());
    driver.release();
    QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isVisible(), kPatienceMs);
    QCOMPARE(openEdges(readStl(path)), 0);
  }

  // Unchanged documents close at once, and so does the window.
  void quittingWithoutChanges() {
    WindowDriver driver(kSmallWindow);
    for (const char* name : {"one.stl", "two.stl"}) {
      writeStl(m_folder.filePath(name), quadTorus(12, 8, {}));
      QVERIFY(driver.open(m_folder.filePath(name)));
    }
    driver.find<QAction>("quit")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isVisible(), kPatienceMs);
    QCOMPARE(driver.tabs(), 0);
  }

  // Cancelling at the last question keeps all documents, also those to be discarded and those without changes.
  void cancellingTheQuitKeepsEverything() {
    WindowDriver driver(kSmallWindow);
    writeStl(m_folder.filePath("whole.stl"), quadTorus(12, 8, {}));
    QVERIFY(driver.open(m_folder.filePath("whole.stl")));
    openChanged(driver, m_folder.filePath("first.stl"));
    openChanged(driver, m_folder.filePath("second.stl"));
    QStringList asked;
    QTimer answers;
    connect(&answers, &QTimer::timeout, qApp, [&asked] {
      if (!prompt()) return;
      asked << prompt()->text();
      press(asked.size() == 1 ? QMessageBox::Discard : QMessageBox::Cancel);
    });
    answers.start(20);
    driver.find<QAction>("quit")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(asked.size(), 2, kPatienceMs);
    QTest::qWait(100);  // no more is asked
    QCOMPARE(asked.size(), 2);
    QVERIFY(asked[0].contains("first.stl") && asked[1].contains("second.stl"));
    QCOMPARE(driver.tabs(), 3);
    QVERIFY(driver.window().isVisible());
    // Asked anew, and this time all goes.
    answers.disconnect();
    connect(&answers, &QTimer::timeout, qApp, [] { press(QMessageBox::Discard); });
    driver.find<QAction>("quit")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isVisible(), kPatienceMs);
  }

  // A document that changes after its answer, while another is saved, is asked about again.
  void changedAfterTheAnswer() {
    WindowDriver driver(kSmallWindow);
    openChanged(driver, m_folder.filePath("early.stl"));
    openChanged(driver, m_folder.filePath("late.stl"));
    driver.find<QAction>("quit")->trigger();
    for (const char* name : {"early.stl", "late.stl"}) {
      QTRY_VERIFY_WITH_TIMEOUT(prompt() && prompt()->text().contains(name), kPatienceMs);
      if (QByteArray(name) == "late.stl") driver.hold();
      press(QMessageBox::Save);
      QTRY_VERIFY(!prompt());
    }
    driver.find<DocumentTabs>("tabRow")->all().front()->document.history()->undo();
    driver.release();
    QTRY_VERIFY_WITH_TIMEOUT(prompt() && prompt()->text().contains("early.stl"), kPatienceMs);
    QVERIFY(driver.window().isVisible());
    press(QMessageBox::Discard);
    QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isVisible(), kPatienceMs);
    QCOMPARE(openEdges(readStl(m_folder.filePath("early.stl"))), 0);
    QCOMPARE(openEdges(readStl(m_folder.filePath("late.stl"))), 0);
  }

  // A copy of what has no changes: nobody is asked, but it is written before the window goes.
  void quittingWaitsForACopy() {
    for (const bool isTabClosed : {false, true}) {
      WindowDriver driver(kSmallWindow);
      const QString copy = m_folder.filePath(isTabClosed ? "copy-1.stl" : "copy-0.stl");
      writeStl(m_folder.filePath("original.stl"), quadTorus(12, 8, {}));
      QVERIFY(driver.open(m_folder.filePath("original.stl")));
      driver.hold();
      driver.choose("saveFileAs");
      QVERIFY(driver.enterFileName("saveDialog", copy));
      if (isTabClosed) driver.find<QAction>("closeDocument")->trigger();
      QTRY_COMPARE(driver.tabs(), isTabClosed ? 0 : 1);
      driver.find<QAction>("quit")->trigger();
      QTest::qWait(50);
      QVERIFY(driver.window().isVisible());
      driver.release();
      QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isVisible(), kPatienceMs);
      QCOMPARE(openEdges(readStl(copy)), 0);
      QVERIFY(!readStl(copy).empty());
    }
  }

  // Its tab is closed while it is saved, and another document gets the same address and has the same revision.
  void aSaveOfAClosedDocumentIsNotCreditedToAnother() {
    WindowDriver driver(kSmallWindow);
    auto* tabs = driver.find<DocumentTabs>("tabRow");
    const auto made = [&] {
      driver.choose("newWorkpiece");
      if (!tabs->current()->document.setProperty("diameter", 33.0)) qFatal("no diameter");
      return tabs->current();
    };
    const DocumentTab* const closed = made();
    QVERIFY(driver.settle());
    driver.hold();
    driver.choose("saveFileAs");
    QVERIFY(driver.enterFileName("saveDialog", m_folder.filePath("closed.handwheel")));
    QVERIFY(closeAndAnswer(driver, QMessageBox::Discard));
    QTRY_COMPARE(driver.tabs(), 0);
    const int most = test::sized(12, 30);
    while (driver.tabs() < most && made() != closed) continue;
    driver.release();
    QVERIFY(driver.settle());
    for (const auto& each : tabs->all()) QVERIFY(each->document.isModified() && each->document.path().isEmpty());
    if (tabs->current() != closed) QSKIP("no document got the same address");
  }

  // Panels call parts of the window when they hide: those are gone once its own destructor has run.
  void panelsHideBeforeTheWindowIsGone() {
    class HideWatch : public QObject {
     public:
      int hidden = 0, late = 0;
      bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Hide) return false;
        const QObject* window = watched;
        while (window->parent()) window = window->parent();
        ++hidden;
        late += qobject_cast<const MainWindow*>(window) ? 0 : 1;
        return false;
      }
    } watch;
    {
      WindowDriver driver(kSmallWindow);
      bool isFloating = false;
      for (QDockWidget* dock : driver.window().findChildren<QDockWidget*>()) {
        dock->setFloating(isFloating = !isFloating);
        dock->show();
        if (dock->widget()) dock->widget()->installEventFilter(&watch);
      }
      QTest::qWait(100);
    }
    QVERIFY(watch.hidden >= 4);
    QCOMPARE(watch.late, 0);
  }

  // It is still open, changed, and asked about.
  void whatCouldNotBeSavedStaysOpen() {
    QTemporaryDir folder;
    WindowDriver driver(kSmallWindow);
    openChanged(driver, folder.filePath("lost.stl"));
    QVERIFY(folder.remove());
    QVERIFY(closeAndAnswer(driver, QMessageBox::Save));
    QTRY_VERIFY_WITH_TIMEOUT(driver.find<QWidget>("messageBar")->isVisible(), kPatienceMs);
    QVERIFY2(driver.text("messageText").contains("lost.stl"), qPrintable(driver.text("messageText")));
    QCOMPARE(driver.tabs(), 1);
    QVERIFY(closeAndAnswer(driver, QMessageBox::Discard));
    QTRY_COMPARE(driver.tabs(), 0);
  }

  // So is what was to get a name, but got none. Who cancels is asked again, too.
  void withoutANameItStaysOpen() {
    WindowDriver driver(kSmallWindow);
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    driver.edit("diameter", "33");
    QVERIFY(closeAndAnswer(driver, QMessageBox::Cancel));
    QCOMPARE(driver.tabs(), 1);
    QVERIFY(closeAndAnswer(driver, QMessageBox::Save));
    QTRY_VERIFY(driver.window().findChild<QFileDialog*>("saveDialog"));
    driver.find<QFileDialog>("saveDialog")->reject();
    QTRY_VERIFY(!driver.window().findChild<QFileDialog*>("saveDialog"));
    QCOMPARE(driver.tabs(), 1);
    QVERIFY(closeAndAnswer(driver, QMessageBox::Discard));
    QTRY_COMPARE(driver.tabs(), 0);
  }
};

HANDWHEEL_WINDOW_TEST(ClosingTest)
#include "ClosingTest.moc"
