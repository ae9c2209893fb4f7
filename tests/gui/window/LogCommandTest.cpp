// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"

#include <QProcess>

using namespace handwheel;
using namespace handwheel::test;

namespace {

QByteArray content(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

// The command lines in the Log do in any folder what the window did.
class LogCommandTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  static QString lastCommand(WindowDriver& driver) {
    const QAbstractItemModel* log = driver.find<QTreeView>("logView")->model();
    QString command;
    for (int row = 0; row < log->rowCount(); ++row) {
      const QString each = log->index(row, 2).data().toString();
      if (!each.isEmpty()) command = each;
    }
    return command;
  }
  // As a shell would run it, in another folder; its exit code.
  static int paste(const QString& command) {
    QProcess process;
    process.setWorkingDirectory(QDir::rootPath());
    const QString program = QFileInfo(QStringLiteral(HANDWHEEL_PROGRAM)).path();
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", program + ':' + environment.value("PATH"));
    process.setProcessEnvironment(environment);
    process.start("/bin/sh", {"-c", command});
    return process.waitForFinished(120000) ? process.exitCode() : -1;
  }
  bool saveAs(WindowDriver& driver, const QString& path) {
    driver.choose("saveFileAs");
    return driver.enterFileName("saveDialog", path) && driver.settle();
  }

 private slots:
  void initTestCase() {
    if (!QFileInfo::exists(QStringLiteral(HANDWHEEL_PROGRAM))) QSKIP("the program is not built");
  }

  void aRepair() {
    const QString path = m_folder.filePath("it's a scan.stl");
    writeStl(path, torus(48, 24, {{3, 5}, {20, 11}}));
    WindowDriver driver;
    QVERIFY(driver.open(path));
    QCOMPARE(paste(lastCommand(driver)), 0);
    driver.click("repairAllButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 0, kPatienceMs);
    const QString repaired = lastCommand(driver);
    const QString byWindow = m_folder.filePath("window.stl");
    QVERIFY(saveAs(driver, byWindow));
    QCOMPARE(paste(repaired), 0);
    QCOMPARE(readStl(m_folder.filePath("it's a scan-repaired.stl")), readStl(byWindow));
    const auto saved = content(byWindow);
    QVERIFY(!saved.isEmpty() && QFile::remove(byWindow));
    QCOMPARE(paste(lastCommand(driver)), 0);  // the steps that lead from the scan to what was saved
    QVERIFY(content(byWindow) == saved);
    QVERIFY(saveAs(driver, m_folder.filePath("copy.stl")));
    const auto copy = readStl(m_folder.filePath("copy.stl"));
    QVERIFY(!copy.empty() && QFile::remove(m_folder.filePath("copy.stl")));
    QCOMPARE(paste(lastCommand(driver)), 0);
    QVERIFY(readStl(m_folder.filePath("copy.stl")) == copy);
  }

  // The values are those of the moment, not those of whoever pastes the command.
  void aRepairWithOtherValuesThanTheDefaults() {
    const QString path = m_folder.filePath("torn.stl");
    std::vector<Corners> mesh = torus(48, 24, {{3, 5}, {3, 6}, {3, 7}, {4, 5}, {4, 6}, {4, 7}, {5, 5}, {5, 6}, {5, 7}});
    for (Corner& corner : mesh.back()) corner[2] += 0.02f;  // 2e-4 of the diagonal
    writeStl(path, mesh);
    std::vector<std::vector<Corners>> results;
    for (const char* chosen : {"", "mesh.near_weld=1e-3,mesh.patch_density=0.5,mesh.fill_method=refined",
                               "mesh.fill_continuity=position", "draft"}) {
      QSettings().setValue("fidelity", chosen);
      WindowDriver driver;
      QVERIFY(driver.open(path));
      driver.click("repairAllButton");
      QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 0, kPatienceMs);
      QVERIFY(driver.settle());
      const QString repaired = lastCommand(driver);
      QCOMPARE(repaired.contains("--fidelity"), *chosen != 0);
      const QString byWindow = m_folder.filePath("torn-window.stl");
      QVERIFY(saveAs(driver, byWindow));
      QSettings().remove("fidelity");
      QVERIFY(QList<int>({0, 2}).contains(paste(repaired)));  // 2: the torn triangle is left
      results.push_back(readStl(byWindow));
      QVERIFY(!results.back().empty() && readStl(m_folder.filePath("torn-repaired.stl")) == results.back());
      QVERIFY(QFile::remove(byWindow) && QFile::remove(m_folder.filePath("torn-repaired.stl")));
    }
    for (std::size_t i = 0; i < results.size(); ++i)
      QCOMPARE(std::count(results.begin(), results.end(), results[i]), 1);
  }

  void aNewWorkpieceWithTheChosenChord() {
    QSettings().setValue("fidelity", "nurbs.chord_mm=0.25");
    WindowDriver driver;
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    const QString path = m_folder.filePath("coarse.stl"), fine = m_folder.filePath("fine.stl");
    QVERIFY(saveAs(driver, path));
    const auto coarse = readStl(path);
    QVERIFY(QFile::remove(path));
    QCOMPARE(paste(lastCommand(driver)), 0);
    QVERIFY(!coarse.empty() && readStl(path) == coarse);
    driver.edit("chord", "0.01");  // the document's own value
    QVERIFY(saveAs(driver, fine));
    QVERIFY(readStl(fine).size() > coarse.size());
    QSettings().remove("fidelity");
  }

  void aNewWorkpieceAndItsChanges() {
    WindowDriver driver;
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    driver.edit("diameter", "1.1in");
    driver.edit("material", "C45, normalised");
    const QString path = m_folder.filePath("bar.handwheel");
    QVERIFY(saveAs(driver, path));
    QVERIFY(!driver.window().isWindowModified());
    QVERIFY(QFile::remove(path));
    QCOMPARE(paste(lastCommand(driver)), 0);
    QCOMPARE(sizeOf(path), driver.text("figures"));

    driver.edit("length", "33");
    const QString longer = m_folder.filePath("longer.handwheel");
    QVERIFY(saveAs(driver, longer));
    QVERIFY(QFile::remove(longer));
    QCOMPARE(paste(lastCommand(driver)), 0);
    QCOMPARE(sizeOf(longer), driver.text("figures"));
  }

  // An export is no save: the document would be lost with it.
  void anExportLeavesTheDocumentUnsaved() {
    WindowDriver driver;
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    driver.edit("diameter", "40");
    const QString step = m_folder.filePath("bar.step");
    QVERIFY(saveAs(driver, step));
    QVERIFY(content(step).startsWith("ISO-10303-21"));
    QVERIFY(driver.window().isWindowModified());
    QVERIFY(driver.window().windowTitle().startsWith("Untitled"));
    QVERIFY(driver.find<QWidget>("messageBar")->isVisible());
    QVERIFY(QFile::remove(step));
    QCOMPARE(paste(lastCommand(driver)), 0);
    QVERIFY(content(step).startsWith("ISO-10303-21"));
  }

 private:
  static QString sizeOf(const QString& path) {
    WindowDriver other;
    return other.open(path) ? other.text("figures") : QString();
  }
};

HANDWHEEL_WINDOW_TEST(LogCommandTest)
#include "LogCommandTest.moc"
