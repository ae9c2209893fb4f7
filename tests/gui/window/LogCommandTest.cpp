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
    QCOMPARE(lastCommand(driver), repaired);  // saving a mesh that was changed has no command of its own
    QVERIFY(saveAs(driver, m_folder.filePath("copy.stl")));
    const auto copy = readStl(m_folder.filePath("copy.stl"));
    QVERIFY(!copy.empty() && QFile::remove(m_folder.filePath("copy.stl")));
    QCOMPARE(paste(lastCommand(driver)), 0);
    QVERIFY(readStl(m_folder.filePath("copy.stl")) == copy);
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
