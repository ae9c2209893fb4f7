// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"

#include <QMessageBox>
#include <QTimer>

using namespace handwheel;
using namespace handwheel::test;

// What happens to changed documents that are closed: once, twice, while they are saved, when saving fails.
class ClosingTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  // Opens a file with one hole and fills it.
  void openChanged(WindowDriver& driver, const QString& path) {
    writeStl(path, quadTorus(48, 24, {{3, 5}}));
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
    bool asked = false;
    QTimer::singleShot(200, qApp, [answer, &asked] {
      asked = prompt() != nullptr;
      press(answer);
    });
    driver.click("closeTab");
    return QTest::qWaitFor([&asked] { return asked && !prompt(); }, kPatienceMs);
  }

 private slots:
  // The second time nobody asks: it is being closed. What was asked then was answered when the document was gone.
  void twiceWhileItIsSaved() {
    WindowDriver driver;
    const QString path = m_folder.filePath("twice.stl");
    openChanged(driver, path);
    driver.hold();
    QVERIFY(closeAndAnswer(driver, QMessageBox::Save));
    bool askedAgain = false;
    QTimer::singleShot(200, qApp, [&] {
      askedAgain = prompt() != nullptr;
      driver.release();
    });
    QTimer::singleShot(1500, qApp, [] { press(QMessageBox::Save); });
    driver.click("closeTab");
    QTRY_COMPARE_WITH_TIMEOUT(driver.tabs(), 0, kPatienceMs);
    QTest::qWait(1500);  // until whatever is asked was answered
    QVERIFY(!askedAgain);
    QCOMPARE(openEdges(readStl(path)), 0);
    QVERIFY(driver.window().isVisible());
  }

  // Quitting waits for the save that closes the document.
  void quittingWhileItIsSaved() {
    WindowDriver driver;
    const QString path = m_folder.filePath("quit.stl");
    openChanged(driver, path);
    driver.hold();
    QVERIFY(closeAndAnswer(driver, QMessageBox::Save));
    QTimer::singleShot(200, qApp, [&driver] { driver.release(); });
    driver.window().close();
    QVERIFY(!prompt());
    QVERIFY(driver.window().isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isVisible(), kPatienceMs);
    QCOMPARE(openEdges(readStl(path)), 0);
  }

  // What has not changed closes at once, and so does the window.
  void quittingWithoutChanges() {
    WindowDriver driver;
    for (const char* name : {"one.stl", "two.stl"}) {
      writeStl(m_folder.filePath(name), quadTorus(12, 8, {}));
      QVERIFY(driver.open(m_folder.filePath(name)));
    }
    driver.find<QAction>("quit")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isVisible(), kPatienceMs);
    QCOMPARE(driver.tabs(), 0);
  }

  void whoCancelsIsAskedAgain() {
    WindowDriver driver;
    openChanged(driver, m_folder.filePath("again.stl"));
    QVERIFY(closeAndAnswer(driver, QMessageBox::Cancel));
    QCOMPARE(driver.tabs(), 1);
    QVERIFY(closeAndAnswer(driver, QMessageBox::Discard));
    QTRY_COMPARE(driver.tabs(), 0);
  }

  // It is still open, changed, and asked about.
  void whatCouldNotBeSavedStaysOpen() {
    QTemporaryDir folder;
    WindowDriver driver;
    openChanged(driver, folder.filePath("lost.stl"));
    QVERIFY(folder.remove());
    QVERIFY(closeAndAnswer(driver, QMessageBox::Save));
    QTRY_VERIFY_WITH_TIMEOUT(driver.find<QWidget>("messageBar")->isVisible(), kPatienceMs);
    QVERIFY2(driver.text("messageText").contains("lost.stl"), qPrintable(driver.text("messageText")));
    QCOMPARE(driver.tabs(), 1);
    QVERIFY(closeAndAnswer(driver, QMessageBox::Discard));
    QTRY_COMPARE(driver.tabs(), 0);
  }

  // So is what was to get a name, but got none.
  void withoutANameItStaysOpen() {
    WindowDriver driver;
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    driver.edit("diameter", "33");
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
