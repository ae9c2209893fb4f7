// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/finish/FinishMeter.h"

#include "TestClass.h"
#include "machining/lathe/LatheJson.h"
#include "machining/measure/RoughnessGrade.h"

#include <QtTest>
#include <array>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr StockCylinder kFinishBar{40.0, 100.0, 0.0};
constexpr double kTurnsASecond = 10.0;  // 600 r/min
constexpr TurningSide kOutside = TurningSide::Outside;

// A part whose finish is followed.
struct FollowedPart {
  TurnedProfile profile{kFinishBar, 0.05};
  FinishMeter meter;
  std::uint32_t passes = 0;

  explicit FollowedPart(double usualSpeed = 0.0) : meter(profile, SurfaceFinish(profile.size()), usualSpeed) {}
  void turn(const TurningPass& pass) { cut(profile, std::make_shared<const TurningPass>(pass), passes++, meter); }
  std::size_t sampleAt(double z) const { return static_cast<std::size_t>(std::lround(z / profile.spacing())); }
  FinishMark at(double z, TurningSide side = kOutside) const { return meter.finish().at(side, sampleAt(z)); }
};

// Moves the centre of the nose between two positions at a feed (mm per revolution), in this number of moves.
TurningPass passAt(const ProfilePoint& from, const ProfilePoint& to, double feed, double nose, int moves = 1) {
  TurningPass pass;
  pass.noseRadius = nose;
  for (int i = 0; i <= moves; ++i) {
    const double share = static_cast<double>(i) / moves;
    pass.path.push_back(from + share * (to - from));
    pass.times.push_back(share * (to - from).norm() / (feed * kTurnsASecond));
  }
  pass.speeds.assign(pass.path.size(), 60.0 * kTurnsASecond);
  return pass;
}

// Along the axis, so that this radius is left.
TurningPass along(double radius, double from, double to, double feed, double nose = 0.8, int moves = 1) {
  return passAt({radius + nose, from}, {radius + nose, to}, feed, nose, moves);
}

// A block of this length along the axis that takes all beyond its tip.
std::shared_ptr<const LatheTool> abrasive(double leastRoughness, double width = 10.0) {
  auto tool = std::make_shared<LatheTool>();
  tool->kind = LatheToolKind::AbrasivePaper;
  tool->depthPerTurn = 0.001;
  tool->leastRoughness = leastRoughness;
  const double half = 0.5 * width;
  const std::array<ProfilePoint, 4> corners{{{0.0, -half}, {0.0, half}, {5.0, -half}, {5.0, half}}};
  tool->cutting = {RoundedPolygon(corners, 0.0)};
  return tool;
}

TurningPass rubbedTo(double radius, double z, const std::shared_ptr<const LatheTool>& tool) {
  TurningPass pass;
  pass.tool = tool;
  pass.path = {{radius + 1.0, z}, {radius, z}};
  pass.times = {0.0, 1.0};
  pass.speeds = {600.0, 600.0};
  return pass;
}

// The mean distance from the mean line (ISO 4287, Ra) of the surface that circles leave whose centres are a feed apart,
// in µm: the upper halves are integrated by the midpoint rule.
double raOfCusps(double feed, double radius) {
  constexpr int kSteps = 200'000;
  std::vector<double> heights;
  double mean = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double x = feed * ((i + 0.5) / kSteps - 0.5);
    heights.push_back(radius - std::sqrt(radius * radius - x * x));
    mean += heights.back() / kSteps;
  }
  double sum = 0.0;
  for (const double height : heights) sum += std::abs(height - mean) / kSteps;
  return 1e3 * sum;
}

bool isNear(double value, double expected, double share = 1e-6) {
  return std::abs(value - expected) <= share * expected;
}

}  // namespace

// The finish that passes leave along a part.
class FinishMeterTest : public QObject {
  Q_OBJECT

