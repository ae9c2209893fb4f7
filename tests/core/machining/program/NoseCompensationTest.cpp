// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/NoseCompensation.h"

#include "TestClass.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

using NoseStep = NoseCompensation::Step;

constexpr double kNose = 1.0;  // mm

NoseStep noseLine(const PlanePoint& to) {
  NoseStep step;
  step.modal.kind = ToolMove::Kind::Feed;
  step.to = to;
  step.location = {7, 3};
  return step;
}

NoseStep noseArc(int turn, const PlanePoint& to, const PlanePoint& centre) {
  NoseStep step = noseLine(to);
  step.modal.turn = static_cast<std::int8_t>(turn);
  step.centre = centre;
  return step;
}

struct NoseControl {
  ProgramDialect dialect = ProgramDialect::LinuxCnc;
  bool isInch = false;
};

// Returns the moves of the tip. tip: from the centre of the nose, (r, z) in radii.
std::vector<NoseStep> noseMoves(int side, const PlanePoint& at, const std::vector<NoseStep>& contour,
                                const ProfilePoint& tip = {0, 0}, NoseControl control = {}) {
  std::vector<NoseStep> emitted;
  NoseCompensation nose(control.dialect, [&](const NoseStep& step) { emitted.push_back(step); });
  nose.begin(side, kNose, tip, at, control.isInch);
  for (const NoseStep& step : contour) nose.move(step);
  const PlanePoint end = nose.end();
  if (!contour.empty() && end != contour.back().to) {
    qWarning("the nose does not end where the contour does");
    emitted.clear();
  }
  return emitted;
}

std::string noseRefusal(int side, const PlanePoint& at, const std::vector<NoseStep>& contour,
                        NoseControl control = {}) {
  try {
    noseMoves(side, at, contour, {0, 0}, control);
  } catch (const ProgramRefusal& refusal) {
    return refusal.error.position.value == 7 ? refusal.error.arguments.at(2) : "another line";
  }
  return {};
}

bool isSameNosePosition(const PlanePoint& a, const PlanePoint& b) {
  return std::abs(a - b) < 1e-9;
}

}  // namespace

// The path of a nose of 1 mm beside lines and arcs. In the plane z is the real and r the imaginary axis.
class NoseCompensationTest : public QObject {
  Q_OBJECT

 private slots:
  // A quarter about 10i from 0 to 10 + 10i, the nose inside: it ends at 9 + 10i, square to the contour, so its centre c
  // is on that height and as far from both ends: c² + 10² = (9 - c)². Outside it ends at 11 + 10i.
  void theFirstMoveMayBeAnArc_data() {
    QTest::addColumn<int>("side");
    QTest::addColumn<double>("end");
    QTest::addColumn<double>("centre");
    QTest::newRow("inside") << 1 << 9.0 << -19.0 / 18.0;
    QTest::newRow("outside") << -1 << 11.0 << 21.0 / 22.0;
  }
  void theFirstMoveMayBeAnArc() {
    QFETCH(int, side);
    QFETCH(double, end);
    QFETCH(double, centre);
    const NoseStep quarter = noseArc(1, {10, 10}, {0, 10});
    const auto moves = noseMoves(side, {0, 0}, {quarter});
    QCOMPARE(moves.size(), std::size_t{1});
    QVERIFY(isSameNosePosition(moves[0].to, {end, 10}) && isSameNosePosition(moves[0].centre, {centre, 10}));
    QCOMPARE(int(moves[0].modal.turn), 1);
    // A tip towards axis and chuck follows the same path beside it; it is there after a straight move.
    const PlanePoint tip(-kNose, -kNose);
    const auto tipped = noseMoves(side, {0, 0}, {quarter}, {-1, -1});
    QCOMPARE(tipped.size(), std::size_t{2});
    QVERIFY(tipped[0].modal.turn == 0 && isSameNosePosition(tipped[0].to, tip));
    QVERIFY(isSameNosePosition(tipped[1].to, moves[0].to + tip) &&
            isSameNosePosition(tipped[1].centre, moves[0].centre + tip));
  }

  void theFirstMoveIsLongerThanTheNose() {
    QCOMPARE(noseRefusal(1, {0, 0}, {noseLine({0.6, 0.8})}),
             std::string("the first move is not longer than the nose radius"));
    QCOMPARE(noseRefusal(1, {0, 0}, {noseArc(1, {0.5, 0.5}, {0, 0.5})}),
             std::string("the first arc is not longer than the nose radius"));
    QCOMPARE(noseRefusal(1, {0, 0}, {noseLine({0.61, 0.8})}), std::string());
  }

  // To 9 + 10i from straight below no arc comes that ends square to that height.
  void anEntryWithoutAnArcIsRefused() {
    QVERIFY(noseRefusal(1, {9, 0}, {noseArc(1, {10, 10}, {0, 10})}).find("does not fit") != std::string::npos);
  }

  // A move to where the contour is already changes nothing.
  void movesOfNoLength() {
    const auto moves = noseMoves(1, {-20, 0},
                                 {noseLine({-10, 0}), noseLine({0, 0}), noseLine({0, 0}), noseLine({0, 10}),
                                  noseLine({0, 10}), noseLine({-9, 10})});
    std::vector<PlanePoint> positions;
    for (const NoseStep& move : moves)
      if (positions.empty() || !isSameNosePosition(positions.back(), move.to)) positions.push_back(move.to);
    const std::vector<PlanePoint> expected = {{-10, 1}, {-1, 1}, {-1, 9}, {-9, 9}};
    QCOMPARE(positions.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) QVERIFY(isSameNosePosition(positions[i], expected[i]));
  }

