// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProgramTrial.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;
using test::ProgramTrial;

// Coordinate systems, shifts, references and tool offsets of LinuxCNC, as its manual of G codes has them.
class LinuxCncOffsetsTest : public QObject {
  Q_OBJECT

 private slots:
  // G92 gives a name to where the tool is: r 10, z 5 become 2 and 0, so 4 and 1 are 2 and 1 farther.
  void g92NamesWhereTheToolIs() {
    const ProgramTrial lathe;
    const std::string named = "G0 X10 Z5\nG92 X2 Z0\n";
    QVERIFY(lathe.endsAt(named + "G0 X4 Z1\n", 12, 6));
    QVERIFY(lathe.endsAt(named + "G92 Z3\nG0 X2 Z3\nG0 X4\n", 12, 5));
    QVERIFY(lathe.endsAt("G7 G0 X20 Z5\nG92 X4\nG0 X8\n", 12, 5));  // diameters
  }

  // G92.2 keeps the shift that G92.1 forgets, for G92.3 and for the parameters 5211 and 5213.
  void g92IsEndedAndBroughtBack() {
    const ProgramTrial lathe;
    const std::string named = "G0 X10 Z5\nG92 X2 Z0\n";
    QVERIFY(lathe.endsAt(named + "G92.1\nG0 X4 Z1\n", 4, 1));
    QVERIFY(lathe.endsAt(named + "G92.1\nG92.3\nG0 X4 Z1\n", 4, 1));
    QVERIFY(lathe.endsAt(named + "G92.2\nG0 X4 Z1\n", 4, 1));
    QVERIFY(lathe.endsAt(named + "G92.2\nG92.3\nG0 X4 Z1\n", 12, 6));
    QVERIFY(lathe.endsAt(named + "G92.2\nG0 X#5211 Z#5213\n", 8, 5));
    QVERIFY(lathe.endsAt(named + "G92.1\nG0 X1\nG0 X#5211 Z#5213\n", 0, 0));
  }

  void g52IsALocalSystem() {
    const ProgramTrial lathe;
    QVERIFY(lathe.endsAt("G0 X10 Z10\nG52 X3 Z-4\nG0 X1 Z1\n", 4, -3));
    QVERIFY(lathe.endsAt("G52 X3\nG52 Z-4\nG0 X1 Z1\n", 4, -3));  // an axis that is not named keeps its own
    QVERIFY(lathe.endsAt("G52 X3 Z-4\nG52 X0 Z0\nG0 X1 Z1\n", 1, 1));
    QVERIFY(lathe.endsAt("G20\nG52 Z-1\nG0 Z0\n", 0, -25.4));
  }

  // L2 sets the origin of a system, L20 the one in which the tool is where the line says. P0 is the active system.
  void g10SetsTheSystems() {
    const ProgramTrial lathe;
    QVERIFY(lathe.endsAt("G10 L2 P2 X5 Z-10\nG0 X1 Z1\nG55 G0 X0 Z0\n", 5, -10));
    QVERIFY(lathe.endsAt("G10 L2 P0 X5 Z-10\nG0 X1 Z1\n", 6, -9));
    QVERIFY(lathe.endsAt("G0 X3 Z4\nG10 L20 P1 X0 Z0\nG0 X1 Z1\n", 4, 5));
    QVERIFY(lathe.endsAt("G0 X3 Z4\nG10 L20 P2 X1 Z1\nG55 G0 X0 Z0\n", 2, 3));
    QVERIFY(lathe.endsAt("G10 L2 P9 X7 Z8 Y0\nG59.3 G0 X0 Z0\n", 7, 8));
    // 5220 is the number of the system, from 5221 on there are 20 parameters for each.
    QVERIFY(lathe.endsAt("G10 L2 P9 X7 Z8\nG0 X#5381 Z#5383\n", 7, 8));
    QVERIFY(lathe.endsAt("G10 L2 P2 X1\nG59.1\nG0 X#5220 Z#5230\n", 7, 0));
  }

  // A system that is selected leaves the tool where it is: the machine is at r 4, z 6 all the time.
  void systemsDoNotMoveTheTool() {
    const ProgramTrial lathe;
    QVERIFY(lathe.endsAt("G10 L2 P2 X5 Z-10\nG0 X4 Z6\nG55 G91 G0 X1 Z1\n", 5, 7));
    QVERIFY(lathe.endsAt("G0 X4 Z6\nG10 L2 P1 X5 Z-10\nG91 G0 X1 Z1\n", 5, 7));
  }