 private slots:
  // The handbooks' f²/(32 R) is that of the geometry within 4 %, as long as the feed is well below the nose; where the
  // feed is wider than the nose there are no cusps.
  void theLawIsThatOfCusps() {
    for (const double nose : {0.2, 0.4, 0.8, 1.2}) {
      for (const double share : {0.02, 0.1, 0.25, 0.5}) {
        const double exact = raOfCusps(share * nose, nose);
        QVERIFY2(isNear(idealRoughness(share * nose, nose), exact, 0.04), qPrintable(QString::number(exact)));
      }
      QVERIFY(std::isfinite(idealRoughness(2.0 * nose, nose)) && std::isinf(idealRoughness(2.001 * nose, nose)));
    }
    QVERIFY(std::isinf(idealRoughness(0.1, 0.0)));
    QCOMPARE(idealRoughness(0.0, 0.8), 0.0);
  }

  // By feed and nose, in one move or in many in a turn; uncut surfaces keep their finish.
  void edges() {
    for (const int moves : {1, 5000}) {
      FollowedPart part;
      part.turn(along(18.0, 105.0, 55.0, 0.1, 0.8, moves));
      const FinishMark mark = part.at(80.0);
      QVERIFY2(isNear(mark.roughness, raOfCusps(0.1, 0.8), 0.04), qPrintable(QString::number(mark.roughness)));
      QVERIFY(mark.isKnown() && mark.pass == 0 && isNear(mark.feed, 0.1, 1e-3));
      QCOMPARE(part.at(50.0), FinishMark());
      part.turn(along(17.5, 105.0, 75.0, 0.2, 0.4, moves));
      QVERIFY(isNear(part.at(90.0).roughness, raOfCusps(0.2, 0.4), 0.04));
      QVERIFY(part.at(90.0).pass == 1 && part.at(70.0) == mark);
      part.turn(along(18.5, 105.0, 55.0, 0.4));  // in the air
      QVERIFY(part.at(70.0) == mark && part.at(90.0).pass == 1);
    }
  }

  // A groove takes nothing beside it: between two that one move cuts the surface stays as it was.
  void onlyWhatIsCutChanges() {
    FollowedPart part;
    part.turn(along(18.0, 105.0, 15.0, 0.1));
    part.turn(along(16.0, 60.0, 50.0, 0.3));
    const FinishMark before = part.at(55.0);
    part.turn(along(18.0 - 1e-3, 70.0, 40.0, 0.2));
    QCOMPARE(part.at(55.0), before);
    QVERIFY(part.at(65.0).pass == 2 && part.at(45.0).pass == 2);
  }

  void theBore() {
    FollowedPart part;
    TurningPass bore = passAt({8.0 - 0.4, 103.0}, {8.0 - 0.4, 70.0}, 0.05, 0.4);
    bore.side = TurningSide::Bore;
    part.turn(bore);
    QVERIFY(isNear(part.at(90.0, TurningSide::Bore).roughness, raOfCusps(0.05, 0.4), 0.04));
    QVERIFY(!part.at(60.0, TurningSide::Bore).isKnown() && !part.at(90.0).isKnown());
  }

  // A drill leaves the finish of drilling, by either method of recording it; a bore after it has the finish of boring.
  // The ends of the range are those of ASME B46.1 at the feeds of Machinery's Handbook; between them it rises with the
  // feed.
  void drills() {
    const auto range = [](double feed, double least, double largest) {
      const double ra = drilledRoughness(feed);
      return ra >= least && ra <= largest;
    };
    QVERIFY(range(0.05, 1.599, 1.601) && range(0.381, 6.299, 6.301));
    QVERIFY(range(0.001, 1.599, 1.601) && range(5.0, 6.299, 6.301) && drilledRoughness(0.0) == 0.0);
    for (double feed = 0.06; feed < 0.37; feed += 0.01) QVERIFY(drilledRoughness(feed) > drilledRoughness(feed - 0.01));

    FollowedPart part;
    TurningPass ball = passAt({0.0, 112.0}, {0.0, 70.0}, 0.1, 6.0, 200);
    ball.side = TurningSide::Bore;
    part.turn(ball);
    QVERIFY(isNear(part.at(90.0, TurningSide::Bore).roughness, drilledRoughness(0.1), 0.01));
    TurningPass bored = passAt({7.0 - 0.4, 103.0}, {7.0 - 0.4, 85.0}, 0.05, 0.4);
    bored.side = TurningSide::Bore;
    part.turn(bored);
    QVERIFY(isNear(part.at(90.0, TurningSide::Bore).roughness, raOfCusps(0.05, 0.4), 0.04));

    FollowedPart other;
    TurningPass twist = passAt({0.0, 105.0}, {0.0, 70.0}, 0.2, 0.0, 200);
    twist.side = TurningSide::Bore;
    twist.tool = toolNamed(shippedLatheTools(), "drill-12");
    other.turn(twist);
    QVERIFY(isNear(other.at(90.0, TurningSide::Bore).roughness, drilledRoughness(0.2), 0.01));
  }

