// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramInterpreter.h"

#include "TestClass.h"
#include "machining/program/ProgramErrors.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

Result<ToolPath> run(const std::string& text, ProgramDialect dialect = ProgramDialect::LinuxCnc,
                     ProgramSetup setup = {}) {
  setup.dialect = dialect;
  setup.mostBlocks = 20'000;
  setup.mostMoves = 20'000;
  return runProgram(text, setup);
}

// Returns the end of the tool's path, (r, z), after G0 X... Z... with these values.
ProfilePoint endOf(const std::string& text, ProgramDialect dialect = ProgramDialect::LinuxCnc) {
  const Result<ToolPath> path = run(text, dialect);
  if (path && !path->moves.empty()) return path->moves.back().to;
  return {std::nan(""), std::nan("")};
}

bool endsAt(const ProfilePoint& p, double r, double z) {
  return std::abs(p.x() - r) < 1e-9 && std::abs(p.y() - z) < 1e-9;
}

double valueOf(const std::string& expression, ProgramDialect dialect = ProgramDialect::LinuxCnc) {
  return endOf("G0 Z[" + expression + "]\n", dialect).y();
}

}  // namespace

// Words, expressions and flow of lathe programs. Expectations are from the manuals of LinuxCNC and Fanuc.
class ProgramWordsTest : public QObject {
  Q_OBJECT

 private slots:
  void expressions_data() {
    QTest::addColumn<QString>("expression");
    QTest::addColumn<double>("value");
    QTest::newRow("order") << "1+2*3" << 7.0;
    QTest::newRow("left") << "10-4-3" << 3.0;
    QTest::newRow("power") << "2*3**2" << 18.0;
    QTest::newRow("modulo") << "-7 mod 3" << 2.0;
    QTest::newRow("sine") << "sin[30]" << 0.5;
    QTest::newRow("arc tangent") << "atan[1]/[-1]" << 135.0;
    QTest::newRow("down") << "fix[-2.5]" << -3.0;
    QTest::newRow("up") << "fup[-2.5]" << -2.0;
    QTest::newRow("signs") << "- -2" << 2.0;
    QTest::newRow("compare") << "[1 lt 2] + [2 ge 3] + [1 ne 1.1]" << 2.0;
    QTest::newRow("logic") << "[1 and 0] + [1 or 0] + [1 xor 1]" << 1.0;
    QTest::newRow("strengths") << "1 + 1 eq 2 and 0 lt 1" << 1.0;
    QTest::newRow("comment") << "1 (one) + (two) 2" << 3.0;
  }
  void expressions() {
    QFETCH(QString, expression);
    QFETCH(double, value);
    const double found = valueOf(expression.toStdString());
    QVERIFY2(std::abs(found - value) < 1e-12, qPrintable(QString::number(found)));
  }

  void dialectsRoundDifferently() {
    QCOMPARE(valueOf("FIX[-2.5]", ProgramDialect::Fanuc), -2.0);
    QCOMPARE(valueOf("FUP[-2.5]", ProgramDialect::Fanuc), -3.0);
  }

  // Assignments of a line count from the next line on.
  void variables() {
    QVERIFY(endsAt(endOf("#1=5\n#1=6 G0 X#1\n"), 5.0, 0.0));
    QVERIFY(endsAt(endOf("#<a b>=2\n#<_G>=3\nG0 X#<ab> Z#<_g>\n"), 2.0, 3.0));
    QVERIFY(endsAt(endOf("#1=2 #2=7\nG0 X##1\n"), 7.0, 0.0));
    QVERIFY(endsAt(endOf("G21 G7 G0 X20 Z5\nG0 X#<_x> Z#5422\n"), 5.0, 5.0));  // _x is a radius
  }

  // F is in the units that were in effect before its line (LinuxCNC, order of execution).
  void feedComesBeforeUnits() {
    const auto feed = [](const char* text) { return run(text).value().moves.back().feed; };
    QCOMPARE(feed("G21\nG0 X1\nG20 F5\nG1 X2\n"), 5.0);
    QCOMPARE(feed("G20\nF5\nG1 X2\n"), 127.0);
  }

  void subprogramsReturnAValue() {
    QVERIFY(endsAt(endOf("o1 sub\no1 return [#1*2]\no1 endsub\no1 call [3]\nG0 X#<_value>\n"), 6.0, 0.0));
  }

