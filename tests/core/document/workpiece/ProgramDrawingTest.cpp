// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "document/workpiece/PassesProgram.h"
#include "document/workpiece/ProgramTrial.h"
#include "document/workpiece/target/TargetImport.h"
#include "machining/drawing/PartDrawing.h"

#include <QtTest>

using namespace handwheel;

namespace {

// The dimensions of a bar of 40 × 100 mm after a program, in order.
QStringList drawnTexts(const std::string& program, const ProgramTools& tools) {
  WorkpieceSnapshot workpiece;
  workpiece.stock = {40.0, 100.0, -100.0};
  workpiece.mesh = std::make_shared<const StockMesh>(workpiece.stock, workpiece.chord);
  ProgramSetup setup = usualSetup(ProgramDialect::LinuxCnc, workpiece.stock, 10.0, 0.0);
  setup.tools = tools;
  const auto trial = ProgramTrial::run(workpiece, program, setup, 0.05);
  if (!trial) return {QStringLiteral("the program was refused")};
  workpiece.part = (*trial)->part();
  const Result<TargetProfile> section = sectionOf(workpiece);
  if (!section) return {QStringLiteral("there is no section")};
  DrawingTitle title;
  title.tolerance = workpiece.chord;
  QStringList texts;
  for (const Sheet::Text& each : dimensionSheet(*section, title, {}).texts) texts << QString::fromStdString(each.text);
  texts.sort();
  return texts;
}

}  // namespace

// The drawing of a part that a program cut has the sizes of the program, each once.
class ProgramDrawingTest : public QObject {
  Q_OBJECT

 private slots:
  void sizes_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QStringList>("expected");
    // The fillet ends at Z -44, whose face goes on to a chamfer; a groove of 4 mm interrupts the cylinder.
    QTest::newRow("stepped shaft")
        << "G0 X0 Z2\nG1 Z0 F100\nX16\nX20 Z-2\nZ-39\nG2 X30 Z-44 R5\nG1 X36\nX40 Z-46\nX44\n"
           "G0 Z-20\nG1 X14\nZ-24\nX44\n"
        << QStringList{"Ø40", "Ø20", "Ø14", "R5", "2× 2×45°", "20", "24", "44", "100"};
    // Two fillets that take their whole shoulders.
    QTest::newRow("two fillets") << "G0 X0 Z2\nG1 Z0 F100\nX20\nZ-19\nG2 X30 Z-24 R5\nG1 Z-39\nG2 X40 Z-44 R5\nG1 X44\n"
                                 << QStringList{"Ø40", "Ø30", "Ø20", "2×R5", "24", "44", "100"};
    // The ball meets the neck where x² + z² = 12²: 5² + 10.909² = 12². The taper rises by 2 over 30: 2 atan(2/30).
    QTest::newRow("ball handle") << "G0 X0 Z2\nG1 Z0 F100\nG3 X10 Z-22.909 R12\nG1 Z-40\nX16\nX20 Z-70\nZ-80\nX44\n"
                                 << QStringList{"Ø40", "Ø20", "Ø16", "Ø10", "SR12", "∠7.63°", "40", "70", "80", "100"};
  }
  void sizes() {
    QFETCH(QString, words);
    QFETCH(QStringList, expected);
    expected.sort();
    QCOMPARE(drawnTexts("G7 G21 G97 S600 M3\n" + words.toStdString() + "G0 X60 Z20\nM2\n", {}), expected);
  }

  // A ball drill of 10 mm and a bar that bores: two equal chamfers at the end, outside and inside.
  void boredBush() {
    const Result<ProgramTools> tools = readToolTable("T1 P1 X0 Z0 D0 Q2\nT2 P2 X0 Z0 D10 Q7\nT3 P3 X0 Z0 D0 Q3\n");
    QVERIFY(tools.hasValue());
    QStringList expected{"Ø40", "Ø36", "Ø20", "SR5", "2× 1×45°", "30", "35", "40", "100"};
    expected.sort();
    QCOMPARE(drawnTexts("G7 G21 G97\nT1 M6 G43\nS800 M3\nG0 X0 Z2\nG1 Z0 F100\nX34\nX36 Z-1\nZ-40\nX44\nG0 Z5\n"
                        "T2 M6 G43\nS800 M3\nG0 X0 Z5\nG1 Z-35\nG0 Z5\n"
                        "T3 M6 G43\nS800 M3\nG0 X22 Z5\nG1 Z0\nX20 Z-1\nZ-30\nX0\nG0 Z5\nM2\n",
                        *tools),
             expected);
  }
};

HANDWHEEL_TEST(ProgramDrawingTest)
#include "ProgramDrawingTest.moc"
