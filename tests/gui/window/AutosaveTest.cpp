// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "document/RecordingsEdit.h"
#include "document/recovery/OrphanedAutosaves.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/FileActions.h"

#include <QPushButton>
#include <QStandardPaths>

using namespace handwheel;
using namespace handwheel::test;

// What was not saved when the program ended without asking comes back at the next start.
class AutosaveTest : public QObject {
  Q_OBJECT

 private:
  // The names of the autosaves.
  static QStringList stored() {
    const QString root = QString::fromStdString(recoveryFolder().string());
    QStringList names;
    for (const QString& session : QDir(root).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
      names << QDir(root + "/" + session).entryList({"*.handwheel"}, QDir::Files, QDir::Name);
    }
    return names;
  }
  static bool isStored() { return !stored().isEmpty(); }

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
    second.window().offerRecovery();
    second.click("messageAction");
    QVERIFY(QTest::qWaitFor([&] { return second.tabs() == 1; }, kPatienceMs));
    QVERIFY(second.settle());
    QCOMPARE(second.text("figures"), wanted);
    QVERIFY(second.window().isWindowModified());
  }

  // However long the interval is that was chosen, what is finished is stored soon; and again with the next edit.
  void everyEditIsStoredSoon() {
    QSettings().setValue("autosaveSeconds", 600);
    {
      WindowDriver driver;
      driver.choose("newWorkpiece");
      QVERIFY(driver.settle());
      driver.edit("diameter", "33");
      QVERIFY(QTest::qWaitFor(isStored, 30000));
      const DocumentTab* tab = driver.find<DocumentTabs>("tabRow")->current();
      driver.edit("diameter", "34");
      QVERIFY(tab->autosaved != tab->document.revision());
      QVERIFY(QTest::qWaitFor([tab] { return tab->autosaved == tab->document.revision(); }, 30000));
      QVERIFY(driver.settle());
    }
    QSettings().setValue("autosaveSeconds", 5);
  }

  // Who does not want them back is not asked again; nor about those that cannot be read.
  void leftoversCanBeDiscarded() {
    const QString session = QString::fromStdString(recoveryFolder().string()) + "/dead";
    QVERIFY(QDir().mkpath(session));
    for (const char* name : {"damaged.handwheel", "worse.handwheel"}) {
      QFile file(session + "/" + name);
      QVERIFY(file.open(QIODevice::WriteOnly) && file.write("no container") > 0);
    }
    {
      WindowDriver driver;
      driver.choose("newWorkpiece");
      QVERIFY(driver.settle());
      driver.edit("diameter", "33");
      QVERIFY(QTest::qWaitFor([] { return stored().size() == 3; }, 30000));
    }
    WindowDriver second;
    second.window().offerRecovery();
    QVERIFY(second.text("messageText").contains("1 document had changes"));
    second.click("messageOther");
    QCOMPARE(stored().size(), 3);  // asked once more
    second.click("messageAction");
    QVERIFY(second.text("messageText").contains("1 document had changes"));  // kept
    second.click("messageOther");
    second.click("messageOther");
    QCOMPARE(stored(), QStringList({"damaged.handwheel", "worse.handwheel"}));
    QVERIFY2(second.text("messageText").contains("2 autosaves"), qPrintable(second.text("messageText")));
    second.click("messageAction");
    QCOMPARE(stored(), QStringList());
    QVERIFY(!second.find<QWidget>("messageBar")->isVisible());
    second.window().offerRecovery();
    QVERIFY(!second.find<QWidget>("messageBar")->isVisible());
  }

  // The folder of autosaves cannot be made: somebody has to save by hand.
  void aFailureIsTold() {
    const QString folder = QString::fromStdString(recoveryFolder().string());
    QVERIFY(QDir().mkpath(QFileInfo(folder).path()));
    QFile inItsPlace(folder);
    QVERIFY(inItsPlace.open(QIODevice::WriteOnly));
    {
      WindowDriver driver;
      driver.choose("newWorkpiece");
      QVERIFY(driver.settle());
      driver.edit("diameter", "33");
      QTRY_VERIFY_WITH_TIMEOUT(driver.find<QWidget>("messageBar")->isVisible(), 30000);
      QVERIFY2(driver.text("messageText").contains("autosaved"), qPrintable(driver.text("messageText")));
      driver.click("messageClose");
      QTest::qWait(6000);  // it was tried again
      QVERIFY(!driver.find<QWidget>("messageBar")->isVisible());
    }
    QVERIFY(inItsPlace.remove());
  }

  // Nothing of the model has changed.
  void aRecordingAloneIsStored() {
    WindowDriver driver;
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    Document& document = driver.find<DocumentTabs>("tabRow")->current()->document;
    document.commit("recorded",
                    std::make_unique<RecordingsEdit>(std::vector<StoredRecording>{{"0001", "a", "", 0.0, {}}}));
    QVERIFY(driver.window().isWindowModified());
    QVERIFY(QTest::qWaitFor(isStored, 30000));
  }
};

HANDWHEEL_WINDOW_TEST(AutosaveTest)
#include "AutosaveTest.moc"
