// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/RapidNames.h"

#include "AnyProgram.h"
#include "TestClass.h"
#include "robot/posts/PostText.h"

#include <QTest>
#include <set>

using namespace handwheel;
using namespace handwheel::test;

// Names of paths in RAPID, which a controller must take, and of which several are in one task.
class RapidNamesTest : public QObject {
  Q_OBJECT

  static std::string nameAmong(const std::string& path, std::vector<std::string> others = {}) {
    RobotProgram program;
    program.name = path;
    program.otherPaths = std::move(others);
    return rapidName(program);
  }

 private slots:
  // Words of the language, types, and instructions, functions and data that every controller has, in any case.
  void reserved_data() {
    QTest::addColumn<QByteArray>("path");
    for (const char* const path :
         {"tool0",    "wobj0", "load0",  "TOOL0",   "v100",     "z10",      "fine",      "vmax",
          "MoveAbsJ", "movec", "VelSet", "ConfJ",   "CalcRobT", "Offs",     "robtarget", "num",
          "pose",     "Stop",  "main",   "EndProc", "for",      "WaitTime", "tool7"})
      QTest::newRow(path) << QByteArray(path);
  }
  void reserved() {
    QFETCH(const QByteArray, path);
    QCOMPARE(nameAmong(path.toStdString()), path.toStdString() + "_path");
    RobotProgram program = programOf("irb120");
    program.name = path.toStdString();
    program.motions = {{ProgramMotion::Kind::Joint, ArmValues::Zero(6), 0.5, 0.0, {}}};
    const std::string text = postCalled("rapid")->write(program);
    QVERIFY2(text.find("PROC " + path.toStdString() + "_path()") != text.npos, text.c_str());
  }

  // Names that only resemble these are kept.
  void kept() {
    for (const char* const path : {"tool", "tool0a", "v", "z_10", "finest", "moving", "seam", "pose1", "offset"})
      QCOMPARE(nameAmong(path), std::string(path));
  }

  // Two paths of a cell have different names in any case of letters, and so has what their modules declare.
  void sideBySide() {
    const std::vector<std::vector<std::string>> cells = {{"Process", "process", "PROCESS"},
                                                         {"weld seam", "weld_seam", "Weld-Seam"},
                                                         {"test", "test path", "Test_Path"},
                                                         {"seam", "seam tool", "Seam_module", "seam_FRAME"},
                                                         {"a name that is longer than any takes", "seam"}};
    for (const std::vector<std::string>& paths : cells) {
      std::set<std::string> declared;
      for (const std::string& path : paths) {
        std::vector<std::string> others = paths;
        std::erase(others, path);
        const std::string name = lowerCase(nameAmong(path, others));
        QVERIFY(name.size() + std::string("_module").size() <= kLongestRapidName);
        for (const char* const ending : {"", "_module", "_tool", "_frame"})
          QVERIFY2(declared.insert(name + ending).second, (name + ending).c_str());
      }
    }
    // Other paths do not change a name that collides with none of theirs.
    QCOMPARE(nameAmong("Process", {"seam", "Process 2", "process_1"}), std::string("Process"));
  }
};

HANDWHEEL_TEST(RapidNamesTest)
#include "RapidNamesTest.moc"
