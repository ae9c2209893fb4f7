// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "machining/program/ProgramInterpreter.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace handwheel;

namespace {

using CycleMoves = std::vector<ToolMove>;

CycleMoves fanucMoves(const std::string& text) {
  ProgramSetup setup;
  setup.dialect = ProgramDialect::Fanuc;
  const Result<ToolPath> path = runProgram("G21 G18 G99\nG97 S500 M3\n" + text, setup);
  if (!path) qWarning("line %d: %s", int(path.error().position.value), path.error().arguments.at(2).c_str());
  return path ? path->moves : CycleMoves();
}

bool isRefused(const std::string& text) {
  ProgramSetup setup;
  setup.dialect = ProgramDialect::Fanuc;
  return !runProgram("G21 G18 G99\nG97 S500 M3\n" + text, setup);
}

bool goesTo(const ToolMove& move, double r, double z, bool isFeed) {
  return (move.kind == ToolMove::Kind::Feed) == isFeed && std::abs(move.to.x() - r) < 1e-9 &&
         std::abs(move.to.y() - z) < 1e-9;
}

CycleMoves feedsOf(const CycleMoves& moves) {
  CycleMoves feeds;
  std::copy_if(moves.begin(), moves.end(), std::back_inserter(feeds),
               [](const ToolMove& m) { return m.kind == ToolMove::Kind::Feed; });
  return feeds;
}

}  // namespace

// The cycles of Fanuc, system A, move by move as its manual draws them. X is a diameter in the programs.
class FanucCycleTest : public QObject {
  Q_OBJECT

 private slots:
  // R is the distance from the tool: from Z 10 by -8 to Z 2. Then steps of 5 mm to Z -12, each back to Z 2, down again
  // to 0.254 mm before the drilled depth; at last to the start of the tool.
  void drillsFromTheLevel() {
    const CycleMoves moves = fanucMoves("G0 X0 Z10.\nG83 Z-12. R-8. Q5000 F0.1\nG80\nG0 X50.\n");
    QCOMPARE(moves.size(), std::size_t{11});
    QVERIFY(goesTo(moves[1], 0, 2, false));
    QVERIFY(goesTo(moves[2], 0, -3, true) && goesTo(moves[3], 0, 2, false) && goesTo(moves[4], 0, -3 + 0.254, false));
    QVERIFY(goesTo(moves[5], 0, -8, true) && goesTo(moves[6], 0, 2, false) && goesTo(moves[7], 0, -8 + 0.254, false));
    QVERIFY(goesTo(moves[8], 0, -12, true) && goesTo(moves[9], 0, 10, false));
    QCOMPARE(moves[2].feed, 0.1);
  }

  // Without R it begins where it is; W counts from R; P dwells at the bottom; the words are modal until G80.
  void drillingIsModal() {
    const CycleMoves spot = fanucMoves("G0 X0 Z2.\nG82 Z-4. P500 F0.1\n");
    QCOMPARE(spot.size(), std::size_t{4});
    QVERIFY(goesTo(spot[1], 0, -4, true) && spot[2].kind == ToolMove::Kind::Dwell && goesTo(spot[3], 0, 2, false));
    QCOMPARE(spot[2].time, 0.5);
    const CycleMoves increments = fanucMoves("G0 X0 Z5.\nG81 W-10. R-3. F0.1\n");
    QVERIFY(goesTo(feedsOf(increments).front(), 0, -8, true));
    const CycleMoves again = fanucMoves("G0 X0 Z5.\nG83 Z-6. R-3. Q4000 F0.1\nZ-8.\n");
    const CycleMoves feeds = feedsOf(again);
    QCOMPARE(feeds.size(), std::size_t{5});
    QVERIFY(goesTo(feeds[2], 0, -2, true) && goesTo(feeds[4], 0, -8, true));
    QVERIFY(isRefused("G0 X0 Z5.\nG83 Z-6. R-3. F0.1\n"));
    QVERIFY(isRefused("G0 X0 Z5.\nG83 Z-6. R-20. Q4000 F0.1\n"));
    QVERIFY(isRefused("G0 X0 Z5.\nG83 R-2. Q4000 F0.1 X0\n"));
  }

