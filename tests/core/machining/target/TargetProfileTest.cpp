// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/TargetProfile.h"

#include "AnyProfile.h"
#include "TestClass.h"
#include "machining/target/TargetErrors.h"
#include "machining/target/files/Drawing.h"

#include <QtTest>
#include <limits>

using namespace handwheel;
using test::anyShaft;
using test::evenly;

namespace {

using Segments = std::vector<ProfileSegment>;

Segments through(const std::vector<ProfilePoint>& points) {
  Segments all;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) all.push_back({points[i], points[i + 1], 0.0});
  return all;
}

Segments turnedRound(Segments all) {
  std::reverse(all.begin(), all.end());
  for (ProfileSegment& s : all) s = s.reversed();
  return all;
}

ErrorCode refusal(Segments segments) {
  const auto made = TargetProfile::make(std::move(segments));
  return made ? ErrorCode() : made.error().code;
}

// Returns true if a point is in the material, by the crossings of a ray outwards with densely sampled chords.
bool isInside(const TargetProfile& profile, const ProfilePoint& p) {
  int crossings = 0;
  for (const ProfileSegment& s : profile.segments()) {
    const int pieces = s.isArc() ? 500 : 1;
    for (int i = 0; i < pieces; ++i) {
      const ProfilePoint a = s.at(double(i) / pieces), b = s.at(double(i + 1) / pieces);
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      const double r = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      crossings += r > p.x() ? 1 : 0;
    }
  }
  return crossings % 2 == 1;
}

}  // namespace

class TargetProfileTest : public QObject {
  Q_OBJECT

 private slots:
  // Diagonals that are long and nearly parallel, so that each box meets all others: as many pairs as the square of
  // their number, which is refused after a time in proportion to it. A profile of as many pieces that goes on is
  // checked.
  void aHatchingIsRefused() {
    Segments zigzag;
    constexpr int kLines = 100'000;
    ProfilePoint at(1.0, 0.0);
    for (int i = 0; i < kLines - 3; ++i) {
      const bool isUp = i % 2 == 0;
      const ProfilePoint to(isUp ? 1000.0 + 0.001 * i : 1.0 + 0.001 * i, isUp ? 1000.0 : 0.0005 * i);
      zigzag.push_back({at, to, 0.0});
      at = to;
    }
    QVERIFY(refusal(zigzag) == TargetError::TooIntricate || refusal(zigzag) == TargetError::CrossesItself);
    Segments steps;
    at = {10.0, 0.0};
    for (int i = 0; i < kLines - 3; ++i) {
      const ProfilePoint to(10.0 + 0.01 * (i % 2), at.y() + 0.01);
      steps.push_back({at, to, 0.0});
      at = to;
    }
    QVERIFY(TargetProfile::make(steps).hasValue());
  }

  void aCylinder() {
    // The profile is the same as an open line, with its ends, closed along the axis, and in reverse.
    const Segments open = through({{20, 0}, {20, 100}});
    const Segments whole = through({{0, 0}, {20, 0}, {20, 100}, {0, 100}, {0, 0}});
    for (const Segments& given : {open, whole, turnedRound(open), turnedRound(whole)}) {
      const auto made = TargetProfile::make(given);
      QVERIFY(made.hasValue());
      QVERIFY(!made->isClosed());
      QCOMPARE(made->segments().size(), std::size_t{3});
      QVERIFY(std::abs(made->volume() - M_PI * 400.0 * 100.0) < 1e-6);
      QCOMPARE(made->largestRadius(), 20.0);
      QCOMPARE(made->length(), 100.0);
      QCOMPARE(made->distance({25.0, 50.0}), 5.0);
      QCOMPARE(made->distance({15.0, 50.0}), -5.0);
      QCOMPARE(made->distance({0.0, 99.0}), -1.0);
      QCOMPARE(made->distance({23.0, 104.0}), 5.0);
      QCOMPARE(made->distance({0.0, -2.0}), 2.0);
    }
  }

