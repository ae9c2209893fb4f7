// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ToolPath.h"

#include "TestClass.h"
#include "machining/program/ProgramTimeline.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

ToolMove pathMove(const ProfilePoint& from, const ProfilePoint& to, int turn = 0, const ProfilePoint& centre = {0, 0}) {
  ToolMove move;
  move.kind = ToolMove::Kind::Feed;
  move.turn = static_cast<std::int8_t>(turn);
  move.from = from;
  move.to = to;
  move.centre = centre;
  return move;
}

bool isNearPathPoint(const ProfilePoint& a, const ProfilePoint& b) {
  return (a - b).norm() < 1e-12;
}

}  // namespace

// Lines and arcs of tool paths. Points are (r, z); counter-clockwise is from +z to +r.
class ToolPathTest : public QObject {
  Q_OBJECT

 private slots:
  void directionsOfLines() {
    QVERIFY(isNearPathPoint(directionOf(pathMove({1, 1}, {4, 5}), 0.3), {0.6, 0.8}));
    QVERIFY(directionOf(pathMove({1, 1}, {1, 1}), 0.3).isZero());
  }

  // A quarter from (0, 2) to (2, 0) about the origin: it begins along +r and ends along -z; in the other sense it is
  // three quarters, and begins along -r.
  void directionsOfArcs() {
    const ToolMove left = pathMove({0, 2}, {2, 0}, 1), right = pathMove({0, 2}, {2, 0}, -1);
    QVERIFY(isNearPathPoint(directionOf(left, 0.0), {1, 0}) && isNearPathPoint(directionOf(left, 1.0), {0, -1}));
    QVERIFY(isNearPathPoint(directionOf(left, 0.5), {std::sqrt(0.5), -std::sqrt(0.5)}));
    QVERIFY(isNearPathPoint(directionOf(right, 0.0), {-1, 0}) && isNearPathPoint(directionOf(right, 1.0), {0, 1}));
    QVERIFY(directionOf(pathMove({0, 0}, {0, 0}, 1), 0.0).isZero());
    QVERIFY(std::abs(lengthOf(left) - M_PI) < 1e-12 && std::abs(lengthOf(right) - 3.0 * M_PI) < 1e-12);
  }

  // The direction is the derivative of the position.
  void directionsAreTangents() {
    const ToolMove arc = pathMove({5, 1}, {2, 4}, -1, {2, 1});
    for (const double t : {0.1, 0.4, 0.8}) {
      const ProfilePoint displacement = pointOn(arc, t + 1e-6) - pointOn(arc, t - 1e-6);
      QVERIFY((displacement.normalized() - directionOf(arc, t)).norm() < 1e-6);
    }
  }

  // Two moves of 1 s and 2 s; without moves there is no time.
  void timelines() {
    ToolPath path;
    QCOMPARE(ProgramTimeline(path).duration(), 0.0);
    path.moves = {pathMove({0, 0}, {0, 1}), pathMove({0, 1}, {0, 3})};
    path.moves[0].time = 1.0;
    path.moves[1].time = 2.0;
    const ProgramTimeline line(path);
    QCOMPARE(line.duration(), 3.0);
    QVERIFY(isNearPathPoint(line.tipAt(line.at(2.0)), {0, 2}));
  }
};

HANDWHEEL_TEST(ToolPathTest)
#include "ToolPathTest.moc"
