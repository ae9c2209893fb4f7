// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProgramTrial.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;
using test::ProgramTrial;

namespace {

const ProgramTrial kFanucTrial(ProgramDialect::Fanuc);

}  // namespace

// Coordinates, macros and refusals of Fanuc, system A, as its manual has them. X is a diameter.
class FanucModesTest : public QObject {
  Q_OBJECT

 private slots:
  void localSystems() {
    QVERIFY(kFanucTrial.endsAt("G52 X10. Z-5.\nG0 X20. Z0\n", 15, -5));
    QVERIFY(kFanucTrial.endsAt("G52 X10. Z-5.\nG52 X0 Z0\nG0 X20. Z1.\n", 10, 1));
    // All systems have the zero of the part as long as nothing sets them.
    QVERIFY(kFanucTrial.endsAt("G0 X20. Z2.\nG55 G0 W1.\nG54 G0 U2.\n", 11, 3));
  }

  // Machine zero is 120 mm out and 100 mm to the right. Where the second reference is not set, it is there, too.
  void machineCoordinates() {
    ProgramTrial lathe(ProgramDialect::Fanuc);
    lathe.setup.reference = {120, 100};
    QVERIFY(lathe.endsAt("G0 X20. Z2.\nG53 G0 X-40. Z-30.\n", 100, 70));
    QVERIFY(lathe.endsAt("G0 X20. Z2.\nG53 Z0\n", 10, 100));
    QVERIFY(lathe.endsAt("G0 X20. Z2.\nG53 G1 X0 F50. G98\n", 120, 2));
    QVERIFY(lathe.endsAt("G0 X20. Z2.\nG30 P2 U0\n", 120, 2));
    // 5041 and 5042 are where the tool is, 5021 and 5022 the same in coordinates of the machine; 5001, 5002 where the
    // block before has ended. X is a diameter there, too.
    QVERIFY(lathe.endsAt("G0 X20. Z2.\nG0 X#5041 Z[#5042+1]\n", 10, 3));
    QVERIFY(lathe.endsAt("G0 X20. Z2.\nG0 X#5001 Z[#5002+1]\n", 10, 3));
    QVERIFY(lathe.endsAt("G0 X20. Z2.\nG53 X#5021 Z[#5022+1]\n", 10, 3));
  }

  // L repeats a macro; its variables are its own. P of M98 without L has the repeats before the number.
  void macrosAreRepeated() {
    const std::string macro = "M30\nO2\n#1=#1+1\nG0 W-1.\n#100=#100+#1\nM99\n";
    QVERIFY(kFanucTrial.endsAt("G0 X2.\nG65 P2 L3 A7\n" + macro, 1, -3));
    QVERIFY(kFanucTrial.endsAt("G0 X2.\nM98 P2 L2\n" + macro, 1, -2));
    QVERIFY(kFanucTrial.endsAt("G0 X2.\nM98 P40002\n" + macro, 1, -4));
  }

  // Words of Haas for its chip conveyor have no effect, which is noted at their lines.
  void theConveyorIsNoted() {
    const Result<ToolPath> path = runProgram("G0 X2.\nM31\nM33\n", kFanucTrial.setup);
    QVERIFY(path && path->notes.size() == 2);
    QCOMPARE(path->notes[0].line, std::uint32_t{2});
    QCOMPARE(path->notes[1].text, std::string("M33 (chip conveyor) has no effect here."));
  }

  void refusesWithNoseCompensation_data() {
    QTest::addColumn<QString>("line");
    for (const char* const line : {"T0202", "G55", "G28 U0", "G53 X0", "G90 X20. Z-5.", "G71 P1 Q2", "G76 X9. Z-5."})
      QTest::newRow(line) << QString(line);
  }
  void refusesWithNoseCompensation() {
    QFETCH(QString, line);
    ProgramTrial lathe(ProgramDialect::Fanuc);
    lathe.setup.standard = {0.8, 3, {0, 0}};
    const std::string refusal =
        lathe.refusalOf("G98 G0 X50. Z5.\nG42 G1 X30. Z2. F100.\nG1 Z-9.\n" + line.toStdString() + "\n");
    QVERIFY2(refusal.starts_with("4: ") && refusal.ends_with("Write G40 before it."), refusal.c_str());
  }

  void refuses_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("refusal");
    const auto row = [](const char* program, const char* refusal) {
      QTest::addRow("%s", qPrintable(QString(program).simplified())) << QString(program) << QString(refusal);
    };
    row("G91 G0 X1.\n",
        "1: G91: this code is not supported on a lathe. In system A write U and W for increments, G98 and G99 for the "
        "feed.");
    row("G34 Z-5. F1.\n", "1: G34: this code is not supported on a lathe. A thread of changing lead is not simulated.");
    row("G66 P2\n", "1: G66: this code is not supported on a lathe. Write G65 in each line instead.");
    row("G84 Z-5.\n",
        "1: G84: this code is not supported on a lathe. Tapping is not simulated: cut the thread with G32, G92 or "
        "G76.");
    row("G0 G1 X1.\n", "1: G1: it contradicts G0 in the same line. Remove one of them.");
    row("G53\n", "1: G53: X or Z is missing. Write G53 X0 or G53 Z0.");
    row("G98 G2 X2. Z-1. R1. F9.\nG53 X0\n", "2: G53: it needs G0 or G1. Write G53 G0 X... Z...");
    row("G30 P3 U0\n", "1: P3: there is only the second reference position here. Write P2, or nothing.");
    row("G65 P9\n", "1: P9: there is no macro with this number. Put it into the same file.");
    row("M98 P9\n", "1: P9: there is no subprogram with this number. Put it into the same file.");
    row("M115\n",
        "1: M115: this code is not supported on a lathe. Remove it; docs/programs.md lists the words that are "
        "understood.");
    row("IF[1 EQ 1] X2.\n", "1: X2.: GOTO or THEN is expected after the condition. Write IF [...] GOTO n.");
    row("IF[1 EQ 1]THEN X2.\n", "1: THEN: only a variable can be set after THEN. Use GOTO for more.");
    row("G98 F9.\nG0 X50. Z2.\nG70 P1 Q2\nM30\nN1 G0 X10.\nM3\nN2 G1 Z-5.\n",
        "6: M3: the contour of a cycle has no such code. Put it before or after the contour.");
    row("G98 F9.\nG0 X50. Z2.\nG71 U1. R1.\nG71 P1 Q2\nM30\nN1 G0 X10.\nM3\nN2 G1 Z-5.\n",
        "7: M3: the contour of a cycle has no such code. Put it before or after the contour.");
  }
  void refuses() {
    QFETCH(QString, program);
    QFETCH(QString, refusal);
    QCOMPARE(QString::fromStdString(kFanucTrial.refusalOf(program.toStdString())), refusal);
  }
};

HANDWHEEL_TEST(FanucModesTest)
#include "FanucModesTest.moc"
