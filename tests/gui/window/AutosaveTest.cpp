// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "KeptAutosaves.h"
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
#include <QElapsedTimer>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPushButton>
#include <QScopeGuard>
#include <algorithm>
#include <optional>

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

  // Leaves a workpiece that was not saved.
  void leaveWorkpiece() {
    if (m_workpiece.isTaken()) return m_workpiece.putBack();
    {
      WindowDriver driver;
      driver.choose("newWorkpiece");
      QVERIFY(driver.settle());
      driver.edit("diameter", "33");
      m_figures = driver.text("figures");
      QVERIFY(QTest::qWaitFor(isStored, 30000));
    }  // the window goes without asking, as in a crash
    m_workpiece.take();
  }
  // Leaves "part.stl", of which a hole was filled and not saved; the file is as it was when it was opened.
  void leavePart() {
    const std::filesystem::path part = partPath().toStdString(), copy = m_folder.filePath("copy.stl").toStdString();
    if (m_part.isTaken()) {
      m_part.putBack();
      std::filesystem::copy_file(copy, part, std::filesystem::copy_options::overwrite_existing);
      return std::filesystem::last_write_time(part, m_partTime);
    }
    writeStl(partPath(), quadTorus(24, 12, {{3, 5}}));
    openFillAndCrash(partPath());
    m_part.take();
    std::filesystem::copy_file(part, copy);
    m_partTime = std::filesystem::last_write_time(part);
  }
  QString partPath() const { return m_folder.filePath("part.stl"); }

  const QTemporaryDir m_folder;
  KeptAutosaves m_workpiece, m_part;
  QString m_figures;  // those of the workpiece
  std::filesystem::file_time_type m_partTime;
  const QTemporaryDir m_blocked;  // no autosaves can be stored in it
  std::optional<WindowDriver> m_failing;
  QElapsedTimer m_sinceFailure;

 private slots:
  void initTestCase() { QSettings().setValue("autosaveSeconds", 5); }

  void init() { QDir(QString::fromStdString(recoveryFolder().string())).removeRecursively(); }

  // The folder of autosaves cannot be made: somebody has to save by hand. laterFailuresAreNotReported() looks at this
  // window again.
  void aFailureIsReported() {
    const auto restored = qScopeGuard([usual = qgetenv("XDG_DATA_HOME")] { qputenv("XDG_DATA_HOME", usual); });
    qputenv("XDG_DATA_HOME", QFile::encodeName(m_blocked.path()));
    const QString folder = QString::fromStdString(recoveryFolder().string());
    QVERIFY(QDir().mkpath(QFileInfo(folder).path()));
    QFile inItsPlace(folder);
    QVERIFY(inItsPlace.open(QIODevice::WriteOnly));
    WindowDriver& driver = m_failing.emplace();
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    driver.edit("diameter", "33");
    QTRY_VERIFY_WITH_TIMEOUT(driver.find<QWidget>("messageBar")->isVisible(), 30000);
    m_sinceFailure.start();
    QVERIFY2(driver.text("messageText").contains("autosaved"), qPrintable(driver.text("messageText")));
    driver.click("messageClose");
    QVERIFY(!driver.find<QWidget>("messageBar")->isVisible());
    driver.window().hide();
  }

  // A program that was just killed has its lock a while longer: its works are offered as soon as it is released.
  void anUnsavedWorkpieceIsOfferedAndRecovered() {
    leaveWorkpiece();
    std::optional<OrphanedAutosaves> held(std::in_place);  // has the locks, as the other program had
    QCOMPARE(held->found().size(), std::size_t{1});
    WindowDriver driver;
    QCOMPARE(driver.tabs(), 0);
    driver.window().offerRecovery();
    QVERIFY(driver.settle());
    QVERIFY(!driver.find<QPushButton>("messageAction")->isVisible());
    held.reset();
    driver.click("messageAction");  // once it is offered
    QVERIFY(QTest::qWaitFor([&] { return driver.tabs() == 1; }, kPatienceMs));
    QVERIFY(driver.settle());
    QCOMPARE(driver.text("figures"), m_figures);
    QVERIFY(driver.window().isWindowModified());
    QVERIFY(driver.text("messageText").contains("as it was last autosaved"));
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

  // However long the interval is that was chosen, what is finished is stored soon; and again with the next edit. The
  // first one is a recording, with which nothing of the model changes.
  void everyEditIsStoredSoon() {
    QSettings().setValue("autosaveSeconds", 600);
    {
      WindowDriver driver;
      driver.choose("newWorkpiece");
      QVERIFY(driver.settle());
      const DocumentTab* tab = driver.find<DocumentTabs>("tabRow")->current();
      QVERIFY(!driver.window().isWindowModified());
      tab->document.commit("recorded",
                           std::make_unique<RecordingsEdit>(std::vector<StoredRecording>{{"0001", "a", "", 0.0, {}}}));
      QVERIFY(driver.window().isWindowModified());
      QVERIFY(QTest::qWaitFor(isStored, 30000));
      driver.edit("diameter", "33");
      QVERIFY(tab->autosaved != tab->document.revision());
      QVERIFY(QTest::qWaitFor([tab] { return tab->autosaved == tab->document.revision(); }, 30000));
      QVERIFY(driver.settle());
    }
    QSettings().setValue("autosaveSeconds", 5);
  }

  // A user who does not want them back is not asked again; nor about those that cannot be read.
  void leftoversCanBeDiscarded() {
    leaveWorkpiece();
    const QString session = QString::fromStdString(recoveryFolder().string()) + "/dead";
    QVERIFY(QDir().mkpath(session));
    for (const char* name : {"damaged.handwheel", "worse.handwheel"}) {
      QFile file(session + "/" + name);
      QVERIFY(file.open(QIODevice::WriteOnly) && file.write("no container") > 0);
    }
    QCOMPARE(stored().size(), 3);
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

  // Its file is as it was when the document was opened; the second time somebody wrote it meanwhile.
  void whatIsRecoveredIsSaved() {
    leavePart();
    {
      WindowDriver driver;
      recoverIn(driver);
      driver.choose("saveFile");
      QVERIFY(driver.settle());
      QVERIFY2(!driver.window().isWindowModified(), qPrintable(driver.text("messageText")));
      QCOMPARE(openEdges(readStl(partPath())), 0);
    }
    leavePart();
    WindowDriver driver;
    writeStl(partPath(), quadTorus(12, 8, {}));
    recoverIn(driver);
    driver.choose("saveFile");
    QVERIFY(driver.settle());
    QVERIFY2(driver.text("messageText").contains("another program"), qPrintable(driver.text("messageText")));
    QCOMPARE(readStl(partPath()).size(), quadTorus(12, 8, {}).size());
  }

  // An autosave that does not say what its file was like. Once somebody has agreed, the document knows.
  void anUnknownFileIsNotOverwritten() {
    leavePart();
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
    QVERIFY(openEdges(readStl(partPath())) > 0);
    driver.click("messageOther");  // replace
    QVERIFY(driver.settle());
    QCOMPARE(openEdges(readStl(partPath())), 0);
    QVERIFY(!driver.window().isWindowModified());
  }

  // The readable rest of a damaged file stays in it: "Save" asks for another name, as it did before the crash.
  void aDamagedFileIsNotOverwritten() {
    const QString damaged = m_folder.filePath("damaged.stl");
    constexpr qint64 kBytes = 84 + 50 * (2 * 24 * 12 - 2) + 7;  // one cell is missing
    writeStl(damaged, quadTorus(24, 12, {}));
    QFile file(damaged);
    QVERIFY(file.open(QIODevice::ReadWrite) && file.resize(kBytes));
    file.close();
    openFillAndCrash(damaged);
    WindowDriver driver;
    recoverIn(driver);
    QVERIFY2(driver.text("messageText").contains("damaged.stl"), qPrintable(driver.text("messageText")));
    QVERIFY2(driver.text("messageText").contains("contents that were damaged"), qPrintable(driver.text("messageText")));
    driver.choose("saveFile");
    QTRY_VERIFY(driver.window().findChild<QFileDialog*>("saveDialog"));
    QVERIFY(driver.enterFileName("saveDialog", m_folder.filePath("rest.stl")));
    QVERIFY(driver.settle());
    QVERIFY(!driver.window().isWindowModified());
    QCOMPARE(QFileInfo(damaged).size(), kBytes);
  }

  // The window whose autosave failed tried it again meanwhile, after 5 s.
  void laterFailuresAreNotReported() {
    if (!m_failing) aFailureIsReported();
    QVERIFY(m_failing.has_value());
    QTest::qWait(std::max(0, 6000 - static_cast<int>(m_sinceFailure.elapsed())));
    QVERIFY(m_failing->find<QWidget>("messageBar")->isHidden());
    m_failing.reset();
  }
};

HANDWHEEL_WINDOW_TEST(AutosaveTest)
#include "AutosaveTest.moc"