  void subprogramsHaveTheirOwnVariables() {
    const std::string program =
        "o<f> sub\n#1=[#1*2]\n#<n>=1\no<f> endsub\n#1=5\no<f> call [3]\nG0 X#1 Z[exists[#<n>]]\n";
    QVERIFY(endsAt(endOf(program), 5.0, 0.0));
    QVERIFY(
        endsAt(endOf("o1 sub\nG0 X#1 Z#2\no2 if [#1 gt 2]\no1 return\no2 endif\nG0 Z9\no1 endsub\no1 call [3] [4]\n"),
               3.0, 4.0));
  }

  void branchesAndLoops() {
    const auto branch = [](int n) {
      return endOf("#1=" + std::to_string(n) +
                   "\no1 if [#1 eq 1]\nG0 X1\no1 elseif [#1 eq 2]\nG0 X2\no1 else\nG0 X3\no1 endif\nG0 Z1\n");
    };
    QVERIFY(endsAt(branch(1), 1.0, 1.0) && endsAt(branch(2), 2.0, 1.0) && endsAt(branch(7), 3.0, 1.0));
    QVERIFY(endsAt(endOf("#1=0\no1 while [#1 lt 4]\n#1=[#1+1]\no1 endwhile\nG0 X#1\n"), 4.0, 0.0));
    QVERIFY(endsAt(endOf("#1=9\no1 do\n#1=[#1+1]\no1 while [#1 lt 4]\nG0 X#1\n"), 10.0, 0.0));
    QVERIFY(
        endsAt(endOf("#1=0\no1 repeat [3]\no2 repeat [2]\n#1=[#1+1]\no2 endrepeat\no1 endrepeat\nG0 X#1\n"), 6.0, 0.0));
    QVERIFY(endsAt(endOf("#1=0\no1 while [1]\n#1=[#1+1]\no2 if [#1 gt 6]\no1 break\no2 endif\no1 endwhile\nG0 X#1\n"),
                   7.0, 0.0));
  }

  void macroB() {
    const auto fanuc = [](const std::string& text) { return endOf(text, ProgramDialect::Fanuc); };
    QVERIFY(endsAt(fanuc("#1=2+3*2\nG0 X#1 Z-#1\n"), 4.0, -8.0));
    QVERIFY(endsAt(fanuc("#1=0\nWHILE[#1 LT 5]DO1\n#1=#1+1\nEND1\nG0 Z#1\n"), 0.0, 5.0));
    QVERIFY(endsAt(fanuc("#1=1\nN10 #1=#1*2\nIF[#1 LT 20]GOTO10\nG0 Z#1\n"), 0.0, 32.0));
    QVERIFY(endsAt(fanuc("G65 P2 A3 X8\nG0 Z1\nM30\nO2\nG0 X#24 Z#1\nM99\n"), 4.0, 1.0));
    QVERIFY(endsAt(fanuc("O1\nM98 P20003\nM30\nO3\nG0 W2.\nM99\n"), 0.0, 4.0));  // twice
    // A vacant variable is as if its word were not there.
    QVERIFY(endsAt(fanuc("G0 X10 Z3\nG0 X#5 Z4\n"), 5.0, 4.0));
    QVERIFY(endsAt(fanuc("IF[#5 EQ #0]THEN #6=7\nG0 Z#6\n"), 0.0, 7.0));
  }

