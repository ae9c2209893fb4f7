// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProgramTrial.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;
using test::ProgramTrial;

namespace {

void addLinuxCncRefusal(const char* program, const char* refusal) {
  QTest::addRow("%s", qPrintable(QString(program).simplified().left(60))) << QString(program) << QString(refusal);
}

}  // namespace

// Modes, subprograms and refusals of LinuxCNC, as its manual has them. X is a radius.
class LinuxCncModesTest : public QObject {
  Q_OBJECT

 private slots:
  // M70 saves the modes and the coordinate system, M72 restores them, M71 forgets them. The tool stays.
  void modesAreSavedAndRestored() {
    const ProgramTrial lathe;
    QVERIFY(lathe.endsAt("G21 G90\nM70\nG20 G91\nM72\nG0 X1\nG0 X2\n", 2, 0));
    QVERIFY(lathe.endsAt("G10 L2 P2 X5\nM70\nG55\nM72\nG0 X1\n", 1, 0));
    QVERIFY(lathe.endsAt("T1 M6\nM70\nT2 M6\nT4\nM72\nG0 X#5400 Z#<_selected_tool>\n", 2, 4));
    QCOMPARE(lathe.refusalOf("M70\nM71\nM72\n"), std::string("3: M72: no state was saved. Write M70 before it."));
    QCOMPARE(lathe.refusalOf("M72\n"), std::string("1: M72: no state was saved. Write M70 before it."));
  }

  // M73 restores them where its subprogram returns, M70 does not.
  void m73RestoresOnReturn() {
    const ProgramTrial lathe;
    const auto program = [](const char* save) {
      return "o1 sub\n" + std::string(save) + "\nG91\no1 endsub\nG90\no1 call\nG0 X1\nG0 X2\n";
    };
    QVERIFY(lathe.endsAt(program("M73"), 2, 0));
    QVERIFY(lathe.endsAt(program("M70"), 3, 0));
    QVERIFY(lathe.endsAt(program("M73\nM71"), 3, 0));
  }

  void coolantIsReadFromVariables() {
    const ProgramTrial lathe;
    QVERIFY(lathe.endsAt("M7\nG0 X2 Z2\nG0 X#<_mist> Z#<_flood>\n", 1, 0));
    QVERIFY(lathe.endsAt("M8\nG0 X2 Z2\nG0 X#<_mist> Z#<_flood>\n", 0, 1));
    QVERIFY(lathe.endsAt("M7\nM8\nM9\nG0 X2 Z2\nG0 X#<_mist> Z#<_flood>\n", 0, 0));
  }

  // Subprograms by number, behind the end of the program. M99 at its end would begin it again: it ends here.
  void subprogramsByNumber() {
    const ProgramTrial lathe;
    const std::string sub = "M2\nO100\nG91 G0 Z-1\nM99\n";
    QVERIFY(lathe.endsAt("G0 X2\nM98 P100 L3\n" + sub, 2, -3));
    QVERIFY(lathe.endsAt("G0 X2\nM98 P100\n" + sub, 2, -1));
    QVERIFY(lathe.endsAt("G0 X1\nM99\nG0 X2\n", 1, 0));
    QCOMPARE(lathe.refusalOf("M98 P7\n"),
             std::string("1: P7: there is no subprogram with this number. Put it into the same file."));
    QCOMPARE(lathe.refusalOf("M98 P100 L0\n" + sub),
             std::string("1: L0: this is a whole number from 1 to 9999. Correct it."));
  }

  void functionsOfExpressions() {
    const ProgramTrial lathe;
    QVERIFY(lathe.endsAt("G0 X[tan[45]] Z[sqrt[2.25]]\n", 1, 1.5));
    const std::string nested = std::string(200, '[') + "1" + std::string(200, ']');
    QVERIFY(lathe.refusalOf("G0 X" + nested + "\n").find("nested too deeply") != std::string::npos);
    QVERIFY(lathe.refusalOf("#<" + std::string(81, 'a') + ">=1\n").find("this is not a name") != std::string::npos);
  }

  // G80 ends the motion, so that X alone is none.
  void g80EndsTheMotion() {
    QCOMPARE(ProgramTrial().refusalOf("G0 X1\nG80\nX2\n"),
             std::string("3: X2: there is no motion for X and Z. Write G0 or G1 before them."));
  }

  // The nose of G41.1 and G42.1 is in the line: its diameter D, its orientation L. On a cylinder the centre (L9) is its
  // radius out, the tip of orientation 2, towards axis and chuck, on the surface.
  void theNoseIsInTheLine() {
    const ProgramTrial lathe;
    const auto radius = [&](const char* begin) {
      const auto moves = lathe.movesOf("G0 X50 Z5\n" + std::string(begin) + "\nG1 X30 Z2 F100\nG1 Z-20\nG40 G0 X60\n");
      return moves.size() < 3 ? 0.0 : moves[2].to.x();
    };
    QVERIFY(std::abs(radius("G42.1 D1.6 L9") - 30.8) < 1e-9);
    QVERIFY(std::abs(radius("G42.1 D1.6") - 30.8) < 1e-9);
    QVERIFY(std::abs(radius("G42.1 D1.6 L2") - 30.0) < 1e-9);
    QVERIFY(std::abs(radius("G41.1 D1.6 L9") - 29.2) < 1e-9);
    // In inches: 1 + 0.05.
    QVERIFY(lathe.endsAt("G20\nG0 X2 Z1\nG42.1 D0.1 L9\nG1 X1 Z0.5 F10\nG1 Z-1\n", 1.05 * 25.4, -25.4));
  }