  // A line along +z, then an arc of 10 mm that leaves at 45° to the side of the nose: the corner is on the line at 1 mm
  // and on the circle that is 1 mm smaller or larger.
  void cornersFromLineToArc_data() {
    QTest::addColumn<int>("turn");
    QTest::newRow("inside") << 1;
    QTest::newRow("outside") << -1;
  }
  void cornersFromLineToArc() {
    QFETCH(int, turn);
    const PlanePoint centre = std::polar(10.0, M_PI / 4 + turn * M_PI_2);
    const PlanePoint to = centre + std::polar(1.0, turn * 0.5) * (PlanePoint(0, 0) - centre);
    const auto moves = noseMoves(1, {-30, 0}, {noseLine({-20, 0}), noseLine({0, 0}), noseArc(turn, to, centre)});
    QCOMPARE(moves.size(), std::size_t{3});
    const PlanePoint corner = moves[1].to;
    QVERIFY(std::abs(corner.imag() - kNose) < 1e-9 && std::abs(corner) < 2.0 * kNose);
    QVERIFY(std::abs(std::abs(corner - centre) - (10.0 - turn * kNose)) < 1e-9);
    QVERIFY(std::abs(std::abs(moves[2].to - to) - kNose) < 1e-9 && isSameNosePosition(moves[2].centre, centre));
  }

  // The same between two arcs of 10 mm: the first arrives along +z. The corner is on both circles.
  void cornersBetweenArcs_data() {
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("second");
    for (const int first : {1, -1})
      for (const int second : {1, -1}) QTest::addRow("%d, %d", first, second) << first << second;
  }
  void cornersBetweenArcs() {
    QFETCH(int, first);
    QFETCH(int, second);
    const PlanePoint before(0, 10.0 * first), after = std::polar(10.0, M_PI / 4 + second * M_PI_2);
    const PlanePoint from = before + std::polar(1.0, -first * 1.0) * -before,
                     to = after + std::polar(1.0, second * 0.5) * -after;
    const PlanePoint along = PlanePoint(0, first) * (from - before) / 10.0;  // in the direction in which the arc begins
    const auto moves =
        noseMoves(1, from - 20.0 * along, {noseLine(from), noseArc(first, {0, 0}, before), noseArc(second, to, after)});
    QCOMPARE(moves.size(), std::size_t{3});
    const PlanePoint corner = moves[1].to;
    QVERIFY(std::abs(corner) < 2.0 * kNose);
    QVERIFY(std::abs(std::abs(corner - before) - (10.0 - first * kNose)) < 1e-9);
    QVERIFY(std::abs(std::abs(corner - after) - (10.0 - second * kNose)) < 1e-9);
  }

  // A line that points away from +z by an angle, then an arc of 2 mm along +z, the nose inside. The corner is convex
  // and flatter than 0.05 rad, so the arc of the nose, of 1 mm, begins at the end of the line. It grows by 1 mm times
  // the angle, over its radius of 1 mm. LinuxCNC 2.9 takes 0.0254 rad of that in mm and 0.001 rad in inches (rs274).
  void nearlyTangentArcs_data() {
    QTest::addColumn<double>("angle");
    QTest::addColumn<bool>("isTaken");
    QTest::addColumn<bool>("isTakenInInches");
    QTest::newRow("tangent") << 0.0 << true << true;
    QTest::newRow("0.0009") << 0.0009 << true << true;
    QTest::newRow("0.002") << 0.002 << true << false;
    QTest::newRow("0.025") << 0.025 << true << false;
    QTest::newRow("0.026") << 0.026 << false << false;
    QTest::newRow("0.049") << 0.049 << false << false;
  }
  void nearlyTangentArcs() {
    QFETCH(double, angle);
    QFETCH(bool, isTaken);
    QFETCH(bool, isTakenInInches);
    const PlanePoint along = std::polar(5.0, angle), corner = PlanePoint(0, 0), centre(0, 2);
    const std::vector<NoseStep> contour = {noseLine(corner - along), noseLine(corner),
                                           noseArc(1, centre + PlanePoint(2, 0), centre)};
    const PlanePoint at = corner - 3.0 * along;
    QCOMPARE(noseRefusal(1, at, contour).empty(), isTaken);
    QCOMPARE(noseRefusal(1, at, contour, {ProgramDialect::LinuxCnc, true}).empty(), isTakenInInches);
    const auto moves = noseMoves(1, at, contour, {0, 0}, {ProgramDialect::Fanuc, false});
    QCOMPARE(moves.size(), std::size_t{3});
    QVERIFY(isSameNosePosition(moves[1].to, std::polar(kNose, M_PI_2 + angle)));
    QVERIFY(isSameNosePosition(moves[2].to, {1, 2}) && isSameNosePosition(moves[2].centre, centre));
  }
};

HANDWHEEL_TEST(NoseCompensationTest)
#include "NoseCompensationTest.moc"
