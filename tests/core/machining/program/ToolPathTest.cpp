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

  // A face from 22 mm over the axis to -0.8 mm at 0.2 mm and 150 m/min, at most 6000 r/min, which begin at 3.979 mm:
  // (2 pi / 150000) (22² - 3.979²) / 2 min, and 4.779 mm / 6000 r/min, each over 0.2 mm: 3.18053 s. Its outer half, to
  // 10.6 mm, takes pi (22² - 10.6²) / 150000 / 0.2 min = 2.33509 s at a mean speed of 11.4 mm / 0.2 mm in that time.
  void facesAtConstantSurfaceSpeed() {
    ToolMove face = pathMove({22, 0}, {-0.8, 0});
    face.spin = 1;
    face.feed = 0.2;
    face.isPerRevolution = face.isSurfaceSpeed = true;
    face.spindle = 150.0;
    face.mostSpindle = 6000.0;
    face.time = durationOf(face, 5000.0);
    QVERIFY2(std::abs(face.time - 3.18053) < 1e-5, qPrintable(QString::number(face.time, 'g', 9)));
    QVERIFY(std::abs(timeOf(face, {0.0, 0.5}) - 2.33509) < 1e-5);
    QVERIFY(std::abs(timeOf(face, {0.0, 0.5}) + timeOf(face, {0.5, 1.0}) - face.time) < 1e-9);
    QVERIFY(std::abs(spindleOf(face, {0.0, 0.5}) - 57.0 / 2.33509 * 60.0) < 0.01);
    QVERIFY(std::abs(lengthAfter(face, 2.33509 / 3.18053) - 0.5) < 1e-5);
    ToolPath path;
    path.moves = {face};
    QVERIFY(std::abs(ProgramTimeline(path).tipAt(ProgramTimeline(path).at(2.33509)).x() - 10.6) < 1e-4);
    // Along a cylinder and around an arc: pi / 2 of 10 mm about 20 mm from 10 to 20 mm over the axis.
    ToolMove along = face;
    along.from = {20, 0};
    along.to = {20, -30};
    QVERIFY(std::abs(durationOf(along, 5000.0) - 30.0 / 0.2 / (150000.0 / (40.0 * M_PI)) * 60.0) < 1e-9);
    ToolMove arc = face;
    arc.from = {10, 0};
    arc.centre = {20, 0};
    arc.to = {20, 10};
    arc.turn = 1;
    // The mean radius on the arc is 20 - 10 · 2 / pi mm.
    const double expected = 5.0 * M_PI / 0.2 * 2.0 * M_PI * (20.0 - 20.0 / M_PI) / 150000.0 * 60.0;
    QVERIFY2(std::abs(durationOf(arc, 5000.0) / expected - 1.0) < 1e-4, qPrintable(QString::number(expected)));
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
