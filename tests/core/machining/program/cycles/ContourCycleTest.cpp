// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/cycles/ContourCycle.h"

#include "../ProgramTrial.h"
#include "TestClass.h"

#include <QtTest>
#include <algorithm>
#include <functional>
#include <sstream>

using namespace handwheel;
using test::ProgramTrial;

namespace {

// One line of a contour: G1, or an arc G2 or G3 with its radius.
struct ContourLine {
  int code = 1;
  ProfilePoint to;
  double radius = 0.0;
};

// A round shoulder, a round groove, a round rib that leaves a pocket behind it, and a shoulder: from r 5, z 0 on.
const std::vector<ContourLine> kRoundContour = {{1, {5, -5}, 0},  {3, {9, -9}, 4},  {1, {9, -12}, 0},
                                                {2, {9, -18}, 3}, {1, {9, -20}, 0}, {3, {9, -26}, 3},
                                                {1, {9, -30}, 0}, {1, {20, -30}, 0}};

double radiusOfRoundContour(double z) {
  const auto bulge = [z](double middle, double radius) {
    return std::sqrt(std::max(0.0, radius * radius - (z - middle) * (z - middle)));
  };
  if (z > -5) return 5;
  if (z > -9) return 5 + bulge(-9, 4);
  if (z < -12 && z > -18) return 9 - bulge(-15, 3);
  if (z < -20 && z > -26) return 9 + bulge(-23, 3);
  return 9;
}

// The radius for a tool that only climbs.
double radiusWithoutPockets(double z) {
  double most = 0.0;
  for (double there = 0.0; there > z; there -= 0.01) most = std::max(most, radiusOfRoundContour(there));
  return std::max(most, radiusOfRoundContour(z));
}

using ProgramShift = std::function<ProfilePoint(const ProfilePoint&)>;

ProfilePoint unchanged(const ProfilePoint& p) {
  return p;
}

std::string wordsOf(const ProfilePoint& p) {
  std::ostringstream text;
  text << " X" << p.x() << " Z" << p.y();
  return text.str();
}

// A program of one cycle, whose contour and start are displaced, mirrored or not.
std::string contourProgram(const std::string& cycle, const std::vector<ContourLine>& contour,
                           const ProgramShift& change = unchanged, bool isMirrored = false) {
  std::ostringstream text;
  text << "F9\no1 sub\nG0" << wordsOf(change({5, 0})) << "\n";
  for (const ContourLine& line : contour) {
    text << "G" << (isMirrored && line.code > 1 ? 5 - line.code : line.code) << wordsOf(change(line.to));
    if (line.code > 1) text << " R" << line.radius;
    text << "\n";
  }
  const ProfilePoint start = change({25, 2});
  text << "o1 endsub\nG0" << wordsOf(start) << "\n" << cycle << wordsOf(start) << "\n";
  return text.str();
}

// The least radius that the tip comes to at this height; the end faces of moves that do not pass it do not count.
double leastRadiusAt(const std::vector<ToolMove>& moves, double z) {
  constexpr int kPieces = 500;
  double least = 1e9;
  for (const ToolMove& move : moves) {
    const int pieces = move.turn == 0 ? 1 : kPieces;
    for (int i = 0; i < pieces; ++i) {
      const ProfilePoint a = pointOn(move, double(i) / pieces), b = pointOn(move, double(i + 1) / pieces);
      if (std::min(a.y(), b.y()) > z || std::max(a.y(), b.y()) < z || a.y() == b.y()) continue;
      least = std::min(least, a.x() + (z - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  }
  return least;
}

// Heights of the contour, none of which is that of a corner.
std::vector<double> heightsAlong() {
  std::vector<double> all;
  for (double z = -0.0511; z > -29.9; z -= 0.0937) all.push_back(z);
  return all;
}

}  // namespace

// Cycles along a contour, by the part that they leave: LinuxCNC, "Lathe Roughing Cycles". X is a radius.
class ContourCycleTest : public QObject {
  Q_OBJECT

 private slots:
  // Down to the contour everywhere, and nowhere below it.
  void roughsPocketsToo() {
    const auto moves = ProgramTrial().movesOf(contourProgram("G71 Q1 I2 R0.5", kRoundContour));
    for (const double z : heightsAlong()) {
      const double left = leastRadiusAt(moves, z) - radiusOfRoundContour(z);
      QVERIFY2(std::abs(left) < 1e-3, qPrintable(QString("z %1: %2").arg(z).arg(left)));
    }
  }

  // G71.1 leaves pockets behind a higher point; G71.2 cuts these alone.
  void leavesPocketsForLater() {
    const auto before = ProgramTrial().movesOf(contourProgram("G71.1 Q1 I2 R0.5", kRoundContour));
    const auto after = ProgramTrial().movesOf(contourProgram("G71.2 Q1 I2 R0.5", kRoundContour));
    for (const double z : heightsAlong()) {
      const double first = leastRadiusAt(before, z), second = leastRadiusAt(after, z), wanted = radiusOfRoundContour(z);
      const double left = first - radiusWithoutPockets(z);
      QVERIFY2(std::abs(left) < 2e-3, qPrintable(QString("z %1: %2").arg(z).arg(left)));
      QVERIFY2(second > wanted - 1e-3, qPrintable(QString("z %1: %2").arg(z).arg(second)));
      QVERIFY2(std::abs(std::min(first, second) - wanted) < 2e-3, qPrintable(QString("z %1").arg(z)));
    }
  }

  // A level is at most as deep as it is asked for: at any height the radii of the cuts along z are 2 mm apart or less.
  void levelsAreNotTooDeep() {
    const auto moves = ProgramTrial().movesOf(contourProgram("G71 Q1 I2 R0.5", kRoundContour));
    for (const double z : {-1.0, -8.0, -15.0, -23.5, -28.0}) {
      std::vector<double> radii{20.0, radiusOfRoundContour(z)};
      for (const ToolMove& m : moves)
        if (m.kind == ToolMove::Kind::Feed && m.from.x() == m.to.x() && m.from.y() > z && m.to.y() < z)
          radii.push_back(m.to.x());
      std::sort(radii.begin(), radii.end());
      for (std::size_t i = 1; i < radii.size(); ++i) QVERIFY(radii[i] - radii[i - 1] < 2.0 + 1e-9);
    }
  }

  // The contour from the other side, from the inside, and across, as of G72: the same moves there.
  void otherSidesAreMirrored_data() {
    QTest::addColumn<QString>("cycle");
    QTest::addColumn<int>("side");
    for (const char* const cycle :
         {"1 Q1 I2 R0.5", "1 Q1 D0.4 I1.5", "1.1 Q1 I2", "1.2 Q1 I2", "0 Q1", "0 Q1 D0.6 E0.2 P3"})
      for (const int side : {1, 2, 3}) QTest::addRow("G7%s, side %d", cycle, side) << QString(cycle) << side;
  }
  void otherSidesAreMirrored() {
    QFETCH(QString, cycle);
    QFETCH(int, side);
    const ProgramShift change = [side](const ProfilePoint& p) -> ProfilePoint {
      if (side == 1) return {p.x(), -p.y()};
      if (side == 2) return {30.0 - p.x(), p.y()};
      return {p.y() + 40.0, p.x() - 40.0};
    };
    const std::string words = cycle.toStdString();
    const bool isAcross = side == 3 && !words.starts_with("0");
    const auto moves = ProgramTrial().movesOf(contourProgram("G7" + words, kRoundContour));
    const auto other = ProgramTrial().movesOf(
        contourProgram("G7" + (isAcross ? "2" + words.substr(1) : words), kRoundContour, change, true));
    QVERIFY(moves.size() > 5);
    QCOMPARE(other.size(), moves.size());
    for (std::size_t i = 0; i < moves.size(); ++i) {
      QVERIFY((other[i].to - change(moves[i].to)).norm() < 1e-6);
      QVERIFY(other[i].kind == moves[i].kind && other[i].turn == -moves[i].turn);
      if (moves[i].turn != 0) QVERIFY((other[i].centre - change(moves[i].centre)).norm() < 1e-6);
    }
  }

  // Finishing passes keep the distance that is asked for: the last one E, those before evenly less than D.
  void finishesAtTheAllowance() {
    const auto moves = ProgramTrial().movesOf(contourProgram("G70 Q1 D0.5 E0.5", kRoundContour));
    for (const double z : {-2.0, -10.5, -19.0 + 0.123, -28.0})
      QVERIFY(std::abs(leastRadiusAt(moves, z) - radiusOfRoundContour(z) - 0.5) < 1e-3);
    QVERIFY(std::abs(leastRadiusAt(moves, -15.0) - 6.5) < 1e-3);  // bottom of the groove, its radius 2.5 mm
    QVERIFY(std::abs(leastRadiusAt(moves, -23.0) - 12.5) < 1e-3);
  }

  // A square groove of 0.5 mm has room for an allowance of 0.2 mm on both walls, not for one of 0.3 mm.
  void theAllowanceFitsIntoTheContour() {
    const std::vector<ContourLine> groove = {{1, {10, -5}, 0},   {1, {10, -10}, 0},   {1, {8, -10}, 0},
                                             {1, {8, -10.5}, 0}, {1, {10, -10.5}, 0}, {1, {10, -20}, 0},
                                             {1, {20, -20}, 0}};
    const auto moves = ProgramTrial().movesOf(contourProgram("G70 Q1 D0.2 E0.2", groove));
    QVERIFY(std::abs(leastRadiusAt(moves, -10.25) - 8.2) < 1e-9);
    // Nowhere in the groove is 0.3 mm from both of its upper corners: there the path stays outside.
    const auto wider = ProgramTrial().movesOf(contourProgram("G70 Q1 D0.3 E0.3", groove));
    QVERIFY(leastRadiusAt(wider, -10.25) > 10.0 + std::sqrt(0.3 * 0.3 - 0.25 * 0.25) - 1e-9);
    // A fillet of 1 mm alone, and an allowance of 2 mm: nothing is left of it.
    const std::string none = ProgramTrial().refusalOf(contourProgram("G71 Q1 D2 I1", {{2, {6, -1}, 1}}));
    QVERIFY2(none.find("the allowance does not fit into the contour") != std::string::npos, none.c_str());
  }

  // A corner is where two lines meet: those that go straight on have none.
  void straightLinesHaveNoCorner() {
    const std::string program =
        "F9\no1 sub\nG0 X5 Z0\nG1 X6 Z-5 A0.5\nX7 Z-10\nX9\no1 endsub\nG0 X25 Z2\nG71 Q1 X25 Z2\n";
    QVERIFY(ProgramTrial().refusalOf(program).find("a corner cannot be rounded or chamfered") != std::string::npos);
  }
};

HANDWHEEL_TEST(ContourCycleTest)
#include "ContourCycleTest.moc"
