// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProgramTrial.h"
#include "TestClass.h"

#include <QtTest>
#include <algorithm>
#include <ctime>

using namespace handwheel;
using test::ProgramTrial;

namespace {

// A lathe whose machine zero is at r 120, z 100, with a tool of nose 0.4 in entry 3 of its memory.
ProgramTrial controlTrial() {
  ProgramTrial lathe(ProgramDialect::Fanuc);
  lathe.setup.reference = {120, 100};
  lathe.setup.tools[3] = {0.4, 3, {7, -2.5}};
  return lathe;
}

}  // namespace

// The variables of the control in Macro B of Fanuc, by the tables of its manual. X is a diameter.
class FanucVariablesTest : public QObject {
  Q_OBJECT

 private slots:
  void values_data() {
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("expression");
    QTest::addColumn<double>("value");
    const auto row = [](const char* before, const char* expression, double value) {
      QTest::addRow("%s %s", qPrintable(QString(before).simplified()), expression)
          << QString(before) << QString(expression) << value;
    };
    row("S500 M3\nG1 X20. Z5. F0.25\n", "#4001", 1);
    row("S500 M3\nG1 X20. Z5. F0.25\n", "#4109", 0.25);
    row("G20 G98\nG1 X2. Z.5 F5.\n", "#4109", 5);
    row("G96 S180\n", "#4002", 96);
    row("G96 S180\n", "#4119", 180);
    row("G97 S1200\n", "#4002", 97);
    row("G98\n", "#4005", 98);
    row("", "#4005", 99);
    row("G20\n", "#4006", 20);
    row("", "#4006", 21);
    row("G42 G0 X20. Z5.\nG40 G0 X30.\n", "#4007", 40);
    row("G42\n", "#4007", 42);
    row("S500 M3\nG0 X0 Z5.\nG81 Z-1. F.1\n", "#4010", 81);
    row("G55\n", "#4014", 55);
    row("G61\n", "#4015", 61);
    row("N40 G0 X20.\n", "#4114", 40);
    row("O1234\n", "#4115", 1234);
    row("M8\nM3\n", "#4113", 3);
    row("T0303\n", "#4120", 303);  // the T code, not the tool alone
    row("T0303\nG0 X20. Z5.\n", "#5001", 20);
    row("T0303\nG0 X20. Z5.\n", "#5042", 5);
    // Machine zero is r 120 and z 100; the offset of the tool is 7 on the radius and -2.5 along z.
    row("T0303\nG0 X20. Z5.\n", "#5021", 2 * (10 + 7 - 120));
    row("T0303\nG0 X20. Z5.\n", "#5022", 5 - 2.5 - 100);
    row("", "#2703", 14);
    row("", "#2803", -2.5);
    row("", "#2903", 0.4);
    row("", "#2303", 3);
    row("", "#2003+#2103+#2203+#2501+#2601", 0);
    row("", "#5221", -240);
    row("", "#5322", -100);
    row("#5241=-200. #5242=-90.\n", "#5242", -90);
    row("#3901=#3901+1\n#3902=5\n", "#3902-#3901", 4);
    row("#3003=1\n#3004=7\n", "#3003*10+#3004", 17);
    // A dwell of 1.5 s and a feed of 10 mm at 600 mm/min, which takes 1 s.
    row("#3001=0\nG4 P1500\n", "#3001", 1500);
    row("G98 F600.\nG0 X20. Z0\n#3001=5\nG1 Z-10.\n", "#3001", 1005);
    row("#3002=1\nG4 X36.\n", "#3002", 1.01);
  }
  void values() {
    QFETCH(QString, before);
    QFETCH(QString, expression);
    QFETCH(double, value);
    const std::string program = before.toStdString() + "#100=" + expression.toStdString() +
                                "\nG40 G80 T0300 G21 G98 G54\n#5221=-240. #5222=-100.\nG0 X0 Z#100\n";
    const std::vector<ToolMove> moves = controlTrial().movesOf(program);
    QVERIFY(!moves.empty());
    // Tool 3 without its offset of -2.5 mm: its tip is as much right of what the program says.
    const double found = moves.back().to.y() - 2.5;
    QVERIFY2(std::abs(found - value) < 1e-9, qPrintable(QString::number(found, 'g', 12)));
  }

