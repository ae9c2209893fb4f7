// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/TargetDeviation.h"

#include "AnyProfile.h"
#include "TestClass.h"
#include "machining/refit/SampledProfile.h"

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
    // As far up as it is short, both ends are off.
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

  void anExactPartHasNone() {
    QVERIFY(rc::check("its samples are on the target; an allowance shows as such", [] {
      const auto target = TargetProfile::make(anyShaft());
      RC_PRE(target.hasValue());
      const TurnedProfile part = sampled(*target, 0.05);
      RC_ASSERT(deviationFrom(*target, part, 0.0).largest() < 1e-7);
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
