// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramInterpreter.h"

#include "TestClass.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace handwheel;

namespace {

using MoveKind = ToolMove::Kind;

std::vector<ToolMove> movesOf(const std::string& text, double nose = 0.0) {
  ProgramSetup setup;
  setup.dialect = ProgramDialect::Fanuc;
  setup.standard = {nose, 3, {0, 0}};
  const Result<ToolPath> path = runProgram(text, setup);
  if (!path) qWarning("line %d: %s", int(path.error().position.value), path.error().arguments.at(2).c_str());
  return path ? path->moves : std::vector<ToolMove>();
}

bool near(const ProfilePoint& p, double r, double z, double tolerance = 1e-9) {
  return std::abs(p.x() - r) < tolerance && std::abs(p.y() - z) < tolerance;
}

std::vector<ToolMove> only(const std::vector<ToolMove>& moves, MoveKind kind) {
  std::vector<ToolMove> found;
  std::copy_if(moves.begin(), moves.end(), std::back_inserter(found),
               [&](const ToolMove& m) { return m.kind == kind; });
  return found;
}

const std::string kBegin = "G21 G18 G99\nG97 S500 M3\n";

}  // namespace

// Programs of Fanuc, system A, against its manual. X is a diameter in the programs and a radius in the moves.
class FanucProgramTest : public QObject {
  Q_OBJECT

 private slots:
  void diametersAndIncrements() {
    const auto moves = movesOf(kBegin + "G0 X40. Z2.\nG1 X30. F0.2\nU-4. W-3.\nG2 X30. Z-3. R2.\n");
    QCOMPARE(moves.size(), std::size_t{4});
    QVERIFY(near(moves[1].to, 15.0, 2.0) && near(moves[2].to, 13.0, -1.0) && near(moves[3].to, 15.0, -3.0));
    QCOMPARE(int(moves[3].turn), -1);
    QVERIFY(moves[1].isPerRevolution && moves[1].feed == 0.2);
    QVERIFY(near(movesOf("G20\nG0 X2. Z-1.\n")[0].to, 25.4, -25.4));
  }

  void dwellsAndReference() {
    const auto moves = movesOf("G0 X40. Z2.\nG4 P1500\nG4 U2.\nG28 U0\nG28 W0\n");
    QCOMPARE(moves.size(), std::size_t{5});
    QCOMPARE(moves[1].time, 1.5);
    QCOMPARE(moves[2].time, 2.0);
    QVERIFY(near(moves[3].to, 0.0, 2.0) && near(moves[4].to, 0.0, 0.0));
  }

  void surfaceSpeedIsClamped() {
    const auto moves = movesOf("G50 S1500\nG96 S100 M3\nG0 X40. Z0\nG1 X0 F0.1\n");
    QVERIFY(std::abs(spindleAt(moves.back(), 20.0) - 1e5 / (M_PI * 40.0)) < 1e-9);
    QCOMPARE(spindleAt(moves.back(), 1.0), 1500.0);
    QCOMPARE(spindleAt(moves.back(), 0.0), 1500.0);
  }

  void coordinatesAreSet() {
    const auto moves = movesOf("G0 X40. Z10.\nG50 X20. Z0\nG0 X24. Z1.\n");
    QVERIFY(near(moves[1].to, 22.0, 11.0));
  }

  // Levels of 2 mm (radius) from the start, each to the contour with its allowance: 0.2 on the radius, 0.1 in z.
  void roughsInLevels() {
    const std::string contour = "N10 G0 X20.\nG1 Z-10. F0.1\nX30. Z-20.\nN20 X44.\n";
    const auto moves =
        movesOf(kBegin + "G0 X40. Z2.\nG71 U2. R0.5\nG71 P10 Q20 U0.4 W0.1 F0.3\n" + contour + "G0 X60.\n");
    const auto cuts = only(moves, MoveKind::Feed);
    std::vector<double> levels;
    for (const ToolMove& m : cuts)
      if (m.turn == 0 && std::abs(m.from.x() - m.to.x()) < 1e-9 && m.to.y() < m.from.y() - 1.0)
        levels.push_back(m.to.x());
    // From 20 down in steps of 2, the first at 18, as far as the allowance at 10.2; then along the contour.
    const std::vector<double> expected = {18.0, 16.0, 14.0, 12.0};
    QVERIFY(levels.size() >= expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) QVERIFY(std::abs(levels[i] - expected[i]) < 1e-9);
    for (std::size_t k = 1; k < moves.size(); ++k) {
      for (int i = 0; i <= 20; ++i) {
        const ProfilePoint p = pointOn(moves[k], i / 20.0);
        if (p.y() > 2.1 || p.y() < -19.9) continue;
        const double left = p.y() > -9.9 ? 10.2 : 10.2 + 0.5 * (-9.9 - p.y());
        QVERIFY2(p.x() > left - 1e-6, qPrintable(QString("r %1 z %2").arg(p.x()).arg(p.y())));
      }
    }
    QVERIFY(near(moves[moves.size() - 2].to, 20.0, 2.0) && near(moves.back().to, 30.0, 2.0));
    // One line with the depth D, as on a Haas: the same cuts.
    const auto haas = movesOf(kBegin + "G0 X40. Z2.\nG71 P10 Q20 U0.4 W0.1 D2. F0.3\n" + contour + "G0 X60.\n");
    QCOMPARE(haas.size(), moves.size());
  }

