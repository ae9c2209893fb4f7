// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/TargetDeviation.h"

#include "AnyProfile.h"
#include "TestClass.h"
#include "machining/refit/SampledProfile.h"
#include "machining/target/TargetSides.h"

#include <QtTest>

using namespace handwheel;
using test::anyShaft;
using test::evenly;

namespace {

TargetProfile cylinder(double radius, double length) {
  return TargetProfile::make({{{radius, 0}, {radius, length}, 0.0}}).value();
}

}  // namespace

class TargetDeviationTest : public QObject {
  Q_OBJECT

 private slots:
  void anUncutBar() {
    const TurnedProfile bar(StockCylinder{44.0, 105.0, 0.0}, 0.1);
    const TargetDeviation d = deviationFrom(cylinder(20.0, 100.0), bar, 0.0);
    QCOMPARE(d.outer.size(), bar.size());
    QVERIFY(std::abs(d.outer[500] - 2.0) < 1e-12);
    // Furthest is the rim beyond the upper end.
    QVERIFY(std::abs(d.largestOver.distance - std::hypot(2.0, 5.0)) < 1e-12);
    QVERIFY((d.largestOver.at - ProfilePoint(22.0, 105.0)).norm() < 1e-9);
    QCOMPARE(d.largestUnder.distance, 0.0);
  }

  // A finished part of 70 mm with the bar behind it: only the material over its face is too large.
  void theBarBehindThePart() {
    const auto target = TargetProfile::make({{{18, 30}, {18, 100}, 0.0}});
    QVERIFY(bool(target));
    for (const double over : {0.0, 1.0}) {
      TurnedProfile part(StockCylinder{40.0, 100.0 + over, 0.0}, 0.1);
      for (std::size_t i = 0; i < part.size(); ++i)
        if (part.z(i) > 30.0) part.limitOuter(i, 18.0);
      const TargetDeviation all = deviationFrom(*target, part, 0.0);
      QVERIFY(std::abs(all.largestOver.distance - std::hypot(2.0, 30.0)) < 1e-9);
      const AxisRange range = rangeOfTarget(*target, part, 0.0);
      const TargetDeviation d = deviationFrom(*target, part, 0.0, {}, range);
      QVERIFY(std::abs(d.largestOver.distance - over) < 1e-9 && d.largestUnder.distance > -1e-9);
      QVERIFY(range.from > 30.0 && range.from < 30.3);
      QCOMPARE(rangeOfTarget(*target, part, 0.0, 45.0).from, 45.0);
      // One that goes to the end of the bar has nothing behind it.
      QCOMPARE(rangeOfTarget(*target, part, 30.0).from, kWholeAxis.from);
    }
  }

  void cutTooDeep() {
    TurnedProfile part(StockCylinder{40.0, 100.0, 0.0}, 0.1);
    for (std::size_t i = 300; i < 600; ++i) part.limitOuter(i, 19.0);
    const TargetDeviation d = deviationFrom(cylinder(20.0, 100.0), part, 0.0);
    QVERIFY(std::abs(d.largestUnder.distance + 1.0) < 1e-12 && d.largestOver.distance < 1e-12);
    QVERIFY(d.largestUnder.at.y() >= 30.0 && d.largestUnder.at.y() < 60.0);
    QCOMPARE(d.largest(), -d.largestUnder.distance);
  }

  void tooShort() {
    const TurnedProfile part(StockCylinder{40.0, 99.0, 0.0}, 0.1);
    const TargetDeviation d = deviationFrom(cylinder(20.0, 100.0), part, 0.0);
    QVERIFY(std::abs(d.largestUnder.distance + 1.0) < 1e-12);
    // Both ends are off: the part is moved up by its shortfall.
    const TargetDeviation moved = deviationFrom(cylinder(20.0, 100.0), part, 1.0);
    QVERIFY(std::abs(moved.largestUnder.distance + 1.0) < 1e-12 && moved.largestUnder.at.y() == 1.0);
  }

