// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "machining/program/ProgramErrors.h"
#include "machining/program/ProgramInterpreter.h"
#include "machining/program/ProgramSimulation.h"

#include <QDirIterator>
#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

// A bar that the programs of the shop fit on, and a machine around it.
constexpr StockCylinder kShopBar{76.2, 150.0, 0.0};

struct ProgramFile {
  QString name;
  ProgramDialect dialect = ProgramDialect::LinuxCnc;
  QByteArray text;
};

std::vector<ProgramFile> programFiles() {
  std::vector<ProgramFile> files;
  const QString folder = qEnvironmentVariable("HANDWHEEL_DATA") + "/lathe";
  QDirIterator each(folder, {"*.nc", "*.ngc", "*.gcode"}, QDir::Files, QDirIterator::Subdirectories);
  while (each.hasNext()) {
    QFile file(each.next());
    if (!file.open(QIODevice::ReadOnly)) continue;
    const QString name = QDir(folder).relativeFilePath(file.fileName());
    const bool isFanuc = name.startsWith("fanuc");
    files.push_back({name, isFanuc ? ProgramDialect::Fanuc : ProgramDialect::LinuxCnc, file.readAll()});
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return files;
}

}  // namespace

// Every program among the test data is run and simulated, or refused with its line and the reason. Prints the table.
class ProgramFilesTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    if (qEnvironmentVariable("HANDWHEEL_DATA").isEmpty()) QSKIP("HANDWHEEL_DATA is not set");
  }

  void everyFileIsRunOrRefused() {
    const std::vector<ProgramFile> files = programFiles();
    QVERIFY(!files.empty());
    int lathe = 0;
    for (const ProgramFile& file : files) {
      ProgramSetup setup;
      setup.dialect = file.dialect;
      setup.standard = {0.4, outsideOrientation(file.dialect), {0, 0}};
      setup.reference = {0.5 * kShopBar.diameter + 100.0, 100.0};
      const Result<ToolPath> path = runProgram(std::string_view(file.text.data(), file.text.size()), setup);
      const bool isMill = file.name.startsWith("camotics");
      if (!path) {
        QVERIFY2(file.dialect != ProgramDialect::Fanuc, "a program of the shop is refused");
        const Error& error = path.error();
        qInfo("%-62s refused, line %llu: %s: %s", qPrintable(file.name),
              static_cast<unsigned long long>(error.position.value), error.arguments.at(1).c_str(),
              error.arguments.at(2).c_str());
        QVERIFY(error.code == ProgramError::Refused);
        QVERIFY(error.position.value > 0 && error.arguments.at(2).size() > 5 && error.arguments.at(3).ends_with('.'));
        continue;
      }
      QVERIFY2(!isMill, "a program for milling runs on the lathe");
      ProgramSimulation simulation(TurnedProfile(kShopBar, 0.05), *path, setup);
      QVERIFY(simulation.run({}));
      const double removed = kShopBar.volume() - simulation.part().volume();
      qInfo("%-62s %zu moves, %.0f s, %.0f mm³, %zu collisions, %zu notes", qPrintable(file.name), path->moves.size(),
            path->time, removed, simulation.collisionCount(), path->notes.size());
      QVERIFY(std::isfinite(path->time) && path->time >= 0.0 && removed > -1e-6);
      ++lathe;
    }
    qInfo("%d of %zu programs are run", lathe, files.size());
  }
};

HANDWHEEL_TEST(ProgramFilesTest)
#include "ProgramFilesTest.moc"