  // The radius on an arc is exact for any flatness, and points of its circle beyond its end do not belong to it.
  void extentOnArcs() {
    for (const double bulge : {1e-9, 1e-7, 1e-4, -1e-4, -1e-2, 0.2}) {
      const ProfileSegment arc{{10, 10}, {14, 30}, bulge};
      const auto made = TargetProfile::make(
          {{{0, 0}, {10, 0}, 0.0}, {{10, 0}, {10, 10}, 0.0}, arc, {{14, 30}, {14, 50}, 0.0}, {{14, 50}, {0, 50}, 0.0}});
      QVERIFY(made.hasValue());
      for (const double share : {1e-6, 0.1, 0.5, 0.77, 1.0 - 1e-6}) {
        const ProfilePoint p = arc.at(share);
        QVERIFY(std::abs(made->extentAt(p.y())->outer - p.x()) < 1e-12);
        QVERIFY(std::abs(made->distance(p)) < 1e-12);
      }
      QCOMPARE(made->extentAt(30.0 + 1e-7)->outer, 14.0);
      // Beside its middle, by a distance that the rounding of a far centre would hide.
      const ProfilePoint middle = arc.at(0.5), along = arc.direction(0.5), out(along.y(), -along.x());
      for (const double aside : {-1e-8, 1e-8, 1e-3})
        QVERIFY(std::abs(made->distance(middle + aside * out) - aside) < 1e-12);
    }
  }

  void aBoredBush() {
    const Segments ring = through({{5, 0}, {20, 0}, {20, 30}, {5, 30}, {5, 0}});
    for (const Segments& given : {ring, turnedRound(ring), through({{20, 0}, {20, 30}, {5, 30}, {5, 0}})}) {
      const auto made = TargetProfile::make(given);
      QVERIFY(made.hasValue());
      QVERIFY(made->isClosed());
      QVERIFY(std::abs(made->volume() - M_PI * (400.0 - 25.0) * 30.0) < 1e-9);
      QCOMPARE(made->distance({0.0, 15.0}), 5.0);
      QCOMPARE(made->extentAt(15.0)->inner, 5.0);
      QCOMPARE(made->extentAt(15.0)->outer, 20.0);
    }
    // A blind bore begins on the axis.
    const auto blind = TargetProfile::make(through({{0, 0}, {20, 0}, {20, 30}, {5, 30}, {5, 10}, {0, 10}}));
    QVERIFY(blind.hasValue() && !blind->isClosed());
    QVERIFY(std::abs(blind->volume() - M_PI * (400.0 * 30.0 - 25.0 * 20.0)) < 1e-9);
    QCOMPARE(blind->extentAt(5.0)->inner, 0.0);
    QCOMPARE(blind->extentAt(20.0)->inner, 5.0);
    QCOMPARE(blind->distance({0.0, 12.0}), 2.0);
    QCOMPARE(blind->distance({0.0, 9.0}), -1.0);
  }

  // An arc that dips below the face that it leaves ends the part in a circle, whose radius follows from the tangents.
  void anArcThatDips() {
    for (int i = 1; i <= 200; ++i) {
      const ProfilePoint from(3.0906, 0.0), to(19.1351, 2.1616);
      const double rise = std::atan2(to.y(), to.x() - from.x()), half = rise + 0.001 * i;  // rad, of the arc
      const auto made = TargetProfile::make({{{0.0, 0.0}, from, 0.0},
                                             {from, to, std::tan(0.5 * half)},
                                             {to, {to.x(), 4.0}, 0.0},
                                             {{to.x(), 4.0}, {0.0, 4.0}, 0.0}});
      QVERIFY(made.hasValue());
      const auto extent = made->extentAt(made->lowerEnd());
      QVERIFY(extent.has_value());
      const double radius = 0.5 * (to - from).norm() / std::sin(half),
                   lowest = from.x() + radius * std::sin(half - rise);
      QVERIFY(std::abs(extent->outer - lowest) < 1e-4 && std::abs(extent->inner - lowest) < 1e-4);
    }
  }

  void aBall() {
    const auto ball = TargetProfile::make({arcAround({0, 7}, 5.0, -M_PI / 2, M_PI / 2)});
    QVERIFY(ball.hasValue());
    QVERIFY(std::abs(ball->volume() - 4.0 / 3.0 * M_PI * 125.0) < 1e-9);
    for (const ProfilePoint& p : {ProfilePoint(0, 7), ProfilePoint(3, 5), ProfilePoint(9, 7), ProfilePoint(0, 14)})
      QVERIFY(std::abs(ball->distance(p) - ((p - ProfilePoint(0, 7)).norm() - 5.0)) < 1e-9);
  }