  void bores() {
    const auto tube = TargetProfile::make(
        {{{8, 0}, {20, 0}, 0.0}, {{20, 0}, {20, 50}, 0.0}, {{20, 50}, {8, 50}, 0.0}, {{8, 50}, {8, 0}, 0.0}});
    TurnedProfile part(StockCylinder{40.0, 50.0, 0.0}, 0.1);
    QVERIFY(std::abs(deviationFrom(*tube, part, 0.0).largestOver.distance - 8.0) < 1e-12);  // not bored at all
    for (std::size_t i = 0; i < part.size(); ++i) part.limitInner(i, 7.5);
    const TargetDeviation tight = deviationFrom(*tube, part, 0.0);
    QVERIFY(std::abs(tight.largestOver.distance - 0.5) < 1e-12 && std::abs(tight.inner[100] - 0.5) < 1e-12);
    for (std::size_t i = 0; i < part.size(); ++i) part.limitInner(i, 8.25);
    const TargetDeviation wide = deviationFrom(*tube, part, 0.0);
    QVERIFY(std::abs(wide.largestUnder.distance + 0.25) < 1e-12);
  }

  // A wall of 2 mm whose outside is cut by 1.5 mm: the bore is nearer than where the outside is to be.
  void thinWalls() {
    const auto tube = TargetProfile::make(
        {{{18, 0}, {20, 0}, 0.0}, {{20, 0}, {20, 50}, 0.0}, {{20, 50}, {18, 50}, 0.0}, {{18, 50}, {18, 0}, 0.0}});
    TurnedProfile part(StockCylinder{40.0, 50.0, 0.0}, 0.1);
    for (std::size_t i = 0; i < part.size(); ++i) part.limitInner(i, 18.0);
    for (std::size_t i = 200; i < 300; ++i) part.limitOuter(i, 18.5);
    QVERIFY(std::abs(deviationFrom(*tube, part, 0.0).largestUnder.distance + 1.5) < 1e-12);
  }

  // ⌀40, from z 50 on ⌀30; bored ⌀10 from 60 on. Errors of each side count where the range is, and nowhere else.
  void ranges() {
    const auto stepped = TargetProfile::make({{{0, 0}, {20, 0}, 0.0},
                                              {{20, 0}, {20, 50}, 0.0},
                                              {{20, 50}, {15, 50}, 0.0},
                                              {{15, 50}, {15, 100}, 0.0},
                                              {{15, 100}, {5, 100}, 0.0},
                                              {{5, 100}, {5, 60}, 0.0},
                                              {{5, 60}, {0, 60}, 0.0}});
    const auto turned = [](double outerError, double boreError, double length) {
      constexpr std::size_t kCount = 5001;
      std::vector<double> radii(kCount), inner(kCount);
      for (std::size_t i = 0; i < kCount; ++i) {
        const double z = 100.0 * static_cast<double>(i) / (kCount - 1);
        radii[i] = z > length ? 0.0 : z < 50.0 ? 20.0 : 15.0 + outerError;
        inner[i] = z < 60.0 || z > length ? 0.0 : 5.0 + boreError;
      }
      return TurnedProfile::fromRadii(radii, inner, 100.0);
    };
    const auto of = [&](const TurnedProfile& part, AxisRange range) {
      return deviationFrom(*stepped, part, 0.0, {}, range);
    };
    QVERIFY(of(turned(0, 0, 100), kWholeAxis).largest() <= 0.02 + 1e-9);  // for a face between two samples
    QVERIFY(std::abs(of(turned(0.3, 0, 100), {55, 95}).largestOver.distance - 0.3) < 1e-9);
    QVERIFY(std::abs(of(turned(-0.2, 0, 100), {55, 95}).largestUnder.distance + 0.2) < 1e-9);
    QVERIFY(std::abs(of(turned(0, 0.1, 100), {65, 95}).largestUnder.distance + 0.1) < 1e-9);
    QVERIFY(std::abs(of(turned(0, -0.1, 100), {65, 95}).largestOver.distance - 0.1) < 1e-9);
    QVERIFY(of(turned(0.3, 0, 100), {5, 45}).largest() < 1e-9);
    // Too short: the end is missing, by as much.
    const TargetDeviation brief = of(turned(0, 0, 98), {70, 100});
    QVERIFY(std::abs(brief.largestUnder.distance + 2.0) < 0.03 && brief.largestOver.distance < 1e-9);
  }

