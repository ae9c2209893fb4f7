// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProgramTrial.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;
using test::ProgramTrial;

namespace {

const ProgramTrial kCornerTrial(ProgramDialect::Fanuc);
const std::string kCornerBegin = "G21 G99\nG97 S500 M3\nG0 X20. Z2.\n";

std::vector<ToolMove> cornerMoves(const std::string& text) {
  return kCornerTrial.movesOf(kCornerBegin + text);
}

bool reaches(const ToolMove& move, int turn, double r, double z) {
  const bool isThere = move.turn == turn && (move.to - ProfilePoint(r, z)).norm() < 1e-6;
  if (!isThere) qWarning("turn %d to r %.7f z %.7f", move.turn, move.to.x(), move.to.y());
  return isThere;
}

// Returns true if both programs make the same moves.
bool isSamePath(const std::string& a, const std::string& b) {
  const std::vector<ToolMove> left = cornerMoves(a), right = cornerMoves(b);
  if (left.size() != right.size()) qWarning("%zu and %zu moves", left.size(), right.size());
  if (left.empty() || left.size() != right.size()) return false;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const bool isEqual = left[i].kind == right[i].kind && left[i].turn == right[i].turn &&
                         (left[i].to - right[i].to).norm() < 1e-6 &&
                         (left[i].turn == 0 || (left[i].centre - right[i].centre).norm() < 1e-6);
    if (isEqual) continue;
    qWarning("move %zu: r %g z %g and r %g z %g", i, left[i].to.x(), left[i].to.y(), right[i].to.x(), right[i].to.y());
    return false;
  }
  return true;
}

}  // namespace

// Chamfers and roundings at corners (Fanuc): points are computed by hand. Moves are (r, z), X is a diameter.
class FanucCornersTest : public QObject {
  Q_OBJECT

 private slots:
  // A chamfer of 2 mm from Z to X, a rounding of 3 mm from X to Z, a chamfer back towards the axis.
  void squareCorners() {
    const auto moves = cornerMoves("G1 Z-10. ,C2. F0.2\nX40. ,R3.\nZ-20. I-1.5\nX30.\n");
    QCOMPARE(moves.size(), std::size_t{8});
    QVERIFY(reaches(moves[1], 0, 10, -8) && reaches(moves[2], 0, 12, -10));
    QVERIFY(reaches(moves[3], 0, 17, -10) && reaches(moves[4], 1, 20, -13));
    QVERIFY((moves[4].centre - ProfilePoint(17, -13)).norm() < 1e-9);
    QVERIFY(reaches(moves[5], 0, 20, -18.5) && reaches(moves[6], 0, 18.5, -20) && reaches(moves[7], 0, 15, -20));
  }

  // All forms of one chamfer, and of one rounding, where both moves go along an axis.
  void formsAreTheSame() {
    const std::string chamfer = "G1 Z-8. F0.2\nX24. Z-10.\nX40.\n";
    for (const char* const word : {",C2.", "C2.", "I2."})
      QVERIFY(isSamePath(std::string("G1 Z-10. ") + word + " F0.2\nX40.\n", chamfer));
    for (const char* const word : {",C2.", "C-2.", "K-2."})
      QVERIFY(isSamePath(std::string("G1 X40. ") + word + " F0.2\nZ-20.\n", "G1 X36. F0.2\nX40. Z0.\nZ-20.\n"));
    for (const char* const word : {",R2.", "R2."})
      QVERIFY(isSamePath(std::string("G1 Z-10. ") + word + " F0.2\nX40.\n",
                         "G1 Z-8. F0.2\nG2 X24. Z-10. I2. K0\nG1 X40.\n"));
    for (const char* const word : {",R2.", "R-2."})
      QVERIFY(isSamePath(std::string("G1 X40. ") + word + " F0.2\nZ-20.\n",
                         "G1 X36. F0.2\nG3 X40. Z0 I0 K-2.\nG1 Z-20.\n"));
  }

  // A cone of 3 : 4, so 5 mm long, that turns by an angle with the tangent of its half of 1/3 into a cylinder.
  void obliqueCorners() {
    const auto chamfer = cornerMoves("G1 Z0 F0.2\nX26. Z-4. ,C2.5\nZ-10.\n");
    QVERIFY(reaches(chamfer[2], 0, 11.5, -2) && reaches(chamfer[3], 0, 13, -6.5) && reaches(chamfer[4], 0, 13, -10));
    const auto round = cornerMoves("G1 Z0 F0.2\nX26. Z-4. ,R3.\nZ-10.\n");
    QVERIFY(reaches(round[2], 0, 12.4, -3.2) && reaches(round[3], 1, 13, -5) && reaches(round[4], 0, 13, -10));
    QVERIFY((round[3].centre - ProfilePoint(10, -5)).norm() < 1e-9);
  }

