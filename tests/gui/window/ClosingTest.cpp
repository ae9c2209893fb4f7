// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LargeInputs.h"
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"

#include <QDockWidget>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
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
  // The question about several documents.
  static QDialog* allPrompt() {
    auto* const dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    return dialog && dialog->objectName() == QLatin1String("closeAllPrompt") ? dialog : nullptr;
  }
  static QListWidget* list() { return allPrompt()->findChild<QListWidget*>("closePromptList"); }
  static QPushButton* saveButton() { return allPrompt()->findChild<QPushButton*>("closePromptSave"); }
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

  // One question names all changed documents, and no others; cancelling it keeps everything.
  void quittingAsksOnceAboutAllDocuments() {
    WindowDriver driver(kSmallWindow);
    writeStl(m_folder.filePath("whole.stl"), quadTorus(12, 8, {}));
    QVERIFY(driver.open(m_folder.filePath("whole.stl")));
    for (const char* name : {"kept.stl", "lost.stl", "third.stl"}) openChanged(driver, m_folder.filePath(name));
    driver.find<QAction>("quit")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(allPrompt(), kPatienceMs);
    QStringList asked;
    for (int row = 0; row < list()->count(); ++row) asked << list()->item(row)->text();
    QCOMPARE(asked, (QStringList{"kept.stl", "lost.stl", "third.stl"}));
    QCOMPARE(saveButton()->text(), QStringLiteral("&Save all"));
    allPrompt()->reject();
    QTRY_VERIFY(!QApplication::activeModalWidget());
    QTest::qWait(100);  // no more is asked
    QVERIFY(!QApplication::activeModalWidget());
    QCOMPARE(driver.tabs(), 4);
    QVERIFY(driver.window().isVisible());
    // Asked anew; this time two are saved, and one is not.
    driver.find<QAction>("quit")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(allPrompt(), kPatienceMs);
    list()->item(1)->setCheckState(Qt::Unchecked);
    QVERIFY(saveButton()->text() != QStringLiteral("&Save all"));
    saveButton()->click();
    QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isVisible(), kPatienceMs);
    QCOMPARE(openEdges(readStl(m_folder.filePath("kept.stl"))), 0);
    QVERIFY(openEdges(readStl(m_folder.filePath("lost.stl"))) > 0);
    QCOMPARE(openEdges(readStl(m_folder.filePath("third.stl"))), 0);
  }

  void quittingDiscardsAll() {
    WindowDriver driver(kSmallWindow);
    for (const char* name : {"a.stl", "b.stl"}) openChanged(driver, m_folder.filePath(name));
    driver.find<QAction>("quit")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(allPrompt(), kPatienceMs);
    allPrompt()->findChild<QPushButton*>("closePromptDiscard")->click();
    QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isVisible(), kPatienceMs);
    QVERIFY(openEdges(readStl(m_folder.filePath("a.stl"))) > 0);
  }

  // A document without a file is asked for a name. Who gives none keeps the program with all its documents, and the
  // answers are forgotten: the document that was to be discarded is asked about again.
  void quittingWithoutANameKeepsEverything() {
    WindowDriver driver(kSmallWindow);
    openChanged(driver, m_folder.filePath("unsaved.stl"));
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    driver.edit("diameter", "33");
    driver.find<QAction>("quit")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(allPrompt(), kPatienceMs);
    list()->item(0)->setCheckState(Qt::Unchecked);
    saveButton()->click();
    QTRY_VERIFY_WITH_TIMEOUT(driver.window().findChild<QFileDialog*>("saveDialog"), kPatienceMs);
    driver.find<QFileDialog>("saveDialog")->reject();
    QTRY_VERIFY(!driver.window().findChild<QFileDialog*>("saveDialog"));
    QCOMPARE(driver.tabs(), 2);
    QVERIFY(driver.window().isVisible());
    driver.find<DocumentTabs>("tabRow")->setCurrent(driver.find<DocumentTabs>("tabRow")->all().front().get());
    QVERIFY(closeAndAnswer(driver, QMessageBox::Cancel));
    QCOMPARE(driver.tabs(), 2);
    driver.find<QAction>("quit")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(allPrompt(), kPatienceMs);
    saveButton()->click();
    QTRY_VERIFY_WITH_TIMEOUT(driver.window().findChild<QFileDialog*>("saveDialog"), kPatienceMs);
    QVERIFY(driver.enterFileName("saveDialog", m_folder.filePath("named.handwheel")));
    QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isVisible(), kPatienceMs);
    QVERIFY(QFileInfo::exists(m_folder.filePath("named.handwheel")));
    QCOMPARE(openEdges(readStl(m_folder.filePath("unsaved.stl"))), 0);
  }

  // A document that cannot be saved keeps the program open, in view, and a message says so.
  void quittingStaysWithWhatCannotBeSaved() {
    QTemporaryDir folder;
    WindowDriver driver(kSmallWindow);
    openChanged(driver, folder.filePath("gone.stl"));
    openChanged(driver, m_folder.filePath("other.stl"));
    QVERIFY(folder.remove());
    driver.find<QAction>("quit")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(allPrompt(), kPatienceMs);
    saveButton()->click();
    QTRY_VERIFY_WITH_TIMEOUT(driver.find<QWidget>("messageBar")->isVisible(), kPatienceMs);
    QVERIFY2(driver.text("messageText").contains("gone.stl"), qPrintable(driver.text("messageText")));
    QVERIFY(driver.window().isVisible());
    QCOMPARE(driver.tabs(), 2);
  }

  // A document that changes after its answer, while another is saved, is asked about again.
  void changedAfterTheAnswer() {
    WindowDriver driver(kSmallWindow);
    openChanged(driver, m_folder.filePath("early.stl"));
    openChanged(driver, m_folder.filePath("late.stl"));
    driver.hold();
    driver.find<QAction>("quit")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(allPrompt(), kPatienceMs);
    saveButton()->click();
    QTRY_VERIFY(!QApplication::activeModalWidget());
    driver.find<DocumentTabs>("tabRow")->all().back()->document.history()->undo();
    driver.find<DocumentTabs>("tabRow")->all().back()->document.history()->redo();
    driver.release();
    QTRY_VERIFY_WITH_TIMEOUT(prompt() && prompt()->text().contains("late.stl"), kPatienceMs);
    QVERIFY(driver.window().isVisible());
    press(QMessageBox::Discard);
    QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isVisible(), kPatienceMs);
    QCOMPARE(openEdges(readStl(m_folder.filePath("early.stl"))), 0);
    QVERIFY(openEdges(readStl(m_folder.filePath("late.stl"))) > 0);
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
