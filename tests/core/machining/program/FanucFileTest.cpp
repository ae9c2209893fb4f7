// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "machining/program/ProgramInterpreter.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

Result<ToolPath> runFanuc(const std::string& text, const char* tools = "") {
  ProgramSetup setup;
  setup.dialect = ProgramDialect::Fanuc;
  setup.tools = readToolTable(tools).value();
  return runProgram(text, setup);
}

// Returns the end of the tip's path, (r, z).
ProfilePoint fanucEnd(const std::string& text, const char* tools = "") {
  const Result<ToolPath> path = runFanuc(text, tools);
  if (!path) qWarning("line %d: %s", int(path.error().position.value), path.error().arguments.at(2).c_str());
  return path && !path->moves.empty() ? path->moves.back().to : ProfilePoint(std::nan(""), std::nan(""));
}

bool isTipAtPoint(const ProfilePoint& p, double r, double z) {
  return (p - ProfilePoint(r, z)).norm() < 1e-9;
}

// The line of a refusal; 0: it runs.
int refusedLine(const std::string& text) {
  const Result<ToolPath> path = runFanuc(text);
  return path ? 0 : static_cast<int>(path.error().position.value);
}

}  // namespace

// Files of Fanuc with several programs, Macro B, tapes, and tools with offsets.
class FanucFileTest : public QObject {
  Q_OBJECT

 private slots:
  // N10 of the program that jumps, not of the next in the file.
  void jumpsStayInTheirProgram() {
    QVERIFY(
        isTipAtPoint(fanucEnd("O1\n#1=0\nN10 #1=#1+1\nG0 Z#1\nIF[#1 LT 5]GOTO10\nM30\nO2\nN10 G0 Z99.\nM99\n"), 0, 5));
    QVERIFY(isTipAtPoint(fanucEnd("O1\nGOTO20\nG0 Z7.\nN20 G0 X6.\nM30\nO2\nN20 G0 Z99.\nM99\n"), 3, 0));
    QCOMPARE(refusedLine("O1\nGOTO20\nM30\nO2\nN20 G0 Z99.\nM99\n"), 2);
    // M99 P goes back into the caller.
    QVERIFY(isTipAtPoint(fanucEnd("O1\nM98 P2\nG0 Z9.\nN30 G0 X8.\nM30\nO2\nN30 G0 Z1.\nM99 P30\n"), 4, 1));
  }

  // The contour is behind the cycle in one file, before it in the other; a subprogram has lines of these numbers, too.
  void contoursAreOfTheirProgram() {
    const std::string begin = "O1\nG21 G99 G97 S500 M3\nG0 X40. Z2.\n",
                      contour = "N10 G0 X20.\nG1 Z-10. F0.1\nN20 X44.\n";
    const std::string other = "O2\nN10 G0 X2.\nG1 Z-99. F0.1\nN20 X4.\nM99\n";
    const auto reach = [](const Result<ToolPath>& path) {
      double lowest = 0.0;
      if (path)
        for (const ToolMove& m : path->moves) lowest = std::min(lowest, m.to.y());
      return path ? lowest : std::nan("");
    };
    QCOMPARE(reach(runFanuc(begin + "G70 P10 Q20\nM30\n" + contour + other)), -10.0);
    QCOMPARE(reach(runFanuc(begin + "GOTO30\n" + contour + "N30 G70 P10 Q20\nM30\n" + other)), -10.0);
    QCOMPARE(reach(runFanuc(begin + contour + "G70 P10 Q20\n" + other)), -10.0);
  }

  void nothingBehindAProgramNumber() {
    QCOMPARE(refusedLine("O0001 (TITLE)\nG0 Z1.\nM30\n"), 0);
    QCOMPARE(refusedLine("(A)\nO0001 G28 U0 W0\nM30\n"), 2);
  }

  void aSubprogramEndsWithM99() {
    QCOMPARE(refusedLine("O1\nM98 P2\nG0 X9.\nM30\nO2\nG0 Z1.\nO3\nM99\n"), 7);
    QVERIFY(refusedLine("O1\nM98 P2\nM30\nO2\nG0 Z1.\n") > 0);
    QVERIFY(isTipAtPoint(fanucEnd("O1\nM98 P2\nG0 X9.\nM30\nO2\nG0 Z1.\nM99\nO3\nM99\n"), 4.5, 1));
  }

  void tapes() {
    QVERIFY(isTipAtPoint(fanucEnd("(title)\n\n%\nO1\nG0 Z3.\nM30\n%\nG0 Z9.\n"), 0, 3));
    QVERIFY(isTipAtPoint(fanucEnd("%\nO1\nG0 Z3.\n%\nG0 Z9.\n"), 0, 3));
    QVERIFY(isTipAtPoint(fanucEnd("O1\nG0 Z3.\n%\nG0 Z9.\n"), 0, 3));
    QCOMPARE(refusedLine("G0 Z1.\n%\nO1\nG0 Z3.\nM30\n%\n"), 2);
  }