  void finishesAlongTheContour() {
    const auto moves =
        movesOf(kBegin +
                "G0 X40. Z2.\nG70 P10 Q20\nG0 X60.\nM30\nN10 G0 X20.\nG1 Z-10. F0.1\nG2 X24. Z-12. R2.\nN20 G1 X44.\n");
    QCOMPARE(moves.size(), std::size_t{7});
    QVERIFY(near(moves[1].to, 10.0, 2.0) && moves[1].kind == MoveKind::Rapid);
    QVERIFY(near(moves[2].to, 10.0, -10.0) && moves[2].feed == 0.1);
    QVERIFY(moves[3].turn == -1 && near(moves[3].centre, 12.0, -10.0, 1e-6));
    QVERIFY(near(moves[5].to, 20.0, 2.0) && moves[5].kind == MoveKind::Rapid);
  }

  void threadDepthsFollowTheRoot() {
    const auto moves = movesOf(kBegin + "G0 X24. Z5.\nG76 P020060 Q050 R0.1\nG76 X17.546 Z-30. P1227 Q400 F2.\n");
    const auto cuts = only(moves, MoveKind::Thread);
    QVERIFY(cuts.size() > 4);
    const double crest = 0.5 * 17.546 + 1.227;
    for (std::size_t n = 0; n + 3 < cuts.size(); ++n)
      QVERIFY(std::abs(crest - cuts[n].to.x() - 0.4 * std::sqrt(n + 1.0)) < 1e-9);
    // Up to the allowance, then twice to the full depth.
    QVERIFY(std::abs(cuts[cuts.size() - 3].to.x() - 0.5 * 17.546 - 0.1) < 1e-9);
    QVERIFY(near(cuts.back().to, 0.5 * 17.546, -30.0) && near(cuts[cuts.size() - 2].to, 0.5 * 17.546, -30.0));
    QCOMPARE(cuts.back().feed, 2.0);
    QVERIFY(near(moves.back().to, 12.0, 5.0));
  }

  // F is the travel along the axis with the larger travel of the thread; the feed of a move is that along its path.
  void leadsOfTapers_data() {
    QTest::addColumn<QString>("cuts");
    QTest::newRow("G32") << "G0 X10. Z0.\nG32 X20. Z-30. F2.\n";
    QTest::newRow("G32, steep") << "G0 X10. Z0.\nG32 X40. Z-10. F2.\n";
    QTest::newRow("G92") << "G0 X44. Z2.\nG92 X40. Z-8. R-5. F2.\nX39.\n";
    QTest::newRow("G92, steep") << "G0 X44. Z2.\nG92 X40. Z-8. R-15. F2.\n";
    QTest::newRow("G76") << "G0 X24. Z5.\nG76 P010060 Q50 R0.\nG76 X17. Z-30. R-3. P1200 Q400 F2.\n";
    QTest::newRow("G76, steep") << "G0 X24. Z0.\nG76 P010000 Q50 R0.\nG76 X17. Z-1. R-3. P1200 Q400 F2.\n";
    QTest::newRow("G76 in one line") << "G0 X24. Z5.\nG76 X17. Z-30. K1.2 D0.4 I-3. F2.\n";
  }
  void leadsOfTapers() {
    QFETCH(QString, cuts);
    const auto threads = only(movesOf(kBegin + cuts.toStdString()), MoveKind::Thread);
    QVERIFY(!threads.empty());
    for (const ToolMove& move : threads) {
      const ProfilePoint displacement = move.to - move.from;
      QVERIFY(displacement.x() != 0.0);
      QVERIFY(std::abs(move.feed * displacement.cwiseAbs().maxCoeff() / displacement.norm() - 2.0) < 1e-9);
    }
  }

  void boxCyclesAreModal() {
    const auto moves = movesOf(kBegin + "G0 X40. Z2.\nG90 X36. Z-20. F0.2\nX32.\n");
    QCOMPARE(moves.size(), std::size_t{9});
    QVERIFY(near(moves[1].to, 18.0, 2.0) && near(moves[2].to, 18.0, -20.0) && near(moves[3].to, 20.0, -20.0));
    QVERIFY(near(moves[6].to, 16.0, -20.0) && near(moves[8].to, 20.0, 2.0));
    const auto thread = movesOf(kBegin + "G0 X22. Z5.\nG92 X19.4 Z-10. F1.5\nX19.\nX18.8\n");
    QCOMPARE(only(thread, MoveKind::Thread).size(), std::size_t{3});
    QCOMPARE(only(thread, MoveKind::Thread).back().feed, 1.5);
  }

  void peckingGoesDownInSteps() {
    const auto moves = movesOf(kBegin + "G0 X44. Z-10.\nG75 R0.5\nG75 X30. P3000 F0.1\n");
    const auto cuts = only(moves, MoveKind::Feed);
    const std::vector<double> expected = {19.0, 16.0, 15.0};
    QCOMPARE(cuts.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) QVERIFY(near(cuts[i].to, expected[i], -10.0));
    QVERIFY(near(moves.back().to, 22.0, -10.0));
  }

  // The contour a cylinder: the tip keeps its side of it, the nose of 0.8 mm touches it.
  void noseCompensationKeepsTheDistance() {
    const auto moves = movesOf(kBegin + "G0 X50. Z5.\nG42 G0 X30. Z2.\nG1 Z-20. F0.1\nG1 X50.\nG40 G0 X60.\n", 0.8);
    // Tip 3 is the corner below left of the nose: on a cylinder the tip is on it.
    const auto cuts = only(moves, MoveKind::Feed);
    QVERIFY(std::abs(cuts.front().to.x() - 15.0) < 1e-9);
    QVERIFY(std::abs(cuts.front().to.y() + 20.0) < 1e-9);
  }
};

HANDWHEEL_TEST(FanucProgramTest)
#include "FanucProgramTest.moc"