  // A cylinder of r 10 that meets a ball of r 5 around (10, -15) in a square corner. The centre of a rounding of 1 mm
  // is at r 11, and 6 mm from that of the ball: sqrt(35) right of it. A chamfer whose end is 1 mm from the corner,
  // measured straight, turns around the ball by an angle with a cosine of 1 - 1/50.
  void arcs() {
    const double z = -15.0 + std::sqrt(35.0);
    const auto round = cornerMoves("G1 Z-10. ,R1. F0.2\nG3 X30. Z-15. R5.\n");
    QVERIFY(reaches(round[1], 0, 10, z));
    QVERIFY(reaches(round[2], -1, 10.0 + 5.0 / 6.0, -15.0 + 5.0 / 6.0 * std::sqrt(35.0)));
    QVERIFY(reaches(round[3], 1, 15, -15) && (round[3].centre - ProfilePoint(10, -15)).norm() < 1e-6);
    const auto chamfer = cornerMoves("G1 Z-10. ,C1. F0.2\nG3 X30. Z-15. R5.\n");
    QVERIFY(reaches(chamfer[1], 0, 10, -9) && reaches(chamfer[2], 0, 10.0 + std::sqrt(0.99), -10.1));
    // The ball first: the mirror image about the line between both.
    const auto back = cornerMoves("G0 X30. Z-15.\nG2 X20. Z-10. R5. ,R1. F0.2\nG1 Z2.\n");
    QVERIFY(reaches(back[2], -1, 10.0 + 5.0 / 6.0, -15.0 + 5.0 / 6.0 * std::sqrt(35.0)));
    QVERIFY(reaches(back[3], 1, 10, z) && reaches(back[4], 0, 10, 2));
  }

  // Increments, and the centre of an arc, count from the corner, not from where the tool leaves the cut.
  void countsFromTheCorner() {
    QVERIFY(isSamePath("G1 W-12. ,C2. F0.2\nU20. ,R3.\nW-10.\n", "G1 Z-10. ,C2. F0.2\nX40. ,R3.\nZ-20.\n"));
    QVERIFY(isSamePath("G1 Z-10. ,R1. F0.2\nG3 U10. W-5. I0 K-5.\n", "G1 Z-10. ,R1. F0.2\nG3 X30. Z-15. R5.\n"));
  }

  // The next cut may be written with variables, and behind a line without a move.
  void nextCutIsComputed() {
    QVERIFY(isSamePath("#1=0\nG1 Z-10. ,C2. F0.2\n#1=#1+20.\n\nX[20.+#1]\n", "G1 Z-10. ,C2. F0.2\nX40.\n"));
    QVERIFY(isSamePath("#1=0\nWHILE[#1 LT 2]DO1\nG1 W-5. ,C1. F0.2\nU5.\n#1=#1+1\nEND1\n",
                       "G1 W-5. ,C1. F0.2\nU5.\nW-5. ,C1.\nU5.\n"));
  }

  // Two corners may take a whole cut: 4 mm between two roundings of 2 mm, and a quarter of a circle of 5 mm, of which
  // a rounding of 1 mm takes asin(1/6), and a chamfer with a straight length of 10 sin((90° - asin(1/6)) / 2) the rest.
  void cutsThatCornersTake() {
    const char* const pieces = "G1 Z-8. F0.2\nG2 X24. Z-10. I2. K0\nG3 X28. Z-12. I0 K-2.\nG1 Z-20.\n";
    QVERIFY(isSamePath("G1 Z-10. ,R2. F0.2\nX28. ,R2.\nZ-20.\n", pieces));
    const std::string cycle = "G0 X44. Z2.\nG71 U1.5 R0.5\nG71 P1 Q2 U0.4 W0.1 F0.2\nN1 G0 X20.\n";
    const std::string end = "N2 X44.\nG70 P1 Q2\n";
    QVERIFY(isSamePath(cycle + "G1 Z-10. ,R2. F0.2\nX28. ,R2.\nZ-20.\n" + end, cycle + pieces + end));
    const double chamfer = 10.0 * std::sin(0.5 * (M_PI_2 - std::asin(1.0 / 6.0)));
    const std::string size = std::to_string(chamfer - 1e-6);
    const auto arc = cornerMoves("G1 Z-10. ,R1. F0.2\nG3 X30. Z-15. R5. ,C" + size + "\nG1 X50.\n");
    QVERIFY(arc.size() >= 5 && arc.size() <= 6);
    for (const ToolMove& move : arc) QVERIFY(std::abs(sweepOf(move)) < M_PI_2);
    QVERIFY(reaches(arc.back(), 0, 25, -15));
  }

