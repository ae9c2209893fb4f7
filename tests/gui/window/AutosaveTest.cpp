// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "document/RecordingsEdit.h"
#include "document/RecoveryLeftovers.h"
#include "window/DocumentTabs.h"
#include "window/FileActions.h"
#include "window/OpenDocument.h"

#include <QPushButton>
#include <QStandardPaths>

using namespace handwheel;
using namespace handwheel::test;

// What was not saved when the program ended without asking comes back at the next start.
class AutosaveTest : public QObject {
  Q_OBJECT

 private:
  static bool isStored() {
    const QString root = QString::fromStdString(recoveryFolder().string());
    for (const QString& session : QDir(root).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
      if (!QDir(root + "/" + session).entryList({"*.handwheel"}).isEmpty()) return true;
    }
    return false;
  }

 private slots:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    QSettings().setValue("autosaveSeconds", 5);
  }

  void init() { QDir(QString::fromStdString(recoveryFolder().string())).removeRecursively(); }

  void anUnsavedWorkpieceIsOfferedAndRecovered() {
    QString wanted;
    {
      WindowDriver driver;
      driver.choose("newWorkpiece");
      QVERIFY(driver.settle());
      driver.edit("diameter", "33");
      wanted = driver.text("figures");
      QVERIFY(QTest::qWaitFor(isStored, 30000));
    }  // the window goes without asking, as in a crash: nothing was saved
    WindowDriver second;
    QCOMPARE(second.tabs(), 0);
    second.window().offerLeftovers();
    second.click("messageAction");
    QVERIFY(QTest::qWaitFor([&] { return second.tabs() == 1; }, kPatienceMs));
    QVERIFY(second.settle());
    QCOMPARE(second.text("figures"), wanted);
    QVERIFY(second.window().isWindowModified());
  }

  // Nothing of the model has changed.
  void aRecordingAloneIsStored() {
    WindowDriver driver;
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    Document& document = driver.find<DocumentTabs>("tabRow")->current()->document;
    document.commit("recorded",
                    std::make_unique<RecordingsEdit>(std::vector<KeptRecording>{{"0001", "a", "", 0.0, {}}}));
    QVERIFY(driver.window().isWindowModified());
    QVERIFY(QTest::qWaitFor(isStored, 30000));
  }
};

HANDWHEEL_WINDOW_TEST(AutosaveTest)
#include "AutosaveTest.moc"