  // Cusps of f²/(8 R) have an Ra of a quarter of that: Ra falls by a quarter of the removed depth. It ends at the
  // grain; finer grain goes on; coarser grain leaves its own marks. Beside the width nothing changes.
  void abrasives() {
    FollowedPart part;
    part.turn(along(18.0, 105.0, 55.0, 0.4));
    const float turned = part.at(80.0).roughness;
    QVERIFY(isNear(turned, 6.25));
    const auto coarse = abrasive(0.8), fine = abrasive(0.2);
    part.turn(rubbedTo(17.996, 80.0, coarse));  // 4 µm
    QVERIFY(isNear(part.at(80.0).roughness, 5.25, 1e-4));
    QVERIFY(part.at(80.0).pass == 1 && part.at(84.9).pass == 1);
    QVERIFY(part.at(85.2).roughness == turned && part.at(74.8).pass == 0);
    part.turn(rubbedTo(17.99, 80.0, coarse));
    QVERIFY(isNear(part.at(80.0).roughness, 3.75, 1e-4));
    part.turn(rubbedTo(17.9, 80.0, coarse));
    QVERIFY(isNear(part.at(80.0).roughness, 0.8));
    part.turn(rubbedTo(17.8, 80.0, coarse));
    QVERIFY(isNear(part.at(80.0).roughness, 0.8));
    part.turn(rubbedTo(17.799, 80.0, fine));  // 1 µm
    QVERIFY(isNear(part.at(80.0).roughness, 0.55, 1e-3));
    part.turn(rubbedTo(17.7, 80.0, fine));
    QVERIFY(isNear(part.at(80.0).roughness, 0.2));
    part.turn(rubbedTo(17.6999, 80.0, coarse));
    QVERIFY(isNear(part.at(80.0).roughness, 0.8));
    part.turn(rubbedTo(17.8, 80.0, fine));  // does not touch
    QVERIFY(isNear(part.at(80.0).roughness, 0.8) && part.at(80.0).pass == 7);
    // A bar as it was drawn is ground, too.
    part.turn(rubbedTo(19.996, 30.0, coarse));
    QVERIFY(isNear(part.at(30.0).roughness, FinishMark::kDrawn - 1.0, 1e-3) && part.at(30.0).isKnown());
  }

  // Without a speed there is no feed in a revolution; with the usual one there is. At rest nothing is left that could
  // be reported, and paper does not change that.
  void speeds() {
    TurningPass pass = along(18.0, 105.0, 55.0, 0.1);
    pass.speeds.clear();
    FollowedPart part;
    part.turn(pass);
    QVERIFY(!part.at(80.0).isKnown() && part.at(80.0).pass == 0);
    part.turn(rubbedTo(17.5, 80.0, abrasive(0.4)));
    QVERIFY(!part.at(80.0).isKnown() && part.at(80.0).pass == 1);
    FollowedPart usual(60.0 * kTurnsASecond);
    usual.turn(pass);
    QVERIFY(isNear(usual.at(80.0).roughness, idealRoughness(0.1, 0.8)));
    pass.speeds.assign(2, 0.0);
    FollowedPart still;
    still.turn(pass);
    QVERIFY(std::isinf(still.at(80.0).roughness));
  }