  void refusesWithPlaceAndAdvice_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<int>("line");
    QTest::addColumn<int>("column");
    QTest::addColumn<bool>("isFanuc");
    QTest::newRow("milling arc") << "G0 X1\n\nG17 G2 X2 Z0 R3 F1\n" << 3 << 5 << false;
    QTest::newRow("other axis") << "G0 X1 Y2\n" << 1 << 7 << false;
    QTest::newRow("unknown code") << "G18\n  G38.2 X1\n" << 2 << 3 << false;
    QTest::newRow("unknown M") << "M115\n" << 1 << 1 << false;
    QTest::newRow("word of Fanuc") << "G32 Z-5 F1\n" << 1 << 1 << false;
    QTest::newRow("word of LinuxCNC") << "G33 Z-5 K1\n" << 1 << 1 << true;
    QTest::newRow("unused word") << "G1 X1 F1 H3\n" << 1 << 10 << false;
    QTest::newRow("twice") << "G0 X1 X2\n" << 1 << 7 << false;
    QTest::newRow("two motions") << "G0 G1 X2\n" << 1 << 4 << false;
    QTest::newRow("no feed") << "G0 X1\nG1 X2\n" << 2 << 1 << false;
    QTest::newRow("no motion") << "X2\n" << 1 << 1 << false;
    QTest::newRow("no radius") << "G18 F1\nG2 X5 Z5\n" << 2 << 1 << false;
    QTest::newRow("short radius") << "G18 F1\nG2 X50 R3\n" << 2 << 8 << false;
    QTest::newRow("division") << "G0 X[1/0]\n" << 1 << 7 << false;
    QTest::newRow("open bracket") << "G0 X[1+2\n" << 1 << 9 << false;
    QTest::newRow("open comment") << "G0 (X1\n" << 1 << 4 << false;
    QTest::newRow("unknown variable") << "G0 X#<a>\n" << 1 << 6 << false;
    QTest::newRow("no subprogram") << "o<none> call\n" << 1 << 1 << false;
    QTest::newRow("no end") << "o1 while [1]\n" << 1 << 1 << false;
    QTest::newRow("letters") << "hello\n" << 1 << 2 << false;
    QTest::newRow("behind an O word") << "o1 sub\no1 endsub\no2 if [1] G0 X1\no2 endif\n" << 3 << 11 << false;
    QTest::newRow("behind else") << "o2 if [0]\no2 else X1\no2 endif\n" << 2 << 9 << false;
    QTest::newRow("thread at rest") << "G33 Z-5 K1\n" << 1 << 1 << false;
    QTest::newRow("no line") << "G0 X2\nGOTO 7\n" << 2 << 6 << true;
    QTest::newRow("tool") << "T1\n" << 1 << 1 << true;
    QTest::newRow("X and U") << "G0 X1 U2\n" << 1 << 7 << true;
  }
  void refusesWithPlaceAndAdvice() {
    QFETCH(QString, program);
    QFETCH(int, line);
    QFETCH(int, column);
    QFETCH(bool, isFanuc);
    const Result<ToolPath> path =
        run(program.toStdString(), isFanuc ? ProgramDialect::Fanuc : ProgramDialect::LinuxCnc);
    QVERIFY(!path);
    QVERIFY(path.error().code == ProgramError::Refused);
    QCOMPARE(path.error().position.value, static_cast<std::uint64_t>(line));
    QCOMPARE(path.error().arguments.at(0), std::to_string(column));
    QVERIFY(path.error().arguments.at(2).size() > 5 && path.error().arguments.at(3).ends_with('.'));
  }

  void endlessProgramsEnd() {
    for (const char* const text : {"o1 while [1]\no1 endwhile\n", "o1 sub\no1 call\no1 endsub\no1 call\n",
                                   "o1 repeat [1e9]\n#1=1\no1 endrepeat\n"}) {
      const Result<ToolPath> path = run(text);
      QVERIFY(!path && path.error().code != ErrorCode::Cancelled);
    }
    const Result<ToolPath> fanuc = run("N1 GOTO1\n", ProgramDialect::Fanuc);
    QVERIFY(!fanuc && fanuc.error().code == ProgramError::Endless);
    QVERIFY(!run("G17 F1\nG83 Z-10 R1 Q0.00000000001\n"));
    QVERIFY(!run("G98 F9\nG0 X50. Z0\nG75 X10. Z-9. P0.0000001 Q0.0000001\n", ProgramDialect::Fanuc));
    const Result<ToolPath> many = run("F1\no1 repeat [15000]\nG1 X1\nG1 X0\no1 endrepeat\n");
    QVERIFY(!many);
  }

  // A contour of thousands of lines, finished in ten thousand passes: neither blocks nor moves end it.
  void cyclesHaveABudget() {
    std::string text = "G18 F9\nO1 sub\nG0 X1 Z0\n";
    for (int i = 1; i <= 3000; ++i)
      text += "G1 X" + std::to_string(1.0 + 0.01 * i) + " Z" + std::to_string(-0.01 * i - 0.005 * (i % 2)) + "\n";
    text += "O1 endsub\nG0 X50 Z5\nG70 Q1 X40 Z2 D1 E0.1 P10000\nM2\n";
    ProgramSetup setup;
    const Result<ToolPath> path = runProgram(text, setup);
    QVERIFY(!path);
    JobState job;
    job.cancelled = true;
    const Result<ToolPath> cancelled = runProgram(text, setup, Progress(job));
    QVERIFY(!cancelled && cancelled.error().code == ErrorCode::Cancelled);
  }

  void isCancelled() {
    JobState job;
    job.cancelled = true;
    const Result<ToolPath> path = runProgram("o1 while [1]\no1 endwhile\n", {}, Progress(job));
    QVERIFY(!path && path.error().code == ErrorCode::Cancelled);
  }

  // A cut at 0.2 mm per revolution and 600 r/min moves 2 mm/s. With a constant surface speed the time is the integral
  // of 2πr/(1000 v f) over the path: faced from 20 mm to 10 mm at 100 m/min, π·(20² - 10²)/(1000·100·0.2) minutes.
  void estimatesTheTime() {
    ProgramSetup setup;
    setup.rapidSpeed = 6000.0;
    const auto seconds = [&](const char* text) { return runProgram(text, setup).value().time; };
    QVERIFY(std::abs(seconds("G95 S600 M3 F0.2\nG1 Z-20\n") - 10.0) < 1e-9);
    QVERIFY(std::abs(seconds("G94 F60\nG1 Z-20\n") - 20.0) < 1e-9);
    QVERIFY(std::abs(seconds("G0 Z-100\nG4 P1.5\n") - 2.5) < 1e-9);
    QVERIFY(std::abs(seconds("G93\nG1 Z-100 F2\n") - 30.0) < 1e-9);
    const double in = 20.0 / 6000.0 * 60.0;
    const double faced = M_PI * (400.0 - 100.0) / (1000.0 * 100.0 * 0.2) * 60.0;
    QVERIFY(std::abs(seconds("G0 X20\nG95 G96 S100 M3 F0.2\nG1 X10\n") - in - faced) < 1e-6);
  }

  // Any mutation of a program is run or refused.
  void survivesMutations() {
    const std::string seeds[] = {
        "G21 G18 G7\nT1 M6 G43\nG96 D2000 S100 M3\nG95 F0.2\nO1 sub\nG0 X10 Z0\nG1 X20 Z-5 A1\nG2 X24 Z-7 R2\nG1 "
        "Z-20\nO1 endsub\nG71 Q1 X40 Z2 D0.3 I1 R0.5\nG42 D1 G0 X40 Z3\nG70 Q1 X40 Z2\nG40\nG76 P1 Z-10 I-1 J.3 K.6 "
        "R1.5 Q29.5 H1 E0.5 L2\no2 repeat [3]\n#1=[#1+1]\nG33 Z-#1 K1\no2 endrepeat\nM2\n",
        "O1\nT0101\nG50 S2000\nG96 S150 M3\nG0 X40. Z2.\nG71 U1. R.5\nG71 P10 Q20 U.4 W.1 F.2\nN10 G0 X10.\nG1 Z0 "
        "F.1\nG3 X20. Z-5. R5.\nN20 G1 X40.\nG70 P10 Q20\nG76 P020060 Q100 R.1\nG76 X18. Z-20. P1200 Q400 F2.\nG92 "
        "X19. Z-10. F1.5\nX18.5\n#1=1\nWHILE[#1 LT 3]DO1\n#1=#1+1\nEND1\nM98 P2\nM30\nO2\nG1 U1. W-1. F.1\nM99\n"};
    const std::string corners =
        "O3(T)\nG98 F99 S9 M3\n/2 M23\nG0 X40. Z2. /3 X9.\nG71 U2. R.5\nG71 P1 Q2 U.4\nN1 G0 X10. W0\nG1 Z-5. "
        ",C1.\nX20. ,R2.\nG2 X20. Z-20. R9. ,R1.\nN2 G1 X44.\nG70 P1 Q2\nG1 W-9. I1.\nU9.\n#3001=#5041\nIF[#4001 EQ 0] "
        "THEN #3000=2(A)\nG92 X19. Z-10. F1.5\nN3 /4 #100=[#3012/2]/3\n#3006=1(B)\nG0 X#2003\n";
    rc::check([&] {
      const bool isFanuc = *rc::gen::arbitrary<bool>();
      std::string text = isFanuc && *rc::gen::arbitrary<bool>() ? corners : seeds[isFanuc ? 1 : 0];
      const int changes = *rc::gen::inRange(1, 6);
      for (int i = 0; i < changes; ++i) {
        const auto at = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(text.size())));
        switch (*rc::gen::inRange(0, 3)) {
          case 0:
            text[at] = *rc::gen::elementOf(std::string("0129.-[]#()GMXZUOoPQRIK\n%/;<>\xff"));
            break;
          case 1:
            text.erase(at, static_cast<std::size_t>(*rc::gen::inRange(1, 8)));
            break;
          default:
            text.insert(at, text, at / 2, 12);
            break;
        }
      }
      ProgramSetup setup;
      setup.skips = *rc::gen::arbitrary<std::uint16_t>();
      setup.hasIncrements = *rc::gen::arbitrary<bool>();
      const Result<ToolPath> path = run(text, isFanuc ? ProgramDialect::Fanuc : ProgramDialect::LinuxCnc, setup);
      if (!path) return;
      RC_ASSERT(std::isfinite(path->time) && path->time >= 0.0);
      for (const ToolMove& move : path->moves) RC_ASSERT(move.to.allFinite() && move.from.allFinite());
    });
  }
};

HANDWHEEL_TEST(ProgramWordsTest)
#include "ProgramWordsTest.moc"
