// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "document/RecordingsEdit.h"
#include "document/recovery/OrphanedAutosaves.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/FileActions.h"
#include "window/kinds/KindUi.h"

#include <QDirIterator>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPushButton>

using namespace handwheel;
using namespace handwheel::test;

// Unsaved changes are recovered at the next start after the program ended without asking.
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

  static void recoverIn(WindowDriver& driver) {
    driver.window().offerRecovery();
    driver.click("messageAction");
    QVERIFY(QTest::qWaitFor([&] { return driver.tabs() == 1; }, kPatienceMs));
    QVERIFY(driver.settle());
    QVERIFY(driver.window().isWindowModified());
  }
  // Opens a file, fills its hole, and ends without saving.
  static void openFillAndCrash(const QString& path) {
    WindowDriver driver;
    QVERIFY(driver.open(path));
    if (driver.tabs() == 0) driver.click("messageAction");  // opens what is readable
    QTRY_COMPARE_WITH_TIMEOUT(driver.tabs(), 1, kPatienceMs);
    QVERIFY(driver.settle());
    driver.clickDefect(DefectKind::Hole, 0);
    driver.click("fillHoleButton");
    QTRY_VERIFY_WITH_TIMEOUT(driver.window().isWindowModified(), kPatienceMs);
    QVERIFY(QTest::qWaitFor(isStored, 30000));
    QVERIFY(driver.settle());
  }

 private slots:
  void initTestCase() { QSettings().setValue("autosaveSeconds", 5); }

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
    QVERIFY(second.text("messageText").contains("as it was last autosaved"));
  }

  // A program that was just killed has its lock a while longer: its works are offered as soon as it is released.
  void whatIsStillLockedIsOfferedSoonAfter() {
    QString wanted;
    {
      WindowDriver driver;
      driver.choose("newWorkpiece");
      QVERIFY(driver.settle());
      driver.edit("diameter", "33");
      wanted = driver.text("figures");
      QVERIFY(QTest::qWaitFor(isStored, 30000));
    }
    std::optional<OrphanedAutosaves> held(std::in_place);  // has the locks, as the other program had
    QCOMPARE(held->found().size(), std::size_t{1});
    WindowDriver driver;
    driver.window().offerRecovery();
    QVERIFY(driver.settle());
    const auto isOffered = [&] { return driver.find<QPushButton>("messageAction")->isVisible(); };
    QVERIFY(!isOffered());
    held.reset();
    QVERIFY(QTest::qWaitFor(isOffered, kPatienceMs));
    driver.click("messageAction");
    QVERIFY(QTest::qWaitFor([&] { return driver.tabs() == 1; }, kPatienceMs));
    QVERIFY(driver.settle());
    QCOMPARE(driver.text("figures"), wanted);
  }

  // A document that was never saved keeps its name: in its tab, by Save and in the question at closing.
  void aNameWithoutAFileComesBack() {
    QString wanted;
    {
      WindowDriver driver;
      driver.click("lessonTile");
      QVERIFY(driver.settle());
      driver.choose("beginExercise");
      QVERIFY(driver.settle());
      Document& work = driver.find<DocumentTabs>("tabRow")->current()->document;
      wanted = work.name();
      QVERIFY2(wanted.startsWith("Work on "), qPrintable(wanted));
      QVERIFY(work.setProperty("chord", 0.05));
      QVERIFY(QTest::qWaitFor(isStored, 30000));
      QVERIFY(driver.settle());
    }
    WindowDriver driver;
    recoverIn(driver);
    const DocumentTab* recovered = driver.find<DocumentTabs>("tabRow")->current();
    QCOMPARE(recovered->document.name(), wanted);
    QVERIFY(recovered->document.path().isEmpty());
    QVERIFY2(recovered->ui.suggestedName(*recovered).startsWith("Work on "),
             qPrintable(recovered->ui.suggestedName(*recovered)));
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

  // A user who does not want them back is not asked again; nor about those that cannot be read.
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
  void aFailureIsReported() {
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

  // Its file is as it was when the document was opened; the second time somebody wrote it meanwhile.
  void whatIsRecoveredIsSaved() {
    QTemporaryDir folder;
    const QString path = folder.filePath("part.stl");
    writeStl(path, quadTorus(48, 24, {{3, 5}}));
    openFillAndCrash(path);
    {
      WindowDriver driver;
      recoverIn(driver);
      driver.choose("saveFile");
      QVERIFY(driver.settle());
      QVERIFY2(!driver.window().isWindowModified(), qPrintable(driver.text("messageText")));
      QCOMPARE(openEdges(readStl(path)), 0);
    }
    writeStl(path, quadTorus(48, 24, {{3, 5}}));
    openFillAndCrash(path);
    WindowDriver driver;
    writeStl(path, quadTorus(24, 12, {}));
    recoverIn(driver);
    driver.choose("saveFile");
    QVERIFY(driver.settle());
    QVERIFY2(driver.text("messageText").contains("another program"), qPrintable(driver.text("messageText")));
    QCOMPARE(readStl(path).size(), quadTorus(24, 12, {}).size());
  }

  // An autosave that does not say what its file was like. Once somebody has agreed, the document knows.
  void anUnknownFileIsNotOverwritten() {
    QTemporaryDir folder;
    const QString path = folder.filePath("part.stl");
    writeStl(path, quadTorus(48, 24, {{3, 5}}));
    openFillAndCrash(path);
    const QString root = QString::fromStdString(recoveryFolder().string());
    int changed = 0;
    for (QDirIterator files(root, {"*.json"}, QDir::Files, QDirIterator::Subdirectories); files.hasNext();) {
      QFile info(files.next());
      QVERIFY(info.open(QIODevice::ReadWrite));
      QJsonObject text = QJsonDocument::fromJson(info.readAll()).object();
      if (!text.contains("stamp")) continue;
      text.remove("stamp");
      QVERIFY(info.resize(0) && info.seek(0) && info.write(QJsonDocument(text).toJson()) > 0);
      ++changed;
    }
    QCOMPARE(changed, 1);
    WindowDriver driver;
    recoverIn(driver);
    driver.choose("saveFile");
    QVERIFY(driver.settle());
    QVERIFY2(driver.text("messageText").contains("another program"), qPrintable(driver.text("messageText")));
    QVERIFY(openEdges(readStl(path)) > 0);
    driver.click("messageOther");  // replace
    QVERIFY(driver.settle());
    QCOMPARE(openEdges(readStl(path)), 0);
    QVERIFY(!driver.window().isWindowModified());
  }

  // The readable rest of a damaged file stays in it: "Save" asks for another name, as it did before the crash.
  void aDamagedFileIsNotOverwritten() {
    QTemporaryDir folder;
    const QString path = folder.filePath("damaged.stl");
    writeStl(path, quadTorus(48, 24, {}));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadWrite) && file.resize(84 + 50 * 2302 + 7));  // one cell is missing
    file.close();
    openFillAndCrash(path);
    WindowDriver driver;
    recoverIn(driver);
    QVERIFY2(driver.text("messageText").contains("damaged.stl"), qPrintable(driver.text("messageText")));
    QVERIFY2(driver.text("messageText").contains("contents that were damaged"), qPrintable(driver.text("messageText")));
    driver.choose("saveFile");
    QTRY_VERIFY(driver.window().findChild<QFileDialog*>("saveDialog"));
    QVERIFY(driver.enterFileName("saveDialog", folder.filePath("rest.stl")));
    QVERIFY(driver.settle());
    QVERIFY(!driver.window().isWindowModified());
    QCOMPARE(QFileInfo(path).size(), 84 + 50 * 2302 + 7);
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
