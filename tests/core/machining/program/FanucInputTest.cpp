// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProgramTrial.h"
#include "TestClass.h"

#include <QtTest>
#include <algorithm>

using namespace handwheel;
using test::ProgramTrial;

namespace {

const ProgramTrial kInputTrial(ProgramDialect::Fanuc);
const std::string kInputBegin = "G21 G99\nG97 S500 M3\n";

ProgramTrial inIncrements() {
  ProgramTrial lathe(ProgramDialect::Fanuc);
  lathe.setup.hasIncrements = true;
  return lathe;
}

ProgramTrial skipping(std::uint16_t skips, ProgramDialect dialect = ProgramDialect::Fanuc) {
  ProgramTrial lathe(dialect);
  lathe.setup.skips = skips;
  return lathe;
}

bool isSameInput(const std::vector<ToolMove>& a, const std::vector<ToolMove>& b) {
  return !a.empty() && std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const ToolMove& m, const ToolMove& n) {
    return m.kind == n.kind && m.turn == n.turn && (m.to - n.to).norm() < 1e-9 && std::abs(m.time - n.time) < 1e-9;
  });
}

std::vector<ToolMove> threadPasses(const std::vector<ToolMove>& moves) {
  std::vector<ToolMove> threads;
  std::copy_if(moves.begin(), moves.end(), std::back_inserter(threads),
               [](const ToolMove& m) { return m.kind == ToolMove::Kind::Thread; });
  return threads;
}

}  // namespace

// Numbers without a decimal point, skips of blocks and chamfers of threads (Fanuc, by its manual).
class FanucInputTest : public QObject {
  Q_OBJECT

 private slots:
  // R of the first line of G76 is in increments, as P and Q are: 50 µm are left for the last pass. The others are 0.4
  // √n deep, but at least 0.1 mm deeper than the one before, up to 1.303: 0.4, 0.566, 0.693, 0.8, 0.9 … 1.3.
  void finishingAllowanceOfAThread() {
    const auto cuts = threadPasses(
        kInputTrial.movesOf(kInputBegin + "G0 X24. Z5.\nG76 P010060 Q100 R50\nG76 X17.294 Z-20. P1353 Q400 F2.5\n"));
    const double depths[] = {0.4,  0.4 * std::sqrt(2.0), 0.4 * std::sqrt(3.0), 0.8, 0.9, 1.0, 1.1, 1.2, 1.3, 1.303,
                             1.353};
    QCOMPARE(cuts.size(), std::size(depths));
    const double crest = 0.5 * 17.294 + 1.353;
    for (std::size_t i = 0; i < cuts.size(); ++i) QVERIFY(std::abs(crest - cuts[i].to.x() - depths[i]) < 1e-9);
    const auto withPoint = threadPasses(
        kInputTrial.movesOf(kInputBegin + "G0 X24. Z5.\nG76 P010060 Q100 R0.05\nG76 X17.294 Z-20. P1353 Q400 F2.5\n"));
    QVERIFY(isSameInput(cuts, withPoint));
  }

  void lengthsInIncrements() {
    QVERIFY(inIncrements().endsAt("G0 X40000 Z2500\n", 20, 2.5));
    QVERIFY(inIncrements().endsAt("G0 X40. Z2500\nU-2000 W-500\n", 19, 2));
    QVERIFY(inIncrements().endsAt("G20 G0 X10000 Z-5000\n", 12.7, -12.7));
    QVERIFY(inIncrements().endsAt("#1=5\nG0 X#1 Z[3]\n", 2.5, 3));  // values of variables are in mm
    QVERIFY(inIncrements().endsAt("G65 P8 X30000 Z2.\nM30\nO8\nG0 X#24 Z#26\nM99\n", 15, 2));
    const auto dwell = inIncrements().movesOf("G0 X9.\nG4 X1500\nG4 U2.\nG4 P700\n");
    QCOMPARE(dwell[1].time, 1.5);
    QCOMPARE(dwell[2].time, 2.0);
    QCOMPARE(dwell[3].time, 0.7);
  }