  // A part of which nothing is known stays so where nothing is cut, and paper makes nothing of it.
  void whatIsNotKnown() {
    const TurnedProfile profile(kFinishBar, 0.05);
    FinishMeter meter(profile, SurfaceFinish());
    TurnedProfile cutPart = profile;
    cut(cutPart, std::make_shared<const TurningPass>(rubbedTo(19.9, 80.0, abrasive(0.4))), 0, meter);
    cut(cutPart, std::make_shared<const TurningPass>(along(18.0, 60.0, 40.0, 0.1)), 1, meter);
    QVERIFY(!meter.finish().at(kOutside, 1600).isKnown());
    QVERIFY(meter.finish().at(kOutside, 1000).isKnown());
    QCOMPARE(meter.finish().at(kOutside, 100).roughness, FinishMark::kUnknown);
  }

  // Turned, and wound back at the same X by a tool that removes 0.3 µm of work that has sprung back: touched, and no
  // more. A light cut in moves of which each removes less than that still counts as cut.
  void whatSpringsBackIsTouched() {
    for (const bool isOnePass : {true, false}) {
      FollowedPart part;
      TurningPass there = along(18.0, 105.0, 55.0, 0.1, 0.8, 5000);
      TurningPass back = along(18.0 - 3e-4, 55.0, 105.0, 8.0, 0.8, 500);
      if (isOnePass) {
        for (std::size_t i = 0; i < back.path.size(); ++i) {
          there.path.push_back(back.path[i]);
          there.times.push_back(there.times[5000] + back.times[i]);
          there.speeds.push_back(600.0);
        }
        part.turn(there);
      } else {
        part.turn(there);
        part.turn(back);
      }
      const FinishMark mark = part.at(80.0);
      QVERIFY2(isNear(mark.roughness, 1e3 * 0.01 / (32.0 * 0.8), 0.01), qPrintable(QString::number(mark.roughness)));
      QVERIFY(mark.pass == 0);
      QVERIFY(part.profile.radius(1600) < 18.0 - 2e-4);  // it is gone all the same
      part.turn(along(17.98, 105.0, 55.0, 0.2, 0.8, 100'000));
      QVERIFY2(isNear(part.at(80.0).roughness, 1e3 * 0.04 / (32.0 * 0.8), 0.01),
               qPrintable(QString::number(part.at(80.0).roughness)));
    }
  }

  // The material removed at the begin of a pass has the feed of its first move, if it is cut as one or not.
  void aPassBeginsWithItsFirstMove() {
    FollowedPart part, live;
    const TurningPass there = along(18.0, 105.0, 80.0, 0.2), back = along(17.9, 80.0, 95.0, 0.1, 0.8, 150);
    part.turn(there);
    live.turn(there);
    part.turn(back);
    for (std::size_t i = 1; i < back.path.size(); ++i) {
      const TurnedProfile::Range now = cut(live.profile, back, back.path[i - 1], back.path[i]);
      live.meter.add(back, i, 1, live.profile, now);
    }
    QVERIFY(part.profile == live.profile);
    QVERIFY(part.meter.finish() == live.meter.finish());
    QVERIFY(part.at(80.0).pass == 1 && isNear(part.at(80.0).roughness, raOfCusps(0.1, 0.8), 0.3));
    QVERIFY(isNear(part.at(80.0).feed, 0.1, 1e-4));
  }

  // The finish of one that follows is the same, bit for bit, however the parts before were copied.
  void isDeterministic() {
    FollowedPart one, other;
    for (FollowedPart* part : {&one, &other}) {
      part->turn(along(18.0, 105.0, 55.0, 0.17, 0.8, 777));
      part->turn(rubbedTo(17.99, 80.0, abrasive(0.4)));
    }
    const SurfaceFinish kept = one.meter.finish();
    QVERIFY(kept == other.meter.finish());
    one.turn(along(17.0, 105.0, 60.0, 0.1));
    QVERIFY(kept == other.meter.finish() && !(one.meter.finish() == kept));
  }

  void oddMoves() {
    FollowedPart part;
    TurningPass odd;
    odd.path = {{std::nan(""), 50}, {10, std::numeric_limits<double>::infinity()}, {18, 50}};
    odd.times = {0, 0, 0};
    odd.speeds = {600, 600, 600};
    part.turn(odd);
    QCOMPARE(part.at(70.0), FinishMark());
    QCOMPARE(part.meter.finish().at(kOutside, 1'000'000), FinishMark());
  }
};

HANDWHEEL_TEST(FinishMeterTest)
#include "FinishMeterTest.moc"
