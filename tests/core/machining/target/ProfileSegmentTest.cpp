// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/ProfileSegment.h"

#include "AnyProfile.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;
using test::anySegment;
using test::evenly;

namespace {

bool isSame(const ProfilePoint& a, const ProfilePoint& b, double slack = 1e-9) {
  return (a - b).norm() <= slack;
}

}  // namespace

class ProfileSegmentTest : public QObject {
  Q_OBJECT

 private slots:
  void aQuarterCircle() {
    const ProfileSegment arc = arcAround({3.0, 4.0}, 2.0, 0.0, M_PI / 2);
    QVERIFY(isSame(arc.from, {5.0, 4.0}) && isSame(arc.to, {3.0, 6.0}));
    QVERIFY(std::abs(arc.radius() - 2.0) < 1e-14 && isSame(arc.centre(), {3.0, 4.0}, 1e-14));
    QVERIFY(std::abs(arc.length() - M_PI) < 1e-14);
    QVERIFY(isSame(arc.at(0.5), {3.0 + std::sqrt(2.0), 4.0 + std::sqrt(2.0)}, 1e-14));
    QVERIFY(isSame(arc.direction(0.0), {0.0, 1.0}, 1e-14) && isSame(arc.direction(1.0), {-1.0, 0.0}, 1e-14));
    QVERIFY(isSame(arc.reversed().at(0.25), arc.at(0.75), 1e-14));
    QVERIFY(isSame(arc.box().max(), {5.0, 6.0}, 1e-14));
    QVERIFY(isSame(arcAround({0, 0}, 1.0, -2.0, 2.0).box().max(), {1.0, 1.0}, 1e-14));
  }

  void aLine() {
    const ProfileSegment line{{0.0, 0.0}, {3.0, 4.0}, 0.0};
    QCOMPARE(line.length(), 5.0);
    QVERIFY(std::isinf(line.radius()));
    QVERIFY(isSame(line.at(0.5), {1.5, 2.0}) && isSame(line.nearest({-1.0, -1.0}), {0.0, 0.0}));
  }

