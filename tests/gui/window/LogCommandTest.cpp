// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "MeshShapes.h"
#include "QuickWindow.h"
#include "StlFiles.h"
#include "WindowTestMain.h"

#include <QComboBox>
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
  ClassWindow m_window;

  static QString lastCommand(WindowDriver& driver) {
    const QAbstractItemModel* log = driver.find<QTreeView>("logView")->model();
    QString command;
    for (int row = 0; row < log->rowCount(); ++row) {
      const QString each = log->index(row, 2).data().toString();
      if (!each.isEmpty()) command = each;
    }
    return command;
  }
  // Runs the command in a shell, in another folder; returns its exit code.
  static int paste(const QString& command) {
    QProcess process;
    process.setWorkingDirectory(QDir::rootPath());
    const QString program = QFileInfo(test::programPath()).path();
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", program + ':' + environment.value("PATH"));
    process.setProcessEnvironment(environment);
    process.start("/bin/sh", {"-c", command});
    return process.waitForFinished(120000) ? process.exitCode() : -1;
  }
  // By the button of the tool for placing, as one step.
  static bool place(WindowDriver& driver, const QByteArray& where) {
    const auto before = driver.find<QTreeView>("logView")->model()->rowCount();
    driver.find<QAbstractButton>("toolAction/" + where)->click();
    return QTest::qWaitFor([&] { return driver.find<QTreeView>("logView")->model()->rowCount() > before; },
                           kPatienceMs) &&
           driver.settle();
  }
  bool saveAs(WindowDriver& driver, const QString& path) {
    driver.choose("saveFileAs");
    return driver.enterFileName("saveDialog", path) && driver.settle();
  }

 private slots:
  void initTestCase() {
    if (!QFileInfo::exists(test::programPath())) QSKIP("the program is not built");
  }

  void aRepair() {
    const QString path = m_folder.filePath("it's a scan.stl");
    writeStl(path, quadTorus(48, 24, {{3, 5}, {20, 11}}));
    QuickWindow& driver = m_window.cleared();
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

  // Any manual work, done and undone, leads to the same bytes again.
  void handWork() {
    const QString path = m_folder.filePath("by hand.stl"), saved = m_folder.filePath("made.ply");
    writeStl(path, quadTorus(48, 24, {{3, 5}, {20, 11}, {33, 2}}));
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(path));
    driver.clickDefect(DefectKind::Hole, 1);
    QVERIFY(driver.settle());
    driver.find<QAction>("fillHole")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 2, kPatienceMs);
    QVERIFY(driver.settle());
    const QString fill = lastCommand(driver);
    QVERIFY2(fill.contains("edit") && fill.contains("'fill v"), qPrintable(fill));
    driver.clickDefect(DefectKind::Hole, 0);
    QVERIFY(driver.settle());
    driver.find<QAction>("keepOpen")->trigger();
    QVERIFY2(lastCommand(driver).startsWith("… 'keep-open v"), qPrintable(lastCommand(driver)));
    driver.find<QAction>("transformTool")->trigger();
    QVERIFY(driver.settle());
    QVERIFY(place(driver, "corner") && place(driver, "axes"));
    driver.find<QAction>("undo")->trigger();
    QVERIFY(driver.settle());
    QVERIFY(saveAs(driver, saved));
    const QString command = lastCommand(driver);
    QVERIFY2(command.contains(" corner -o ") && !command.contains("axes"), qPrintable(command));
    const QByteArray made = content(saved);
    QVERIFY(QFile::remove(saved) && !made.isEmpty());
    QCOMPARE(paste(command), 0);
    QVERIFY(content(saved) == made);
  }

  // From a container on, what it holds is where the steps begin, and the very same file comes out.
  void onFromAContainer() {
    const QString path = m_folder.filePath("scan 2.stl"), first = m_folder.filePath("first.handwheel"),
                  second = m_folder.filePath("second.handwheel");
    writeStl(path, quadTorus(48, 24, {{3, 5}, {20, 11}, {33, 2}}));
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(path));
    driver.clickDefect(DefectKind::Hole, 0);
    QVERIFY(driver.settle());
    driver.find<QAction>("fillHole")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 2, kPatienceMs);
    QVERIFY(driver.settle() && saveAs(driver, first));
    driver.click("repairAllButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 0, kPatienceMs);
    QVERIFY(driver.settle() && saveAs(driver, second));
    const QString command = lastCommand(driver);
    QVERIFY2(command.contains("first.handwheel") && command.count("fill v") == 0, qPrintable(command));
    const QByteArray made = content(second);
    QVERIFY(QFile::remove(second) && !made.isEmpty());
    QCOMPARE(paste(command), 0);
    QVERIFY(content(second) == made);
    // The steps as a file.
    const QString steps = m_folder.filePath("second.steps");
    driver.find<QAction>("undo")->trigger();
    QVERIFY(driver.settle());
    driver.choose("saveSteps");
    QVERIFY(driver.enterFileName("saveStepsDialog", steps) && driver.settle());
    QVERIFY(content(steps).startsWith("# handwheel edit "));
  }

  // Nobody reads a line of a thousand numbers, and a list that lays one out stands still: it names the file of steps.
  void aLongStep() {
    const QString path = m_folder.filePath("two balls.stl");
    const TriangleSoup ball = icosphere(3);
    std::vector<Corners> mesh;
    for (const Triangle& t : ball.triangles) {
      for (const float size : {10.0f, 5.0f}) {
        Corners& corners = mesh.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
          for (std::size_t i = 0; i < 3; ++i)
            corners[k][i] = size * static_cast<float>(ball.points[t[k]][static_cast<int>(i)]);
      }
    }
    writeStl(path, mesh);
    WindowDriver driver;
    QVERIFY(driver.open(path));
    driver.find<QAction>("selectTool")->trigger();
    QVERIFY(driver.settle());
    auto* by = driver.find<QWidget>("property/mode")->findChild<QComboBox*>();
    by->setCurrentIndex(3);  // connected faces
    emit by->activated(3);
    auto* view = driver.find<Viewport>("viewport");
    QTRY_VERIFY_WITH_TIMEOUT(view->isPickingReady(), kPatienceMs);
    QTest::mouseClick(view, Qt::LeftButton, {}, view->rect().center());
    QVERIFY(driver.settle());
    QTRY_VERIFY_WITH_TIMEOUT(driver.find<QAbstractButton>("toolAction/delete")->isEnabled(), kPatienceMs);
    const auto before = driver.find<QTreeView>("logView")->model()->rowCount();
    driver.find<QAbstractButton>("toolAction/delete")->click();
    QTRY_VERIFY_WITH_TIMEOUT(driver.find<QTreeView>("logView")->model()->rowCount() > before, kPatienceMs);
    QVERIFY2(lastCommand(driver).contains("--steps") && lastCommand(driver).contains("two balls.steps"),
             qPrintable(lastCommand(driver).left(200)));
    QVERIFY(driver.settle());
    driver.choose("saveSteps");
    QVERIFY(driver.enterFileName("saveStepsDialog", m_folder.filePath("two balls.steps")) && driver.settle());
    const QString command = lastCommand(driver);
    QVERIFY(saveAs(driver, m_folder.filePath("two balls-edited.ply")));
    QCOMPARE(paste(command), 0);
    QCOMPARE(readStl(m_folder.filePath("two balls-edited.stl")).size(), ball.triangles.size());
  }

  // The values are those of the moment, not those of whoever pastes the command.
  void aRepairWithOtherValuesThanTheDefaults() {
    const QString path = m_folder.filePath("torn.stl");
    std::vector<Corners> mesh =
        quadTorus(48, 24, {{3, 5}, {3, 6}, {3, 7}, {4, 5}, {4, 6}, {4, 7}, {5, 5}, {5, 6}, {5, 7}});
    for (Corner& corner : mesh.back()) corner[2] += 0.02f;  // 2e-4 of the diagonal
    writeStl(path, mesh);
    std::vector<std::vector<Corners>> results;
    const std::pair<const char*, const char*> choices[] = {
        {"", nullptr},
        {"mesh.near_weld=1e-3,mesh.patch_density=0.5,mesh.fill_method=refined",
         " --fill refined --density 0.5 --near-weld 0.001"},
        {"mesh.fill_continuity=position", " --continuity position"},
        {"draft", " --density 0.54"}};
    for (const auto& [chosen, written] : choices) {
      QSettings().setValue("fidelity", chosen);
      QuickWindow driver;
      QVERIFY(driver.open(path));
      driver.click("repairAllButton");
      QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 0, kPatienceMs);
      QVERIFY(driver.settle());
      const QString repaired = lastCommand(driver);
      if (written) QVERIFY2(repaired.contains(written), qPrintable(repaired));
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
    QuickWindow driver;
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
    QuickWindow driver;
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
    QuickWindow driver;
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
  // Opens the file in another window.
  QString sizeOf(const QString& path) {
    QuickWindow& other = m_window.cleared();
    return other.open(path) ? other.text("figures") : QString();
  }
};

HANDWHEEL_WINDOW_TEST(LogCommandTest)
#include "LogCommandTest.moc"