  void refusesWithNoseCompensation_data() {
    QTest::addColumn<QString>("line");
    for (const char* const line : {"T2 M6", "G55", "G17", "G43", "G10 L2 P1 X1", "G28", "G92 X1", "G53 G0 X1",
                                   "G71 Q1 X40 Z2", "G33 Z-5 K1", "G41.1 D1"})
      QTest::newRow(line) << QString(line);
  }
  void refusesWithNoseCompensation() {
    QFETCH(QString, line);
    const std::string refusal =
        ProgramTrial().refusalOf("S100 M3 G0 X50 Z5\nG42.1 D1\nG1 X30 F100\n" + line.toStdString() + "\n");
    QVERIFY2(refusal.starts_with("4: ") && refusal.ends_with("Write G40 before it."), refusal.c_str());
  }

  // The move after G40 leaves the offset; it must be straight (LinuxCNC, "Cutter Compensation").
  void theMoveAfterCompensationIsStraight() {
    const std::string begin = "G0 X50 Z5\nG42.1 D1\nG1 X30 F100\nG40\n";
    QVERIFY(ProgramTrial().refusalOf(begin + "G2 X32 Z7 R3\n").find("must be straight") != std::string::npos);
    QCOMPARE(ProgramTrial().refusalOf(begin + "G0 X60\nG2 X62 Z7 R3\n"), std::string());
  }