  void refuses() {
    QCOMPARE(refusal({}), ErrorCode(TargetError::NoArea));
    QCOMPARE(refusal(through({{0, 0}, {0, 10}})), ErrorCode(TargetError::NoArea));
    QCOMPARE(refusal(through({{0, 0}, {5, 0}, {0, 0}})), ErrorCode(TargetError::NoArea));
    QCOMPARE(refusal(through({{5, 0}, {-5, 10}})), ErrorCode(TargetError::CrossesAxis));
    QCOMPARE(refusal({arcAround({3, 0}, 4.0, M_PI / 2, 1.5 * M_PI)}), ErrorCode(TargetError::CrossesAxis));
    QCOMPARE(refusal(through({{5, 0}, {0, 10}, {5, 20}})), ErrorCode(TargetError::TouchesAxis));
    // A groove of 5 mm in a rod of 10 mm: the arc touches the axis between its ends.
    QCOMPARE(refusal({{{5, 0}, {5, 10}, 0.0}, *arcThrough({5, 10}, {0, 15}, {5, 20}), {{5, 20}, {5, 30}, 0.0}}),
             ErrorCode(TargetError::TouchesAxis));
    QCOMPARE(refusal({{{5, 0}, {5, 10}, 0.0}, {{5, 11}, {5, 20}, 0.0}}), ErrorCode(TargetError::NotJoined));
    QCOMPARE(refusal(through({{0, 0}, {10, 0}, {10, 20}, {5, 20}, {15, 10}, {0, 10}})),
             ErrorCode(TargetError::CrossesItself));
    QCOMPARE(refusal(through({{0, 0}, {10, 0}, {10, 20}, {10, 10}, {0, 10}})), ErrorCode(TargetError::CrossesItself));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {nan, HUGE_VAL, 1e300, -1e7})
      QCOMPARE(refusal({{{5, 0}, {5, bad}, 0.0}}), ErrorCode(ErrorCode::ValueOutOfRange));
    QCOMPARE(refusal(Segments(TargetProfile::kMostSegments + 1)), ErrorCode(ErrorCode::FileTooLarge));
  }

  void distancesByDefinition() {
    QVERIFY(rc::check("the least distance of sampled points, with the sign of the ray test", [] {
      const auto made = TargetProfile::make(anyShaft());
      RC_PRE(made.hasValue());
      const ProfilePoint p(evenly(0.0, 40.0), evenly(-10.0, made->upperEnd() + 10.0));
      double least = HUGE_VAL;
      for (const ProfileSegment& s : made->segments())
        for (int i = 0; i <= 500; ++i) least = std::min(least, (s.at(i / 500.0) - p).norm());
      const double found = made->distance(p);
      RC_ASSERT(std::abs(std::abs(found) - least) < 0.1);
      if (least > 0.1) RC_ASSERT((found < 0.0) == isInside(*made, p));
    }));
  }

  void eitherDirectionIsTheSame() {
    QVERIFY(rc::check("a shaft and its reverse, and its reflection in volume", [] {
      const Segments given = anyShaft();
      const auto made = TargetProfile::make(given), back = TargetProfile::make(turnedRound(given));
      RC_ASSERT(made.hasValue() == back.hasValue());
      RC_PRE(made.hasValue());
      RC_ASSERT(std::abs(made->volume() - back->volume()) < 1e-9 * made->volume());
      RC_ASSERT(made->volume() > 0.0);
      const TargetProfile up = made->moved(3.0);
      const ProfilePoint p(evenly(0.0, 40.0), evenly(-10.0, 100.0));
      RC_ASSERT(std::abs(up.distance(p + ProfilePoint(0, 3)) - made->distance(p)) < 1e-9);
    }));
  }

  void endForEnd() {
    QVERIFY(rc::check("a shaft end for end has the distances of the reflected points", [] {
      const auto made = TargetProfile::make(anyShaft());
      RC_PRE(made.hasValue());
      const TargetProfile turned = made->turnedEndForEnd();
      RC_ASSERT(std::abs(turned.lowerEnd() - made->lowerEnd()) < 1e-9);
      RC_ASSERT(std::abs(turned.upperEnd() - made->upperEnd()) < 1e-9);
      RC_ASSERT(std::abs(turned.volume() - made->volume()) < 1e-9 * made->volume());
      const ProfilePoint p(evenly(0.0, 40.0), evenly(-10.0, 100.0));
      const ProfilePoint reflected(p.x(), made->lowerEnd() + made->upperEnd() - p.y());
      RC_ASSERT(std::abs(turned.distance(p) - made->distance(reflected)) < 1e-9);
    }));
  }

  // A quarter of a ball at the upper end, and a bore through, whose outline is closed.
  void arcsAndBoresEndForEnd() {
    const auto ball = TargetProfile::make(
        {{{0, 0}, {10, 0}, 0.0}, {{10, 0}, {10, 20}, 0.0}, {{10, 20}, {0, 30}, std::tan(std::acos(-1.0) / 8.0)}});
    QVERIFY(ball);
    const TargetProfile turned = ball->turnedEndForEnd();
    // The surface of the ball is 10 mm around (0, 10) now.
    QVERIFY(std::abs(turned.distance({10.0 * std::sqrt(0.5), 10.0 - 10.0 * std::sqrt(0.5)})) < 1e-9);
    QVERIFY(std::abs(turned.extentAt(30.0)->outer - 10.0) < 1e-9);
    const auto bush = TargetProfile::make(
        through({{5, 0}, {20, 0}, {20, 30}, {15, 30}, {15, 50}, {8, 50}, {8, 20}, {5, 20}, {5, 0}}));
    QVERIFY(bush && bush->isClosed());
    const TargetProfile other = bush->turnedEndForEnd();
    QVERIFY(other.isClosed());
    QCOMPARE(other.extentAt(5.0)->inner, 8.0);
    QCOMPARE(other.extentAt(45.0)->outer, 20.0);
    QCOMPARE(other.turnedEndForEnd().extentAt(5.0)->inner, 5.0);
    // They are as sound as the original.
    for (const TargetProfile* each : {&turned, &other}) {
      const auto again = TargetProfile::make({each->segments().begin(), each->segments().end()});
      QVERIFY(again && std::abs(again->volume() - each->volume()) < 1e-9 * each->volume());
    }
  }

  void extentsByDistance() {
    QVERIFY(rc::check("the ends of an extent are on the surface", [] {
      const auto made = TargetProfile::make(anyShaft());
      RC_PRE(made.hasValue());
      const double z = evenly(0.0, made->upperEnd());
      const auto extent = made->extentAt(z);
      RC_ASSERT(extent.has_value());
      RC_ASSERT(extent->inner == 0.0);
      RC_ASSERT(std::abs(made->distance({extent->outer, z})) < 1e-7);
      RC_ASSERT(made->distance({extent->outer + 0.01, z}) > 0.0);
    }));
  }

  // A profile as long as is allowed is made and asked in a moment.
  void manySegments() {
    std::vector<ProfilePoint> points;
    for (int i = 0; i < 99'000; ++i) points.emplace_back(20.0 + (i % 2) * 0.5, 0.01 * i);
    const auto made = TargetProfile::make(through(points));
    QVERIFY(made.hasValue());
    for (int i = 0; i < 100'000; ++i) (void)made->distance({30.0, 0.0099 * i});
    QVERIFY(std::abs(made->distance({25.0, 500.01}) - 4.5) < 0.01);
  }

  // Wherever it is cancelled, it ends within few more looks at the flag: all work between two looks is bounded.
  void cancelled() {
    std::vector<ProfilePoint> points;
    for (int i = 0; i < 20'000; ++i) points.emplace_back(20.0 + (i % 2) * 0.5, 0.01 * i);
    JobState state;
    state.cancelled = true;
    const auto made = TargetProfile::make(through(points), Progress(state));
    QVERIFY(!made && made.error().code == ErrorCode::Cancelled);
    Drawing drawing;
    drawing.axis = 0.0;
    for (const ProfileSegment& s : through(points))
      drawing.curves.push_back({{s.from.y(), s.from.x()}, {s.to.y(), s.to.x()}, 0.0});
    const auto read = targetIn(drawing, Progress(state));
    QVERIFY(!read && read.error().code == ErrorCode::Cancelled);
    state.cancelled = false;
    QVERIFY(targetIn(drawing, Progress(state)).hasValue());
    QVERIFY(state.polls > 20);
  }

  void notANumber() {
    const auto made = TargetProfile::make(through({{20, 0}, {20, 100}}));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(std::isnan(made->distance({nan, 0.0})) && std::isnan(made->distance({0.0, HUGE_VAL})));
    QVERIFY(!made->extentAt(nan) && !made->extentAt(-1.0) && !made->extentAt(101.0));
  }
};

HANDWHEEL_TEST(TargetProfileTest)
#include "TargetProfileTest.moc"
