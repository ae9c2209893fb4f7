// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/ForcePeaks.h"

#include "TestClass.h"
#include "machining/force/WorkMaterials.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

constexpr StockCylinder kSteelBar{40.0, 100.0, 0.0};
constexpr double kTurnsPerMinute = 1000.0;  // r/min

std::unique_ptr<KienzleModel> steelLaw() {
  return kienzleModel(*WorkMaterials::standard().find("medium-carbon-steel"), {});
}

// Along the bar from its upper end, so deep, in so many moves.
TurningPass alongTheBar(double depth, double feed, int moves) {
  TurningPass pass;
  pass.noseRadius = 0.8;
  for (int i = 0; i <= moves; ++i) {
    pass.path.emplace_back(20.0 - depth + pass.noseRadius, 105.0 - 60.0 * i / moves);
    pass.times.push_back(60.0 * i / moves / (feed * kTurnsPerMinute / 60.0));
  }
  return pass;
}

}  // namespace

// The largest force and power of a path.
class ForcePeaksTest : public QObject {
  Q_OBJECT

 private slots:
  // A cut of constant depth: the force of the law at the diameter of the bar, by few and by many moves.
  void findsTheDepthAndTheFeed_data() {
    QTest::addColumn<int>("moves");
    QTest::newRow("one move") << 1;
    QTest::newRow("some moves") << 60;
    QTest::newRow("a recording") << 18'000;  // 1 kHz
  }
  void findsTheDepthAndTheFeed() {
    QFETCH(int, moves);
    const auto law = steelLaw();
    const TurningPass pass = alongTheBar(2.0, 0.2, moves);
    const auto peaks = forcePeaks(TurnedProfile(kSteelBar, 0.013), {&pass, 1}, kTurnsPerMinute, *law);
    QVERIFY(peaks);
    const CutConditions cut{2.0, 0.2, M_PI * 40.0 * kTurnsPerMinute / 1000.0};
    const CutForces expected = law->at(cut);
    QVERIFY2(std::abs(peaks->force / expected.norm() - 1.0) < 0.08, qPrintable(QString::number(peaks->force)));
    QVERIFY(std::abs(peaks->power / cuttingPower(expected, cut) - 1.0) < 0.08);
    QVERIFY(std::abs(peaks->torque / cuttingTorque(expected, 40.0) - 1.0) < 0.08);
    QVERIFY(std::abs(peaks->cut.feed - 0.2) < 0.01 && peaks->time > 0.0);
  }

  void deepestPassCounts() {
    const auto law = steelLaw();
    const TurningPass passes[] = {alongTheBar(1.0, 0.2, 60), alongTheBar(4.0, 0.2, 60), alongTheBar(4.5, 0.2, 60)};
    const auto peaks = forcePeaks(TurnedProfile(kSteelBar, 0.013), passes, kTurnsPerMinute, *law);
    QVERIFY(peaks && std::abs(peaks->cut.depth - 3.0) < 0.25);  // the second takes 3 mm more
  }

  void nothingCutsNothing() {
    const auto law = steelLaw();
    const TurningPass air = alongTheBar(-1.0, 0.2, 60);
    for (const std::vector<TurningPass>& passes : {std::vector<TurningPass>{}, {air}, {TurningPass{}}}) {
      const auto peaks = forcePeaks(TurnedProfile(kSteelBar, 0.1), passes, kTurnsPerMinute, *law);
      QVERIFY(peaks && peaks->force == 0.0 && peaks->power == 0.0);
    }
  }

  // A rapid move through the work, a spindle that stands, and one that is nonsense: large, but finite.
  void crashesGiveFiniteForces() {
    const auto law = steelLaw();
    TurningPass rapid = alongTheBar(2.0, 0.2, 10);
    rapid.times.assign(rapid.times.size(), 0.0);
    const auto peaks = forcePeaks(TurnedProfile(kSteelBar, 0.1), {&rapid, 1}, kTurnsPerMinute, *law);
    QVERIFY(peaks && std::isfinite(peaks->force) && peaks->isOutsideModel);
    QVERIFY(peaks->force > law->at({2.0, 0.2, 120.0}).norm());
    const TurningPass pass = alongTheBar(2.0, 0.2, 10);
    for (const double speed : {0.0, -500.0, std::nan("")}) {
      const auto odd = forcePeaks(TurnedProfile(kSteelBar, 0.1), {&pass, 1}, speed, *law);
      QVERIFY(odd && std::isfinite(odd->force) && std::isfinite(odd->power));
    }
  }

  void canBeCancelled() {
    const auto law = steelLaw();
    JobState state;
    state.cancelled = true;
    const TurningPass pass = alongTheBar(2.0, 0.2, 1000);
    QVERIFY(!forcePeaks(TurnedProfile(kSteelBar, 0.1), {&pass, 1}, kTurnsPerMinute, *law, Progress(state)));
  }
};

HANDWHEEL_TEST(ForcePeaksTest)
#include "ForcePeaksTest.moc"