  // Facing in levels of 1.5 mm from Z 2 to the contour, which is a cone from Ø40 at Z -6 to Ø20 at Z -2 and a face
  // there.
  void facesInLevels() {
    const CycleMoves moves = fanucMoves(
        "G0 X44. Z2.\nG72 W1.5 R0.5\nG72 P10 Q20 U0.4 W0.1 F0.2\nN10 G0 Z-6.\nG1 X40.\nX20. Z-2.\nN20 X0\nG0 X60.\n");
    std::vector<double> levels;
    for (const ToolMove& m : feedsOf(moves))
      if (std::abs(m.from.y() - m.to.y()) < 1e-9 && m.to.x() < m.from.x() - 0.5) levels.push_back(m.to.y());
    const std::vector<double> expected = {0.5, -1.0, -2.5, -4.0, -5.5};
    QVERIFY(levels.size() >= expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) QVERIFY(std::abs(levels[i] - expected[i]) < 1e-9);
    // Never nearer to the contour than the allowance: 0.1 in z, 0.2 on the radius.
    for (const ToolMove& m : moves) {
      for (int i = 0; i <= 20; ++i) {
        const ProfilePoint p = pointOn(m, i / 20.0);
        const double r = p.x() - 0.2;
        const double face = r > 20.0 ? -6.0 : r > 10.0 ? -2.0 - 0.4 * (r - 10.0) : -2.0;
        QVERIFY2(p.y() > face + 0.1 - 1e-6, qPrintable(QString("r %1 z %2").arg(p.x()).arg(p.y())));
      }
    }
  }

  // Three passes along a contour: 4 mm, 2 mm and 0 mm away in X, 2, 1 and 0 in Z, with an allowance of 0.2 on the
  // radius.
  void repeatsThePattern() {
    const CycleMoves moves = fanucMoves(
        "G0 X60. Z5.\nG73 U4. W2. R3\nG73 P10 Q20 U0.4 W0.1 F0.2\nN10 G0 X20. Z1.\nG1 Z-10.\nG2 X30. Z-15. R5.\nN20 G1 "
        "X40.\n");
    const CycleMoves feeds = feedsOf(moves);
    QCOMPARE(feeds.size(), std::size_t{9});
    for (int pass = 0; pass < 3; ++pass) {
      const double x = 0.2 + 2.0 * (2 - pass), z = 0.1 + 1.0 * (2 - pass);
      const ToolMove* const f = &feeds[static_cast<std::size_t>(3 * pass)];
      QVERIFY(std::abs(f[0].from.x() - 10.0 - x) < 1e-9 && std::abs(f[0].from.y() - 1.0 - z) < 1e-9);
      QVERIFY(goesTo(f[0], 10.0 + x, -10.0 + z, true));
      QVERIFY(f[1].turn == -1 && goesTo(f[1], 15.0 + x, -15.0 + z, true));
      QVERIFY((f[1].centre - ProfilePoint(15.0 + x, -10.0 + z)).norm() < 1e-6);
      QVERIFY(goesTo(f[2], 20.0 + x, -15.0 + z, true));
    }
    QVERIFY(goesTo(moves.back(), 30.0, 5.0, false));
  }

  // Along Z in steps of 4 mm with 0.5 mm back, at Ø10, Ø6 and Ø4.
  void pecksAlongZ() {
    const CycleMoves moves = fanucMoves("G0 X10. Z2.\nG74 R0.5\nG74 X4. Z-8. P2000 Q4000 F0.1\n");
    const CycleMoves feeds = feedsOf(moves);
    QCOMPARE(feeds.size(), std::size_t{9});
    const double radii[] = {5.0, 3.0, 2.0};
    for (int i = 0; i < 9; ++i) {
      const double depth = i % 3 == 0 ? -2.0 : i % 3 == 1 ? -6.0 : -8.0;
      QVERIFY(goesTo(feeds[static_cast<std::size_t>(i)], radii[i / 3], depth, true));
    }
    QVERIFY(goesTo(moves[2], 5.0, -1.5, false));
    QVERIFY(goesTo(moves.back(), 5.0, 2.0, false));
  }