  // In the contour of a cycle a corner is the same as its piece.
  void contours() {
    const auto cycle = [](const std::string& cuts) {
      return "G0 X44. Z2.\nG71 U1.5 R0.5\nG71 P10 Q20 U0.4 W0.1 F0.2\nN10 G0 X10.\nG1 Z0\n" + cuts +
             "N20 X44.\nG70 P10 Q20\nG0 X60.\n";
    };
    QVERIFY(isSamePath(cycle("X20. ,C2. F0.1\nZ-10. ,R2.\nX30. K-1.\nZ-15.\n"),
                       cycle("X16. F0.1\nX20. Z-2.\nZ-8.\nG2 X24. Z-10. I2. K0\nG1 X28.\nX30. Z-11.\nZ-15.\n")));
  }

  void refuses_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("refusal");
    const auto row = [](const char* program, const char* refusal) {
      QTest::addRow("%s", qPrintable(QString(program).simplified())) << QString(program) << QString(refusal);
    };
    const char* const lonely = "4: ,C2: no cut follows that ends the corner. Write a G1, G2 or G3 in the next line.";
    row("G1 Z-10. ,C2. F0.2\nG0 X40.\n", lonely);
    row("G1 Z-10. ,C2. F0.2\nM30\n", lonely);
    row("G1 Z-10. ,C2. F0.2\n", lonely);
    row("G1 Z-10. ,R30. F0.2\nX40.\n",
        "4: ,R30: the two cuts form no corner, or are too short for this one. Use a smaller one.");
    row("G1 Z-10. ,C1. F0.2\nZ-20.\n",
        "4: ,C1: the two cuts form no corner, or are too short for this one. Use a smaller one.");
    row("G1 Z-10. I-2. F0.2\nX40.\n",
        "4: I-2: the next cut does not go in this direction, straight along the other axis. Correct its sign, or write "
        ",C or ,R.");
    row("G1 Z-10. R2. F0.2\nX40. Z-11.\n",
        "4: R2: the next cut does not go in this direction, straight along the other axis. Correct its sign, or write "
        ",C or ,R.");
    row("G1 X40. Z-10. R2. F0.2\nX50.\n",
        "4: R2: nothing in this line uses this word. Remove it, or add the code that it belongs to.");
    row("G1 X40. I2. F0.2\nZ-5.\n",
        "4: I2: nothing in this line uses this word. Remove it, or add the code that it belongs to.");
    row("G1 Z-10. ,C2. ,R1. F0.2\nX40.\n", "4: ,R1: it contradicts ,C2. Remove one of them.");
    row("G1 Z-10. ,C-2. F0.2\nX40.\n", "4: ,C-2: the size of a corner is not negative. Remove the sign.");
    row("G1 Z-10. ,A45. F0.2\nX40.\n", "4: ,A45.: only ,C and ,R follow a comma. Write the end of the move.");
    row("G0 Z-10. ,C2.\nG1 X40. F0.2\n",
        "4: ,C2: nothing in this line uses this word. Remove it, or add the code that it belongs to.");
    // The second corner of a cut has what the first one has left of it: 1 of 3 mm, and 82.6° of 90° - asin(1/6).
    const auto overlapping = [&](const char* program, const std::string& word) {
      row(program,
          ("5: " + word + ": the two cuts form no corner, or are too short for this one. Use a smaller one.").c_str());
    };
    overlapping("G1 Z-10. ,R2. F0.2\nX26. ,R2.\nZ-20.\n", ",R2");
    overlapping("G1 Z-10. ,C2. F0.2\nX26. ,C2.\nZ-20.\n", ",C2");
    overlapping("G1 Z-10. ,R2. F0.2\nX26. C-2.\nZ-20.\n", "C-2");
    overlapping("G1 Z-10. I2. F0.2\nX26. K-2.\nZ-20.\n", "K-2");
    overlapping("G1 Z-10. R2. F0.2\nX26. R-2.\nZ-20.\n", "R-2");
    overlapping("G1 Z-10. ,R1. F0.2\nG3 X30. Z-15. R5. ,C6.6\nG1 X50.\n", ",C6.6");
    row("G1 Z-10. ,R2. F0.2\n#5222=#5222-1.\nX40.\nZ-20.\n",
        "5: #5222: the coordinates cannot change between a corner and the cut that ends it. Set it before or after "
        "these lines.");
    row("G70 P1 Q2 F0.2\nM30\nN1 G0 X10.\nG1 Z-5.\n#5222=-1.\nN2 X40.\n",
        "8: #5222: the coordinates cannot change in the contour of a cycle. Set it before or after these lines.");
    row("G71 U1. R1.\nG71 P1 Q2 F0.2\nM30\nN1 G0 X10.\nN2 G1 Z-5. ,C1.\n",
        "8: ,C1: no cut follows that ends the corner. Write a G1, G2 or G3 in the next line.");
  }
  void refuses() {
    QFETCH(QString, program);
    QFETCH(QString, refusal);
    QCOMPARE(QString::fromStdString(kCornerTrial.refusalOf(kCornerBegin + program.toStdString())), refusal);
  }
};

HANDWHEEL_TEST(FanucCornersTest)
#include "FanucCornersTest.moc"
