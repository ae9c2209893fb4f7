// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/RoundedTarget.h"

#include "TestClass.h"
#include "machining/refit/SampledProfile.h"
#include "machining/target/ProfileFeatures.h"

#include <rapidcheck.h>

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace handwheel;
using FeatureKind = ProfileFeature::Kind;

namespace {

// A bar of ⌀40 × 80 as a hand turned it: ⌀30.02 down to Z 30.013, where the nose of 0.8 left its fillet, and ⌀20.03
// above Z 55.006 with one of its own; bored to ⌀10.01.
TargetProfile turnedByHand() {
  TurnedProfile part({40.0, 80.0, 0.0}, 0.013);
  part.cut({15.01 + 0.8, 90.0}, {15.01 + 0.8, 30.013 + 0.8}, 0.8);
  part.cut({10.015 + 0.8, 90.0}, {10.015 + 0.8, 55.006 + 0.8}, 0.8);
  part.cutBore({5.005 - 0.8, 90.0}, {5.005 - 0.8, 60.01 + 0.8}, 0.8);
  return sectionOf(part, 2e-3).value();
}

std::vector<ProfileFeature> of(const std::vector<ProfileFeature>& all, FeatureKind kind) {
  std::vector<ProfileFeature> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some),
               [kind](const ProfileFeature& each) { return each.kind == kind; });
  return some;
}

double stepsOff(double value, double step) {
  return std::abs(value / step - std::round(value / step));
}

}  // namespace

class RoundedTargetTest : public QObject {
  Q_OBJECT

 private slots:
  void sizesAreRound() {
    const auto round = rounded(turnedByHand(), {.step = 0.1, .largestFillet = 0.0});
    QVERIFY(round.hasValue());
    const auto features = featuresOf(*round, 1e-6);
    const auto cylinders = of(features, FeatureKind::Cylinder);
    QCOMPARE(cylinders.size(), std::size_t{4});
    const double diameters[] = {40.0, 30.0, 20.0, 10.0};
    for (std::size_t i = 0; i < 4; ++i) QVERIFY(std::abs(cylinders[i].value - diameters[i]) < 1e-9);
    QVERIFY(std::abs(cylinders[0].high.y() - 30.0) < 1e-9);
    QVERIFY(std::abs(cylinders[1].high.y() - 55.0) < 1e-9);
    for (const ProfileFeature& arc : of(features, FeatureKind::Arc)) QVERIFY(std::abs(arc.value - 0.8) < 1e-9);
    QVERIFY(of(features, FeatureKind::Arc).size() >= 2);
    QVERIFY(largestDistance(*round, turnedByHand()) < 0.05);
  }

  // A drawing has a sharp corner where the nose of the tool leaves its radius; others stay.
  void hollowCornersBecomeSharp() {
    const auto sharp = rounded(turnedByHand(), {.step = 0.1, .largestFillet = 0.8});
    QVERIFY(sharp.hasValue());
    const auto features = featuresOf(*sharp, 1e-6);
    QVERIFY(of(features, FeatureKind::Arc).empty());
    const auto cylinders = of(features, FeatureKind::Cylinder);
    QVERIFY(std::abs(cylinders[1].low.y() - 30.0) < 1e-9 && std::abs(cylinders[1].high.y() - 55.0) < 1e-9);
    const auto kept = rounded(turnedByHand(), {.step = 0.1, .largestFillet = 0.7});
    QVERIFY(kept.hasValue() && !of(featuresOf(*kept, 1e-6), FeatureKind::Arc).empty());
  }

  void aRoundedCornerOutsideStays() {
    // A pin of ⌀20 × 30, its edge rounded with 2.
    const auto pin = TargetProfile::make({{{0, 0}, {10, 0}, 0.0},
                                          {{10, 0}, {10, 28.003}, 0.0},
                                          arcAround({8, 28.003}, 2.0, 0.0, M_PI / 2),
                                          {{8, 30.003}, {0, 30.003}, 0.0}});
    const auto round = rounded(pin.value(), {.step = 0.5, .largestFillet = 5.0});
    QVERIFY(round.hasValue());
    const auto arcs = of(featuresOf(*round, 1e-6), FeatureKind::Arc);
    QCOMPARE(arcs.size(), std::size_t{1});
    QVERIFY(arcs[0].isConvex && std::abs(arcs[0].value - 2.0) < 1e-9);
    QVERIFY(std::abs(round->upperEnd() - 30.0) < 1e-9);
  }

  // A ball on a rod: the ends of its arc are rounded, and it goes on through them.
  void otherArcsKeepTheirAngle() {
    const double r = 12.02, neck = std::sqrt(r * r - 16.0);
    const auto ball = TargetProfile::make(
        {{{0, 0}, {4, 0}, 0.0}, {{4, 0}, {4, 20}, 0.0}, arcAround({0, 20 + neck}, r, std::asin(-neck / r), M_PI / 2)});
    const auto round = rounded(ball.value(), {.step = 0.1, .largestFillet = 0.0});
    QVERIFY(round.hasValue());
    QCOMPARE(of(featuresOf(*round, 1e-6), FeatureKind::Arc).size(), std::size_t{1});
    QVERIFY(largestDistance(*round, ball.value()) < 0.1);
  }

  // Round sizes stay, and rounding twice is rounding once.
  void twiceIsOnce() {
    QVERIFY(rc::check([] {
      std::vector<ProfileSegment> outline;
      ProfilePoint at(0, 0);
      const auto to = [&](const ProfilePoint& next) {
        if (next != at) outline.push_back({at, next, 0.0});
        at = next;
      };
      const auto upTo = [](int most) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(1, most)); };
      for (int steps = upTo(6); steps > 0; --steps) {
        const double radius = 0.013 * upTo(2'000), height = at.y() + 0.9 + 0.013 * upTo(2'000);
        to({radius + 0.5, at.y()});
        to({radius + 0.5, height});
      }
      to({0.0, at.y()});
      const double step = *rc::gen::element(0.01, 0.1, 0.5);
      const auto once = rounded(TargetProfile::make(outline).value(), {.step = step, .largestFillet = 0.0});
      RC_ASSERT(once.hasValue());
      for (const ProfileSegment& s : once->segments())
        RC_ASSERT(stepsOff(2.0 * s.from.x(), step) < 1e-6 && stepsOff(s.from.y(), step) < 1e-6);
      const auto twice = rounded(*once, {.step = step, .largestFillet = 0.0});
      RC_ASSERT(twice.hasValue());
      RC_ASSERT(largestDistance(*once, *twice) < 1e-9);
    }));
  }

  void impossibleStepsAreRefused() {
    for (const double step : {0.0, -1.0, 1e9, std::nan("")}) {
      const auto round = rounded(turnedByHand(), {.step = step, .largestFillet = 0.0});
      QVERIFY(!round);
      QVERIFY(round.error().code == ErrorCode::ValueOutOfRange);
    }
    // Nothing is left of a pin of 2 mm in steps of 10.
    const auto pin = TargetProfile::make({{{0, 0}, {1, 0}, 0.0}, {{1, 0}, {1, 2}, 0.0}, {{1, 2}, {0, 2}, 0.0}});
    QVERIFY(!rounded(pin.value(), {.step = 10.0, .largestFillet = 0.0}));
  }
};

HANDWHEEL_TEST(RoundedTargetTest)
#include "RoundedTargetTest.moc"