  // The same program in both ways to write it.
  void programsInIncrements_data() {
    QTest::addColumn<QString>("increments");
    QTest::addColumn<QString>("points");
    QTest::newRow("arcs") << "G0 X20000 Z0\nG1 X30000 F0.2\nG3 X40000 Z-5000 R5000\nG2 X44000 Z-7000 I2000 K0\n"
                          << "G0 X20. Z0\nG1 X30. F0.2\nG3 X40. Z-5. R5.\nG2 X44. Z-7. I2. K0\n";
    const char* const contour = "N10 G0 X20.\nG1 Z-10. F0.1\nX30. Z-20.\nN20 X44.\nG0 X60.\n";
    QTest::newRow("roughing") << QString("G0 X40000 Z2000\nG71 U2000 R500\nG71 P10 Q20 U400 W100 F0.3\n") + contour
                              << QString("G0 X40. Z2.\nG71 U2. R.5\nG71 P10 Q20 U.4 W.1 F0.3\n") + contour;
    QTest::newRow("depth D") << QString("G0 X40. Z2.\nG71 P10 Q20 U400 W100 D2000 F0.3\n") + contour
                             << QString("G0 X40. Z2.\nG71 P10 Q20 U.4 W.1 D2. F0.3\n") + contour;
    QTest::newRow("pattern") << QString("G0 X60. Z5.\nG73 U4000 W2000 R3\nG73 P10 Q20 U400 W100 F0.2\n") + contour
                             << QString("G0 X60. Z5.\nG73 U4. W2. R3\nG73 P10 Q20 U.4 W.1 F0.2\n") + contour;
    QTest::newRow("pecks") << "G0 X10. Z2.\nG74 R500\nG74 X4000 Z-8000 P2000 Q4000 F0.1\n"
                           << "G0 X10. Z2.\nG74 R0.5\nG74 X4. Z-8. P2000 Q4000 F0.1\n";
    QTest::newRow("thread") << "G0 X24. Z5.\nG76 P010060 Q100 R50\nG76 X17294 Z-20000 R-500 P1353 Q400 F2.5\n"
                            << "G0 X24. Z5.\nG76 P010060 Q100 R50\nG76 X17.294 Z-20. R-0.5 P1353 Q400 F2.5\n";
    QTest::newRow("turning cycle") << "G0 X40. Z2.\nG90 X30000 Z-9000 R-1000 F.2\n"
                                   << "G0 X40. Z2.\nG90 X30. Z-9. R-1. F.2\n";
    QTest::newRow("corner") << "G0 X20. Z2.\nG1 Z-10. ,C2000 F.2\nX40.\n"
                            << "G0 X20. Z2.\nG1 Z-10. ,C2. F.2\nX40.\n";
  }
  void programsInIncrements() {
    QFETCH(QString, increments);
    QFETCH(QString, points);
    QVERIFY(isSameInput(inIncrements().movesOf(kInputBegin + increments.toStdString()),
                        kInputTrial.movesOf(kInputBegin + points.toStdString())));
  }

  // A depth D without a decimal point is in increments in both formats.
  void depthIsInIncrements() {
    const std::string contour = "N10 G0 X20.\nG1 Z-10. F0.1\nN20 X44.\nG0 X60.\n";
    QVERIFY(isSameInput(kInputTrial.movesOf(kInputBegin + "G0 X40. Z2.\nG71 P10 Q20 D2000 F0.3\n" + contour),
                        kInputTrial.movesOf(kInputBegin + "G0 X40. Z2.\nG71 U2. R.5\nG71 P10 Q20 F0.3\n" + contour)));
  }

  // A / with a number skips the rest of its line if the switch of the number is on; / is /1.
  void skips() {
    const auto end = [](std::uint16_t on, const char* text, double r, double z) {
      return skipping(on).endsAt(std::string("G0 X10. Z1.\n") + text, r, z);
    };
    QVERIFY(end(0, "/2 X20.\n/ X30.\n", 15, 1));
    QVERIFY(end(1 << 1, "/2 X20.\n/ X30.\n", 10, 1));
    QVERIFY(end(1 << 1, "/2 X20.\n/1X30.\n", 10, 1));
    QVERIFY(end(1 << 2, "/2 X20.\n/1 X30.\n", 15, 1));
    QVERIFY(end(1 << 9, "X20. /9 Z5.\n", 10, 1));
    QVERIFY(end(1 << 8, "X20. /9 Z5.\n", 10, 5));
    QVERIFY(end(1 << 3, "/2/3 X20.\n", 5, 1) && end(0, "/2/3 X20.\n", 10, 1));
    QVERIFY(end(1 << 3, "N10 /3 X20.\n", 5, 1) && end(0, "N10 /3 X20.\n", 10, 1));
    QVERIFY(end(1 << 4, "#1=8./4 X20.\nX#1\n", 1, 1));  // a division
    QVERIFY(end(1 << 4, "N5/4IF[1 EQ 1]GOTO9\nX20.\nN9 Z3.\n", 10, 3));
    QVERIFY(end(0, "N5/4IF[1 EQ 1]GOTO9\nX20.\nN9 Z3.\n", 5, 3));
    QVERIFY(end(1 << 4, "/4N5 X20.\nGOTO9\nN9 Z3.\n", 5, 3));
    QVERIFY(skipping(1 << 1, ProgramDialect::LinuxCnc).endsAt("G0 X10\n/ G0 X20\n", 10, 0));
    QVERIFY(skipping(0, ProgramDialect::LinuxCnc).endsAt("G0 X10\n/ G0 X20\n", 20, 0));
    QVERIFY(skipping(0, ProgramDialect::LinuxCnc).refusalOf("G0 X10\n/2 G0 X20\n").starts_with("2: 2: no word begins"));
  }