  void refuses_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("refusal");
    addLinuxCncRefusal("G33 Z-5\n", "1: G33: the pitch is missing. Write K, the way for one revolution.");
    addLinuxCncRefusal("G18 F1 G2 X2 Z2 R5 P2\n", "1: P2: an arc on a lathe has one turn. Remove P.");
    addLinuxCncRefusal("G18 F1 G2 X0 Z0 R5\n",
                       "1: R: an arc with R cannot end where it begins. Give the centre with I and K instead of R.");
    addLinuxCncRefusal(
        "G18 F1 G2 X0 Z4 K1\n",
        "1: I K: the ends of the arc are 1 and 3 mm from its centre. Correct I and K, or give the radius R "
        "instead.");
    addLinuxCncRefusal(
        "G19\n", "1: G19: this code is not supported on a lathe. A lathe works in the plane of X and Z: write G18.");
    addLinuxCncRefusal(
        "G74 X1\n",
        "1: G74: this code is not supported on a lathe. Tapping is not simulated: cut the thread with G33 or G76.");
    addLinuxCncRefusal("G96 D-1 S100\n", "1: D-1: the greatest speed of the spindle is not above 0. Write D in r/min.");
    addLinuxCncRefusal("S-5\n", "1: S-5: a spindle speed is not negative. Write M4 to turn it backwards.");
    const std::string remedy =
        "Finish without G70: call a subprogram that goes in with G42 (G41 in a bore), along the "
        "contour, and out with G40.";
    const std::string finished = "O1 sub\nG0 X8 Z1\nG1 Z0\nX12 Z-2\nZ-18\nX52\nO1 endsub\nG7 S9 M3 F9\nG0 X54 Z2\n";
    addLinuxCncRefusal("O1 sub\nG42 G0 X8 Z1\nG1 Z0\nO1 endsub\nG70 Q1 F9\n",
                       ("2: G42: the contour of a cycle has no nose compensation. " + remedy).c_str());
    addLinuxCncRefusal("O1 sub\nG0 X8 Z1\nG1 Z0\nG40\nO1 endsub\nG70 Q1 F9\n",
                       ("4: G40: the contour of a cycle has no nose compensation. " + remedy).c_str());
    addLinuxCncRefusal((finished + "G42.1 D3 L2\nG70 Q1 F9\nM2\n").c_str(),
                       ("11: nose compensation: the first move is not longer than the nose radius. " + remedy).c_str());
    addLinuxCncRefusal("G17 G42.1 D1\n",
                       "1: G42.1: nose compensation works in the plane of X and Z. Write G18 before it.");
    addLinuxCncRefusal("G42.1 D-1\n", "1: G42.1: the diameter of the nose is negative. Use the other side.");
    addLinuxCncRefusal(
        "G95 F0.1\nG1 X1\n",
        "2: F: a feed per revolution needs a turning spindle. Write a speed and M3 or M4 before it, such as S500 M3.");
    addLinuxCncRefusal("G4 P-1\n", "1: G4: the dwell is not between 0 and 100000 s. Correct its time.");
    addLinuxCncRefusal("G0 X10000000\n",
                       "1: X Z: the place is farther away than 1000 m. Check the numbers of the move.");
    addLinuxCncRefusal("G71 Q7 X4 Z2\n", "1: G71: there is no subprogram 7. Write it as O7 sub ... endsub.");
    addLinuxCncRefusal("o1 sub\nM3\no1 endsub\nG0 X9 Z2\nG71 Q1 X9 Z2\n",
                       "2: M3: the contour of a cycle has no such code. Put it before or after the cycle.");
    addLinuxCncRefusal("o1 sub\nX2 Z-3\no1 endsub\nG71 Q1 X9 Z2\n",
                       "2: X2: there is no motion for X and Z. Write G0 or G1 before them.");
    addLinuxCncRefusal("G17 G76 P1 Z-5 I-1 J0.2 K0.5\n",
                       "1: G76: it works in the plane of X and Z. Write G18 before it.");
    addLinuxCncRefusal("G76 X1 P1 Z-5 I-1 J0.2 K0.5\n",
                       "1: X1: the drive line of the thread is parallel to Z. Remove X.");
    addLinuxCncRefusal("G18 F1 G81 Z-5 R1\n",
                       "1: G81: in this plane it would drill across. Write G17 before it, G18 after.");
    addLinuxCncRefusal("o1 return\no1 sub\no1 endsub\n",
                       "1: O1: there is nothing to return from. Call the subprogram instead.");
    addLinuxCncRefusal("o1 if [1]\no1 break\no1 endif\n",
                       "2: O1: there is no loop around it with this label. Give it the label of its loop.");
  }
  void refuses() {
    QFETCH(QString, program);
    QFETCH(QString, refusal);
    QCOMPARE(QString::fromStdString(ProgramTrial().refusalOf(program.toStdString())), refusal);
  }

  // 30 arguments are the most; a line has words to a limit, too, and a program a size.
  void limits() {
    const ProgramTrial lathe;
    std::string call = "o1 sub\nG0 X#30\no1 endsub\no1 call";
    for (int i = 1; i <= 30; ++i) call += " [" + std::to_string(i) + "]";
    QVERIFY(lathe.endsAt(call + "\n", 30, 0));
    QVERIFY(lathe.refusalOf(call + " [31]\n").find("at most 30 arguments") != std::string::npos);
    std::string words;
    for (int i = 0; i < 1000; ++i) words += "M1 ";
    QVERIFY(lathe.refusalOf(words + "\n").find("the line has too many words") != std::string::npos);
    QVERIFY(lathe.refusalOf("G0 X1 ;" + std::string(4096, ' ') + "\n").find("4096 bytes") != std::string::npos);
    QCOMPARE(runProgram(std::string((std::size_t{64} << 20) + 1, '\n'), lathe.setup).error().code,
             ErrorCode(ErrorCode::FileTooLarge));
    const Error lines = runProgram(std::string(2'000'001, '\n'), lathe.setup).error();
    QCOMPARE(lines.arguments, (std::vector<std::string>{"lines", "", "2000000"}));
  }

  // A path ends with an error where it has more moves than the setup lets it have.
  void tooManyMoves() {
    ProgramTrial lathe;
    lathe.setup.mostMoves = 10;
    const std::string loop = "o1 repeat [5]\nG0 X1\nG0 X0\no1 endrepeat\n";
    QCOMPARE(lathe.movesOf(loop).size(), std::size_t{10});
    const Result<ToolPath> more = runProgram(loop + "G0 X2\n", lathe.setup);
    QVERIFY(!more && more.error().code == ErrorCode(ProgramError::TooManyMoves));
    QCOMPARE(more.error().arguments, std::vector<std::string>{"10"});
    QCOMPARE(more.error().position.value, std::uint64_t{5});
  }

  // Over E mm the tool comes from the crest to the full depth, and with L3 goes out so at the end. The pitch goes on
  // along Z (LinuxCNC, G76).
  void threadsMayBeginTapered() {
    const auto moves = ProgramTrial().movesOf("S100 M3\nG0 X20 Z5\nG76 P2 Z-30 I-1 J0.5 K0.8 R1 E2 L3\n");
    std::vector<ToolMove> threads;
    for (const ToolMove& move : moves)
      if (move.kind == ToolMove::Kind::Thread) threads.push_back(move);
    QVERIFY(threads.size() >= 4);
    const std::vector<ProfilePoint> last = {{19, 5}, {18.2, 3}, {18.2, -28}, {19, -30}};
    for (std::size_t i = 0; i < last.size(); ++i) {
      const ToolMove& move = threads[threads.size() - last.size() + i];
      QVERIFY2((move.to - last[i]).norm() < 1e-9, qPrintable(QString("%1 %2").arg(move.to.x()).arg(move.to.y())));
      const ProfilePoint displacement = move.to - move.from;
      if (displacement.y() != 0.0)
        QVERIFY(std::abs(move.feed * std::abs(displacement.y()) / displacement.norm() - 2.0) < 1e-9);
    }
  }
};

HANDWHEEL_TEST(LinuxCncModesTest)
#include "LinuxCncModesTest.moc"