  // G28 goes to the position of G28.1, in coordinates of the machine; first over the point in the line, and then on the
  // axes in the line alone.
  void referencesArePositionsOfTheMachine() {
    const ProgramTrial lathe;
    const std::string set = "G0 X30 Z40\nG28.1\nG0 X20 Z10\nG30.1\nG0 X1 Z1\n";
    QVERIFY(lathe.endsAt(set + "G28\n", 30, 40));
    QVERIFY(lathe.endsAt(set + "G30\n", 20, 10));
    QVERIFY(lathe.endsAt(set + "G92 X5 Z5\nG28\n", 30, 40));
    QVERIFY(lathe.endsAt(set + "G28 X2\n", 30, 1));
    const auto moves = lathe.movesOf(set + "G28 Z5\n");
    QVERIFY(lathe.endsAt(set + "G28 Z5\n", 1, 40) && moves[moves.size() - 2].to == ProfilePoint(1, 5));
    QVERIFY(lathe.endsAt(set + "G0 X#5161 Z#5163\n", 30, 40) && lathe.endsAt(set + "G0 X#5181 Z#5183\n", 20, 10));
  }

  // The zero of the machine is 120 mm out and 100 mm to the right.
  void g53IsInCoordinatesOfTheMachine() {
    ProgramTrial lathe;
    lathe.setup.reference = {120, 100};
    QVERIFY(lathe.endsAt("G92 X1 Z1\nG53 G0 X-10 Z-20\n", 110, 80));
    QVERIFY(lathe.endsAt("G0 X1 Z1\nG53 X-10\n", 110, 1));
    const auto fed = lathe.movesOf("G7 G0 X2 Z1\nG53 G1 Z-20 F50\n");
    QVERIFY(fed.back().to == ProfilePoint(1, 80) && fed.back().kind == ToolMove::Kind::Feed);
  }

  // G43.1 sets the offset of the tool by hand. The tip of a tool whose own offset is 0 goes as much farther.
  void toolOffsets() {
    ProgramTrial lathe;
    lathe.setup.tools[1] = {0.4, 2, {0, 0}};
    lathe.setup.tools[3] = {0.6, 7, {1.5, -2.0}};
    QVERIFY(lathe.endsAt("T1 M6\nG43.1 X2 Z-3\nG0 X10 Z0\n", 12, -3));
    QVERIFY(lathe.endsAt("T1 M6\nG43.1 X2 Z-3\nG43.1 Z1\nG0 X10 Z0\n", 12, 1));
    QVERIFY(lathe.endsAt("T1 M6\nG43.1 X2 Z-3\nG49\nG0 X10 Z0\n", 10, 0));
    QVERIFY(lathe.endsAt("T3 M6 G43\nG0 X#5401 Z#5403\n", 1.5, -2));
    QVERIFY(lathe.endsAt("T3 M6 G43\nG0 X#5400 Z#5413\n", 3, 7));
    QVERIFY(lathe.endsAt("T3 M6 G43\nG0 X#5410 Z0\n", 1.2, 0));  // the diameter of the nose
    QVERIFY(lathe.endsAt("T3 M6\nG0 X3 Z7\n", 1.5, 9));          // without its offset the tip is elsewhere
  }

  void refuses_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("refusal");
    const auto row = [](const char* program, const char* refusal) {
      QTest::addRow("%s", qPrintable(QString(program).simplified())) << QString(program) << QString(refusal);
    };
    row("G92\n", "1: G92: an axis is missing. Write X or Z.");
    row("G10 L1 P1 X1\n", "1: G10: only L2 and L20 set something here. Set the tools in the table of tools.");
    row("G10 P1 X1\n", "1: G10: the word L is missing. Write L, 2 or 20.");
    row("G10 L2 P10 X1\n", "1: P10: this is a whole number from 0 to 9. Correct it.");
    row("G10 L2 P1 Y1\n", "1: Y1: a lathe has no Y axis. Remove it.");
    row("G92 G1 X2 F1\n", "1: G1: two codes in this line use X and Z. Divide the line.");
    row("F1 G1 X2\nG53 G2 X1 Z1 R3\n", "2: G53: it needs G0 or G1. Write G53 G0 X... Z...");
    row("G91\nG53 G0 X1\n", "2: G53: it is not possible with G91. Write G90 before it.");
    row("#5161=3\n", "1: #5161: this variable belongs to the machine and can only be read. Use another number.");
    row("#<_x>=3\n", "1: #<_x>: this variable belongs to the machine and can only be read. Use another name.");
  }
  void refuses() {
    QFETCH(QString, program);
    QFETCH(QString, refusal);
    QCOMPARE(QString::fromStdString(ProgramTrial().refusalOf(program.toStdString())), refusal);
  }
};

HANDWHEEL_TEST(LinuxCncOffsetsTest)
#include "LinuxCncOffsetsTest.moc"