  // A lead of 2 mm: 45 degrees over one lead, or what G76 has set.
  void chamferOfAThread() {
    const auto plain = threadPasses(kInputTrial.movesOf(kInputBegin + "G0 X24. Z5.\nG92 X18. Z-20. F2.\n"));
    QVERIFY(plain.size() == 1 && (plain[0].to - ProfilePoint(9, -20)).norm() < 1e-9);
    const auto out = kInputTrial.movesOf(kInputBegin + "M23\nG0 X24. Z5.\nG92 X18. Z-20. F2.\n");
    const auto cut = threadPasses(out);
    QVERIFY(cut.size() == 2 && (cut[0].to - ProfilePoint(9, -18)).norm() < 1e-9);
    QVERIFY((cut[1].to - ProfilePoint(11, -20)).norm() < 1e-9 && cut[0].feed == 2.0);
    QVERIFY(std::abs(cut[1].feed - 2.0 * std::sqrt(2.0)) < 1e-9);
    QVERIFY((out[out.size() - 2].to - ProfilePoint(12, -20)).norm() < 1e-9);
    const auto half =
        threadPasses(kInputTrial.movesOf(kInputBegin + "M23\nG0 X24. Z5.\nG76 P010560\nG92 X18. Z-20. F2.\n"));
    QVERIFY(half.size() == 2 && (half[0].to - ProfilePoint(9, -19)).norm() < 1e-9);
    // A chamfer does not go beyond where the tool began.
    const auto near = threadPasses(kInputTrial.movesOf(kInputBegin + "M23\nG0 X20. Z5.\nG92 X18. Z-20. F2.\n"));
    QVERIFY((near[1].to - ProfilePoint(10, -20)).norm() < 1e-9);
    const std::string cycle = "G0 X24. Z5.\nG76 P011060 Q100 R50\nG76 X17.6 Z-20. P1200 Q400 F2.\n";
    QVERIFY(std::abs(threadPasses(kInputTrial.movesOf(kInputBegin + cycle))[0].to.y() + 18.0) < 0.5);
    for (const ToolMove& each : threadPasses(kInputTrial.movesOf(kInputBegin + "M24\n" + cycle)))
      QVERIFY(each.from.x() == each.to.x());
  }

  void refuses_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("refusal");
    QTest::addColumn<bool>("hasIncrements");
    const auto row = [](const char* program, const char* refusal, bool hasIncrements = false) {
      QTest::addRow("%s", qPrintable(QString(program).simplified()))
          << QString(program) << QString(refusal) << hasIncrements;
    };
    const std::string hint =
        " Without a decimal point it is in mm or inch here: write one, or choose that such numbers are increments.";
    row("G71 U2000 R500\n", ("3: U2000: no tool cuts as deep as this." + hint).c_str());
    row("G72 W1500 R1\n", ("3: W1500: no tool cuts as deep as this." + hint).c_str());
    row("G71 U2. R500\n", ("3: R500: the retract is longer than any cut is deep." + hint).c_str());
    row("G75 R500\n", ("3: R500: the retract is longer than any step." + hint).c_str());
    row("G73 U9500 W0 R5\n", ("3: U9500: no bar has as much to cut as this." + hint).c_str());
    row("G0 X40. Z2.\nG71 P1 Q2 D2\nM30\nN1 G0 X10.\nN2 G1 Z-5.\n",
        "4: D2: without a decimal point it is in 0.001 mm or 0.0001 inch, less than a chip. Write a decimal point.");
    row("G0 X40. Z2.\nG71 U2. R1.\nG71 P1 Q2 U400 W100 F.2\nM30\nN1 G0 X10.\nN2 G1 Z-5.\n",
        ("5: U400: the allowance is larger than all that is cut." + hint).c_str());
    row("G0 X40. Z2.\nG71 U2. R1.\nG71 P1 Q2 W100. F.2\nM30\nN1 G0 X10.\nN2 G1 Z-5.\n",
        "5: W100: the allowance is longer than the contour. Correct it.");
    row("G0 X24. Z5.\nG76 P010060 Q100 R1.5\nG76 X17.294 Z-20. P1353 Q400 F2.5\n",
        "5: G76: the finishing allowance R of the line before is as deep as the thread. Correct the words of the "
        "cycle.");
    row("G0 X24. Z5.\nG76 P010060 Q100 R50\nG76 X17.294 Z-20. P1353 Q4000 F2.5\n",
        "5: G76: the first depth Q is deeper than the thread, which has the height P. Correct the words of the cycle.");
    row("G0 X24. Z5.\nG76 P010060 Q2000 R50\nG76 X17.294 Z-20. P1353 Q400 F2.5\n",
        "5: G76: the least depth Q of the line before is deeper than the thread. Correct the words of the cycle.");
    row("G1 X40. F2\n",
        "3: F2: a control counts this feed per revolution by its parameters. Write it with a decimal point.", true);
  }
  void refuses() {
    QFETCH(QString, program);
    QFETCH(QString, refusal);
    QFETCH(bool, hasIncrements);
    const ProgramTrial lathe = hasIncrements ? inIncrements() : kInputTrial;
    QCOMPARE(QString::fromStdString(lathe.refusalOf(kInputBegin + program.toStdString())), refusal);
  }
};

HANDWHEEL_TEST(FanucInputTest)
#include "FanucInputTest.moc"