  // Bits, as strong as products and sums; MOD has the sign of its left side.
  void macroOperators_data() {
    QTest::addColumn<QString>("expression");
    QTest::addColumn<double>("value");
    QTest::newRow("and") << "12 AND 10" << 8.0;
    QTest::newRow("or") << "12 OR 10" << 14.0;
    QTest::newRow("xor") << "12 XOR 10" << 6.0;
    QTest::newRow("and before or") << "1 OR 4 AND 6" << 5.0;
    QTest::newRow("and before plus") << "1 + 6 AND 3" << 3.0;
    QTest::newRow("or with plus") << "1 + 1 OR 4" << 6.0;
    QTest::newRow("or before equal") << "1 OR 2 EQ 3" << 1.0;
    QTest::newRow("conditions") << "[1 LT 2] AND [3 GT 2]" << 1.0;
    QTest::newRow("modulo") << "-7 MOD 3" << -1.0;
  }
  void macroOperators() {
    QFETCH(QString, expression);
    QFETCH(double, value);
    QCOMPARE(fanucEnd("G0 Z[100+[" + expression.toStdString() + "]]\n").y(), 100.0 + value);
    QCOMPARE(refusedLine("#1=1E9*9 AND 1\n"), 1);
  }

  void loopsWithComments() {
    const char* const loop = "#1=0\n/WHILE [#1 LT 5] DO1 (up to five)\n#1=#1+1\nN20 END1 (loop)\nG0 Z#1\n";
    QVERIFY(isTipAtPoint(fanucEnd(loop), 0, 5));
    QVERIFY(isTipAtPoint(fanucEnd("#1=0\nN5 WHILE[#1 LT 3]DO2;\n#1=#1+1\nEND2;\nG0 Z#1\n"), 0, 3));
    QVERIFY(isTipAtPoint(fanucEnd("#1=7\nIF[[#1 AND 4]EQ 4]GOTO10\nG0 Z9.\nN10 G0 X8.\n"), 4, 0));
  }

  // The numbers and the offset in effect position the post; the tip is off by the difference of the tools' lengths.
  void aWrongOffsetCutsElsewhere() {
    const char* const tools = "T1 X1 Z10 D0.8 Q3\nT2 X3 Z25 D1.6 Q3\n";
    QVERIFY(isTipAtPoint(fanucEnd("T0101\nG0 X40. Z2.\n", tools), 20, 2));
    QVERIFY(isTipAtPoint(fanucEnd("T0202\nG0 X40. Z2.\n", tools), 20, 2));
    QVERIFY(isTipAtPoint(fanucEnd("T0102\nG0 X40. Z2.\n", tools), 20 + 3 - 1, 2 + 25 - 10));
    QVERIFY(isTipAtPoint(fanucEnd("T0100\nG0 X40. Z2.\n", tools), 20 - 1, 2 - 10));
    QVERIFY(isTipAtPoint(fanucEnd("T0101\nG0 X40. Z2.\nT0202\nX40. Z2.\n", tools), 20, 2));
    // Not in the table: as programmed, whatever the offset.
    QVERIFY(isTipAtPoint(fanucEnd("T0502\nG0 X40. Z2.\n", tools), 20, 2));
    QVERIFY(isTipAtPoint(fanucEnd("T0102\nG0 X40. Z2.\n"), 20, 2));
  }

  // Tool 3 with offset 13: the nose that cuts is that of entry 13 where 3 has none, and that of 3 where it has one.
  void aToolWithAnOffsetOfAnotherNumber() {
    const auto shapeOf = [](const char* tools) {
      return int(runFanuc("T0313\nG0 X40. Z2.\n", tools).value().moves.back().shape);
    };
    QCOMPARE(shapeOf("T13 X1 Z1 D0.8 Q3\n"), 13);
    QCOMPARE(shapeOf("T3 X1 Z1 D0.8 Q3\nT13 X1 Z1 D1.6 Q3\n"), 3);
    QCOMPARE(shapeOf(""), 3);
  }

  // LinuxCNC: the tool without G43, with it, and with the offset of another.
  void linuxCncOffsets() {
    ProgramSetup setup;
    setup.tools = readToolTable("T1 X1 Z10 D0.8 Q2\nT2 X3 Z25 D1.6 Q2\n").value();
    const auto end = [&](const char* text) { return runProgram(text, setup).value().moves.back().to; };
    QVERIFY(isTipAtPoint(end("T1 M6 G43\nG0 X20 Z2\n"), 20, 2));
    QVERIFY(isTipAtPoint(end("T1 M6\nG0 X20 Z2\n"), 19, -8));
    QVERIFY(isTipAtPoint(end("T1 M6 G43 H2\nG0 X20 Z2\n"), 22, 17));
    QVERIFY(isTipAtPoint(end("T1 M6 G43\nT2 M6\nG0 X20 Z2\n"), 18, -13));
    // The post goes to machine zero: the tip is shorter of it by the tool.
    QVERIFY(isTipAtPoint(end("T1 M6 G43\nG0 X5 Z5\nG53 G0 X0 Z0\n"), -1, -10));
  }
};

HANDWHEEL_TEST(FanucFileTest)
#include "FanucFileTest.moc"