  // Arcs of almost no rise are as exact as lines.
  void flatArcs() {
    for (const double bulge : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 5e-324}) {
      const ProfileSegment arc{{10.0, 0.0}, {10.0, 100.0}, bulge};
      QVERIFY(std::abs(arc.length() - 100.0) < 100.0 * bulge * bulge * 3.0 + 1e-12);
      QVERIFY(isSame(arc.at(0.5), {10.0 + 50.0 * bulge, 50.0}, 1e-9));
      QVERIFY(isSame(arc.nearest({10.0, 50.0}), arc.at(0.5), 1e-6));
      // The moment is that of the frustum of radius 10, but for the sliver.
      QVERIFY(std::abs(arc.squareMoment() - 1e4) < 1e5 * bulge + 1e-8);
    }
  }

  void pointsAndDirections() {
    QVERIFY(rc::check("every point is at the radius; the direction is the derivative", [] {
      const ProfileSegment s = anySegment(50.0);
      RC_PRE(s.length() > 1e-3);
      const double t = evenly(0.01, 0.99), h = 1e-6;
      if (s.isArc()) RC_ASSERT(std::abs((s.at(t) - s.centre()).norm() - s.radius()) < 1e-9 * (1.0 + s.radius()));
      const ProfilePoint slope = (s.at(t + h) - s.at(t - h)) / (2.0 * h * s.length());
      RC_ASSERT(isSame(slope, s.direction(t), 1e-6));
    }));
  }

  void nearestByDefinition() {
    QVERIFY(rc::check("no sampled point is nearer, and it is on the segment", [] {
      const ProfileSegment s = anySegment(50.0);
      const ProfilePoint p(evenly(-80.0, 80.0), evenly(-80.0, 80.0));
      const double found = (s.nearest(p) - p).norm();
      double least = HUGE_VAL;
      for (int i = 0; i <= 2000; ++i) least = std::min(least, (s.at(i / 2000.0) - p).norm());
      RC_ASSERT(found <= least + 1e-9);
      RC_ASSERT(found >= least - s.length() / 2000.0);
      RC_ASSERT(s.box().exteriorDistance(s.nearest(p)) < 1e-9);
    }));
  }

  void piecesAddUp() {
    QVERIFY(rc::check("lengths and moments of two pieces are those of the whole", [] {
      const ProfileSegment s = anySegment(20.0);
      const double t = evenly(0.05, 0.95);
      const ProfileSegment a = s.piece(0.0, t), b = s.piece(t, 1.0);
      RC_ASSERT(isSame(a.to, b.from));
      RC_ASSERT(std::abs(a.length() + b.length() - s.length()) < 1e-9 * (1.0 + s.length()));
      const double scale = 1e-10 * std::pow(1.0 + 100.0 + s.length(), 3.0);
      RC_ASSERT(std::abs(a.squareMoment() + b.squareMoment() - s.squareMoment()) < scale);
    }));
  }

  // By Pappus and by the formulas of cone and sphere.
  void momentsOfKnownBodies() {
    const ProfileSegment cone{{3.0, 0.0}, {1.0, 6.0}, 0.0};
    QVERIFY(std::abs(M_PI * cone.squareMoment() - M_PI * 6.0 / 3.0 * (9.0 + 3.0 + 1.0)) < 1e-12);
    const ProfileSegment ball = arcAround({0.0, 7.0}, 5.0, -M_PI / 2, M_PI / 2);
    QVERIFY(std::abs(M_PI * ball.squareMoment() - 4.0 / 3.0 * M_PI * 125.0) < 1e-9);
    const double torus = M_PI * (arcAround({10.0, 0.0}, 2.0, 0.0, M_PI).squareMoment() +
                                 arcAround({10.0, 0.0}, 2.0, M_PI, 2 * M_PI).squareMoment());
    QVERIFY(std::abs(torus - 2.0 * M_PI * M_PI * 10.0 * 4.0) < 1e-9);
  }

  void arcsThroughThreePoints() {
    QVERIFY(rc::check("an arc is found again", [] {
      const ProfileSegment s = anySegment(50.0);
      RC_PRE(s.isArc() && s.length() > 1.0 && (s.to - s.from).norm() > 1.0);
      const auto again = arcThrough(s.from, s.at(evenly(0.2, 0.8)), s.to);
      RC_ASSERT(again.has_value());
      RC_ASSERT(std::abs(again->angle() - s.angle()) < 1e-7);
    }));
    QVERIFY(!arcThrough({1, 1}, {1, 1}, {2, 2}));
    QVERIFY(!arcThrough({1, 1}, {0, 1}, {1, 1}));
    QCOMPARE(arcThrough({0, 0}, {1, 1}, {2, 2})->bulge, 0.0);
  }

  void meetings() {
    const ProfileSegment line{{0.0, 0.0}, {10.0, 0.0}, 0.0};
    QVERIFY(isSame(*meeting(line, {{5.0, -1.0}, {5.0, 1.0}, 0.0}, 1e-6), {5.0, 0.0}));
    QVERIFY(!meeting(line, {{5.0, 1e-5}, {5.0, 1.0}, 0.0}, 1e-6));
    QVERIFY(meeting(line, {{9.0, 0.0}, {20.0, 0.0}, 0.0}, 1e-6));          // they overlap
    QVERIFY(meeting(line, arcAround({5.0, 3.0}, 3.0, -M_PI, 0.0), 1e-6));  // tangent
    QVERIFY(!meeting(line, arcAround({5.0, 3.0}, 3.0, 0.0, M_PI), 1e-6));  // the other half
    QVERIFY(meeting(arcAround({0, 0}, 2.0, -1.0, 1.0), arcAround({3, 0}, 2.0, 2.0, 4.0), 1e-6));
    QVERIFY(!meeting(arcAround({0, 0}, 2.0, -1.0, 1.0), arcAround({0, 0}, 1.0, -1.0, 1.0), 1e-6));
    // Neighbours share an end, which does not count; turning back does.
    QVERIFY(!meetingBeside(line, {{10.0, 0.0}, {10.0, 5.0}, 0.0}, 1e-6));
    QVERIFY(!meetingBeside(line, arcAround({10.0, 4.0}, 4.0, -M_PI / 2, 0.5), 1e-6));  // a tangent fillet
    QVERIFY(meetingBeside(line, {{10.0, 0.0}, {2.0, 0.0}, 0.0}, 1e-6));
    // An arc that comes back through the line.
    QVERIFY(meetingBeside(line, arcAround({8.0, 1.0}, std::sqrt(5.0), std::atan2(-1.0, 2.0), M_PI + 0.6), 1e-6));
  }
};

HANDWHEEL_TEST(ProfileSegmentTest)
#include "ProfileSegmentTest.moc"