  // Steps that are smaller than the resolution of a number at that coordinate come to an end, too.
  void pecksNearlyNothing() {
    const double z = 100.00000000000003, r = 50.00000000000003;
    const CycleMoves along = fanucMoves("G0 X10. Z100.\nG74 R0\nG74 Z100.00000000000003 Q0.000000000000001 F0.1\n");
    QVERIFY(!feedsOf(along).empty() && feedsOf(along).back().to.y() == z && along.back().to.y() == 100.0);
    const CycleMoves across = fanucMoves("G0 X100. Z2.\nG75 R0\nG75 X100.00000000000006 P0.000000000000001 F0.1\n");
    QVERIFY(!feedsOf(across).empty() && feedsOf(across).back().to.x() == r && across.back().to.x() == 50.0);
  }

  // In to Z, along X, out along Z and back; the next Z alone repeats it. R tilts the face.
  void facingCycle() {
    const CycleMoves moves = fanucMoves("G0 X44. Z2.\nG94 X10. Z-1. F0.2\nZ-2.\n");
    QCOMPARE(moves.size(), std::size_t{9});
    QVERIFY(goesTo(moves[1], 22, -1, false) && goesTo(moves[2], 5, -1, true) && goesTo(moves[3], 5, 2, true) &&
            goesTo(moves[4], 22, 2, false));
    QVERIFY(goesTo(moves[5], 22, -2, false) && goesTo(moves[6], 5, -2, true));
    const CycleMoves cone = fanucMoves("G0 X44. Z2.\nG94 X10. Z-1. R-3. F0.2\n");
    QVERIFY(goesTo(cone[1], 22, -4, false) && goesTo(cone[2], 5, -1, true));
  }

  // A bore roughed from Ø16 in levels of 1 mm outwards, U negative: never nearer than 0.2 mm to the contour.
  void roughsABore() {
    const CycleMoves moves = fanucMoves(
        "G0 X16. Z2.\nG71 U1. R0.5\nG71 P10 Q20 U-0.4 W0.1 F0.2\nN10 G0 X30.\nG1 Z-10.\nX20. Z-20.\nN20 X15.\nG0 "
        "Z50.\n");
    std::vector<double> levels;
    for (const ToolMove& m : feedsOf(moves))
      if (std::abs(m.from.x() - m.to.x()) < 1e-9 && m.to.y() < m.from.y() - 1.0) levels.push_back(m.to.x());
    const std::vector<double> expected = {9.0, 10.0, 11.0, 12.0, 13.0, 14.0};
    QVERIFY(levels.size() >= expected.size());
    for (const double level : expected)
      QVERIFY(std::any_of(levels.begin(), levels.end(), [&](double l) { return std::abs(l - level) < 1e-9; }));
    for (const ToolMove& m : moves) {
      for (int i = 0; i <= 20; ++i) {
        const ProfilePoint p = pointOn(m, i / 20.0);
        if (p.y() > 2.1 || p.y() < -19.9) continue;
        const double wall = p.y() > -9.9 ? 14.8 : 14.8 - 0.5 * (-9.9 - p.y());
        QVERIFY2(p.x() < wall + 1e-6, qPrintable(QString("r %1 z %2").arg(p.x()).arg(p.y())));
      }
    }
  }

  // The move in ends square to the contour: with a nose of 0.8 mm above a cylinder of 30 mm, so its tip 3 is on it,
  // also where the first move is shorter than the nose. The shoulder that follows goes on in an arc around the corner.
  void entersSquareToTheContour() {
    ProgramSetup setup;
    setup.dialect = ProgramDialect::Fanuc;
    setup.standard = {0.8, 3, {0, 0}};
    const auto path =
        runProgram("G21 G99 G97 S500 M3\nG0 X50. Z5.\nG42 G0 X30. Z-10.\nG1 Z-10.3 F0.1\nX20.\nG40 G0 X60.\n", setup);
    QVERIFY(bool(path));
    QVERIFY(goesTo(path->moves[1], 15.0, -10.8, false));  // the tip is a nose below and left of its centre
    QVERIFY(goesTo(path->moves[2], 15.0, -11.1, true));
    QVERIFY(path->moves[3].turn != 0 && goesTo(path->moves[3], 14.2, -11.9, true));
  }