  // Within a macro #4115 is its number, and behind it again that of the program.
  void numberOfTheProgram() {
    QVERIFY(controlTrial().endsAt("O7\nG65 P9\nG0 X[2*#100] Z#4115\nM30\nO9\n#100=#4115\nM99\n", 9, 7));
  }

  // A loop that waits for the clock ends.
  void waitsForTheClock() {
    QVERIFY(controlTrial().endsAt("#3001=0\nWHILE[#3001 LT 500]DO1\nEND1\nG0 X#3001 Z0\n", 250, 0));
  }

  void calendar() {
    ProgramTrial lathe = controlTrial();
    std::tm noon{};
    noon.tm_year = 126, noon.tm_mon = 10, noon.tm_mday = 30, noon.tm_hour = 12, noon.tm_min = 34, noon.tm_sec = 50;
    lathe.setup.begin = std::mktime(&noon);
    QVERIFY(lathe.endsAt("G4 X9.\nG0 X[2*[#3011-20260000]] Z[#3012-123000]\n", 1130, 459));
  }

  // The lines of a contour change variables once in each cycle, and the position within them is that of the contour: r
  // 10, z -5, then r 12, z -8. G71 reads the contour from z 0, G70 from there again.
  void contoursCountOnce() {
    const std::string cycle =
        "G21 G99 G97 S500 M3\n#1=0\nG0 X40. Z0\nG71 U20. R1.\nG71 P10 Q20 F.2\nN10 G0 X20. W0\n#1=#1-5.\nG1 "
        "Z#1\n#3006=1 "
        "(ONCE)\nN20 X[#5041+4.] Z[#5042-3.]\n";
    const Result<ToolPath> rough = runProgram(cycle, controlTrial().setup);
    const Result<ToolPath> finish = runProgram(cycle + "#1=0\nG70 P10 Q20\n", controlTrial().setup);
    QVERIFY(rough && finish && rough->notes.size() == 1 && finish->notes.size() == 2);
    const std::vector<ToolMove>& moves = finish->moves;
    const std::size_t last = moves.size() - 1;
    QVERIFY((moves[last - 1].to - ProfilePoint(12, -8)).norm() < 1e-9);
    QVERIFY((moves[last - 2].to - ProfilePoint(10, -5)).norm() < 1e-9);
    const auto reaches = [&](double r, double z) {
      return std::any_of(rough->moves.begin(), rough->moves.end(),
                         [&](const ToolMove& m) { return (m.to - ProfilePoint(r, z)).norm() < 1e-9; });
    };
    QVERIFY(reaches(10, -5) && reaches(12, -8));
  }

  // Zero points that a program sets have effect at once.
  void setsZeroPoints() {
    QVERIFY(controlTrial().endsAt("G55\n#5241=-200. #5242=-90.\nG0 X20. Z5.\n", 30, 15));
    QVERIFY(controlTrial().endsAt("#5241=-200.\nG0 X20. Z5.\n", 10, 5));
  }

  // A word whose variable was never set is ignored; one that was computed is not.
  void vacantWords() {
    QVERIFY(controlTrial().endsAt("G0 X20. Z5.\nG0 X#1 Z1.\n", 10, 1));
    QVERIFY(controlTrial().endsAt("G0 X20. Z5.\nG0 X[#1+0] Z-#2\n", 0, 5));
    QVERIFY(controlTrial().endsAt("G0 X20. Z5.\n#2=#1\nIF[#2 EQ #0] THEN #3=4.\nG0 X#2 Z#3\n", 10, 4));
  }