  // A bore where there is to be none is as much too little as it is wide; bores from both ends are two.
  void unwantedAndOppositeBores() {
    const TurnedProfile bored = TurnedProfile::fromRadii({15.0, 15.0}, {4.0, 4.0}, 100.0);
    QVERIFY(std::abs(deviationFrom(cylinder(15.0, 100.0), bored, 0.0).largestUnder.distance + 4.0) < 1e-9);
    const auto both = TargetProfile::make({{{0, 10}, {4, 10}, 0.0},
                                           {{4, 10}, {4, 0}, 0.0},
                                           {{4, 0}, {15, 0}, 0.0},
                                           {{15, 0}, {15, 60}, 0.0},
                                           {{15, 60}, {5, 60}, 0.0},
                                           {{5, 60}, {5, 40}, 0.0},
                                           {{5, 40}, {0, 40}, 0.0}});
    const auto sides = sidesOf(*both);
    QVERIFY(sides.hasValue() && sides->bores.size() == 2);
    QVERIFY(std::abs(sides->outside.volume() - M_PI * 225.0 * 60.0) < 1e-6);
    TurnedProfile part(StockCylinder{30.0, 60.0, 0.0}, 0.1);
    for (std::size_t i = 0; i <= 100; ++i) part.limitInner(i, 4.5);
    for (std::size_t i = 400; i <= 600; ++i) part.limitInner(i, 4.8);
    const TargetDeviation d = deviationFrom(*both, part, 0.0);
    QVERIFY(std::abs(d.inner[50] + 0.5) < 1e-9 && std::abs(d.inner[500] - 0.2) < 1e-9);
  }

  // Tangent to the face that it leaves, an arc lies a few nanometres beyond it by rounding: that is no recess.
  void anArcAlongAFace() {
    const ProfilePoint from(2.0, 0.0), to(5.2921, 1.0);
    const double rise = std::atan2(to.y() - from.y(), to.x() - from.x());
    for (const double share : {1.0 - 1e-6, 1.0, 1.0 + 1e-12, 1.0 + 1e-6, 1.0 + 3e-4}) {
      const auto target = TargetProfile::make({{{0.0, 0.0}, from, 0.0},
                                               {from, to, std::tan(0.5 * share * rise)},
                                               {to, {to.x(), 2.0}, 0.0},
                                               {{to.x(), 2.0}, {0.0, 2.0}, 0.0}});
      QVERIFY(bool(target));
      QCOMPARE(target->extentAt(target->lowerEnd())->inner, 0.0);
      QVERIFY(deviationFrom(*target, sampled(*target, 0.05), 0.0).largest() < 2e-6);
    }
  }

  void anExactPartHasNone() {
    QVERIFY(rc::check("its samples are on the target; an allowance shows as such", [] {
      const auto target = TargetProfile::make(anyShaft());
      RC_PRE(target.hasValue());
      // An arc along the lower face that is beyond it by rounding is no recess: the part has its face there.
      const double base = target->lowerEnd(), beyond = -base <= TargetProfile::kJoin ? -base : 0.0;
      const TurnedProfile part = sampled(*target, 0.05);
      RC_ASSERT(deviationFrom(*target, part, base).largest() < 1e-7 + beyond);
    }));
  }

  void cancelled() {
    JobState state;
    state.cancelled = true;
    const TurnedProfile bar(StockCylinder{44.0, 105.0, 0.0}, 0.001);
    (void)deviationFrom(cylinder(20.0, 100.0), bar, 0.0, Progress(state));
    QVERIFY(state.polls > 0);
  }
};

HANDWHEEL_TEST(TargetDeviationTest)
#include "TargetDeviationTest.moc"