  // G97 keeps the speed that G96 had where the tool is, G96 the last surface speed; F of a thread stays.
  void speedAndFeedAreKept() {
    const CycleMoves speed =
        fanucMoves("G96 S200 M3\nG0 X40. Z2.\nG97\nG1 X39. F0.1\nG96\nG1 X38.\nG97 S300\nG1 X37.\n");
    QVERIFY(std::abs(speed[1].spindle - 200e3 / (M_PI * 40.0)) < 1e-9 && !speed[1].isSurfaceSpeed);
    QVERIFY(speed[2].isSurfaceSpeed && speed[2].spindle == 200.0);
    QVERIFY(!speed[3].isSurfaceSpeed && speed[3].spindle == 300.0);
    QVERIFY(isRefused("G96\n"));
    const CycleMoves thread = fanucMoves(
        "G1 X30. F0.1\nG0 X24. Z5.\nG76 P010060 Q50 R0.1\nG76 X17.5 Z-30. P1200 Q400 F2.\nG1 X30.\nG32 Z-5.\n");
    QCOMPARE(thread[thread.size() - 2].feed, 2.0);
    QVERIFY(thread.back().kind == ToolMove::Kind::Thread && thread.back().feed == 2.0);
  }

  // A value that no line before has set is told, once.
  void valuesThatNobodyNamedAreTold() {
    const auto notes = [](const std::string& cycles) {
      ProgramSetup setup;
      setup.dialect = ProgramDialect::Fanuc;
      const auto path = runProgram("G21 G18 G99\nG97 S500 M3 F0.1\nG0 X40. Z2.\n" + cycles, setup);
      std::string text = path ? "" : "refused";
      if (path)
        for (const ToolPath::Note& note : path->notes) text += std::to_string(note.line) + " " + note.text + "\n";
      return text;
    };
    const auto told = [](int line, const std::string& code, const std::string& values) {
      return std::to_string(line) + " No " + code + " in a line before sets " + values +
             ". A control takes its parameter: write it.\n";
    };
    const std::string contour = "N1 G0 X20.\nG1 Z-10.\nN2 X40.\n";
    const std::string retract = "the retract (R), so it is 0.5 mm";
    QCOMPARE(notes("G71 P1 Q2\n" + contour),
             told(4, "G71", "the depth of cut (U), so it is 1 mm") + told(4, "G71", retract));
    QCOMPARE(notes("G72 P1 Q2 D2.\nN1 G0 Z-10.\nG1 X20.\nN2 Z2.\n"), told(4, "G72", retract));
    QCOMPARE(notes("G71 U2. R1.\nG71 P1 Q2\n" + contour), std::string());
    QCOMPARE(notes("G73 P1 Q2\n" + contour),
             told(4, "G73", "the relief (U, W) and the number of passes (R), so the contour is cut once"));
    QCOMPARE(notes("G75 X20. P2000\nG75 X10. P2000\n"), told(4, "G75", retract));
    QCOMPARE(notes("G74 R1.\nG74 Z-9. Q2000\n"), std::string());
    QCOMPARE(notes("G76 X37. Z-10. P1000 Q400 F1.5\n"),
             told(4, "G76",
                  "the last passes, chamfer and angle (P) and the last depths (Q, R), so it ends with one pass, "
                  "without a chamfer, at 60°"));
    QCOMPARE(notes("G76 P010060\nG76 X37. Z-10. P1000 Q400 F1.5\n"), std::string());
  }
};

HANDWHEEL_TEST(FanucCycleTest)
#include "FanucCycleTest.moc"