  void alarmsStopTheProgram_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("number");
    QTest::addColumn<QString>("message");
    QTest::newRow("in a line") << "#3000=1 (TOO BIG)"
                               << "3001"
                               << "TOO BIG";
    QTest::newRow("without blanks") << "#3000=123(tool, broken)"
                                    << "3123"
                                    << "tool, broken";
    QTest::newRow("without a message") << "#3000=7"
                                       << "3007"
                                       << "";
    QTest::newRow("on a condition") << "IF[#1 GT 3.] THEN #3000=1 (TOO BIG)"
                                    << "3001"
                                    << "TOO BIG";
    QTest::newRow("computed") << "N30 #3000=[#1+5] (A) (B)"
                              << "3010"
                              << "A";
  }
  void alarmsStopTheProgram() {
    QFETCH(QString, line);
    QFETCH(QString, number);
    QFETCH(QString, message);
    const Result<ToolPath> path =
        runProgram("#1=5.\nG0 X36. Z2.\n" + line.toStdString() + "\nG1 Z-10. F0.2\nM30\n", controlTrial().setup);
    QVERIFY(!path && path.error().code == ErrorCode(ProgramError::Alarm));
    QCOMPARE(path.error().position.value, std::uint64_t{3});
    QCOMPARE(QString::fromStdString(path.error().arguments[0]), number);
    QCOMPARE(QString::fromStdString(path.error().arguments[1]), message);
  }

  // A condition that is false, and a message without an alarm.
  void goesOnWithoutAnAlarm() {
    const Result<ToolPath> path = runProgram(
        "#1=2.\nIF[#1 GT 3.] THEN #3000=1 (TOO BIG)\n#3006=1 (TURN THE PART)\nG0 X36. Z2.\n", controlTrial().setup);
    QVERIFY(path && path->moves.size() == 1 && path->notes.size() == 1);
    QCOMPARE(path->notes[0].line, std::uint32_t{3});
    QCOMPARE(path->notes[0].text, std::string("The machine stops here: TURN THE PART."));
  }

  void refuses_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("refusal");
    const auto row = [](const char* program, const char* refusal) {
      QTest::addRow("%s", qPrintable(QString(program).simplified())) << QString(program) << QString(refusal);
    };
    row("G0 X#5023\n", "1: #5023: this lathe has no such axis, only X (1) and Z (2). Use the variable of X or Z.");
    row("#1=#5061\n",
        "1: #5061: there is no position of a skip (G31). Write the value itself, or one of the variables that "
        "docs/programs.md lists.");
    row("IF[#1005 EQ 1] GOTO 9\nN9\n",
        "1: #1005: a signal of the machine is not simulated. Write the value that the signal has.");
    row("#1104=1\n", "1: #1104: a signal of the machine is not simulated. Write the value that the signal has.");
    row("#40=1\n", "1: #40: there is no variable of this number. Use #1 to #33, #100 to #199 or #500 to #999.");
    row("G0 X#300\n", "1: #300: there is no variable of this number. Use #1 to #33, #100 to #199 or #500 to #999.");
    row("#1=#4001\n",
        "1: #4001: this mode of the control is not known here. Write the value itself, or one of the variables that "
        "docs/programs.md lists.");
    row("#5001=3\n", "1: #5001: this variable belongs to the machine and can only be read. Use another number.");
    row("#2003=0.1\n", "1: #2003: this variable belongs to the machine and can only be read. Use another number.");
    row("#4109=3\n", "1: #4109: this variable belongs to the machine and can only be read. Use another number.");
    row("#3000=500 (X)\n", "1: #3000: the number of an alarm is from 0 to 200. Correct it.");
    row("G65 P2\nM30\nO2\nG0 X#6400\nM99\n",
        "4: #6400: this variable of the control is not known here. Write the value itself, or one of the variables "
        "that docs/programs.md lists.");
  }
  void refuses() {
    QFETCH(QString, program);
    QFETCH(QString, refusal);
    QCOMPARE(QString::fromStdString(controlTrial().refusalOf(program.toStdString())), refusal);
  }
};

HANDWHEEL_TEST(FanucVariablesTest)
#include "FanucVariablesTest.moc"
