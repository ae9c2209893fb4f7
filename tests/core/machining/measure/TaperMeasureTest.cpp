// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/measure/TaperMeasure.h"

#include "TestClass.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>
#include <functional>

using namespace handwheel;

namespace {

constexpr double kTaperSpacing = 0.02, kTaperLength = 100.0, kTaperDegree = M_PI / 180.0;  // mm

TurnedProfile tapered(const std::function<double(double)>& outer) {
  std::vector<double> radii(static_cast<std::size_t>(std::lround(kTaperLength / kTaperSpacing)) + 1);
  for (std::size_t i = 0; i < radii.size(); ++i)
    radii[i] = outer(kTaperLength * static_cast<double>(i) / static_cast<double>(radii.size() - 1));
  return TurnedProfile::fromRadii(radii, kTaperLength);
}

double amongTapers(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

bool isAboutAngle(const std::optional<TaperReading>& taper, double degrees, double within) {
  return taper && std::abs(taper->angle / kTaperDegree - degrees) <= within;
}

}  // namespace

// Tapers of parts whose angles are known.
class TaperMeasureTest : public QObject {
  Q_OBJECT

 private slots:
  void cones() {
    QVERIFY(rc::check("a cone has its angle", [] {
      const double angle = amongTapers(-0.15, 0.15);
      const TurnedProfile part = tapered([&](double z) { return 20.0 + std::tan(angle) * (z - 50.0); });
      const auto taper = measureTaper(part, TurningSide::Outside, {20, 80});
      RC_ASSERT(taper && std::abs(taper->angle - angle) < 1e-12 && taper->deviation < 1e-9);
    }));
    const TurnedProfile bar = tapered([](double) { return 20.0; });
    QVERIFY(!measureTaper(bar, TurningSide::Outside, {10, 10}));
    QVERIFY(!measureTaper(bar, TurningSide::Bore, {10, 20}));
    QVERIFY(!measureTaper(TurnedProfile::fromRadii({0.0, 0.0, 0.0}, 2.0), TurningSide::Outside, {0, 2}));
    QVERIFY(isAboutAngle(measureTaper(bar, TurningSide::Outside, {10, 90}), 0.0, 1e-9));
  }

  // A chamfer between two cylinders, wherever the range begins and ends beside it.
  void aRangeBeyondTheEnds() {
    QVERIFY(rc::check("the cylinders beside a taper do not count", [] {
      const double angle = amongTapers(3.0, 60.0) * (*rc::gen::element(-1.0, 1.0)), height = amongTapers(1.5, 5.0);
      const double from = amongTapers(30.0, 60.0), rise = std::tan(angle * kTaperDegree);
      const TurnedProfile part =
          tapered([&](double z) { return 20.0 + rise * (std::clamp(z, from, from + height) - from - 2.5); });
      const auto taper = measureTaper(part, TurningSide::Outside,
                                      {from - amongTapers(0.0, 4.0), from + height + amongTapers(0.0, 4.0)});
      RC_ASSERT(isAboutAngle(taper, angle, 0.02 * std::abs(angle)));
      RC_ASSERT(taper->range.from >= from - 3 * kTaperSpacing && taper->range.to <= from + height + 3 * kTaperSpacing);
    }));
  }

  // 2 × 45° at the end of a part that was faced to 90 mm, behind a shoulder.
  void aChamferAtTheEnd() {
    const TurnedProfile part = tapered([](double z) {
      return z > 90.0 ? 0.0 : z < 80.0 ? 20.0 : 15.0 - std::max(0.0, z - 88.0);
    });
    QVERIFY(isAboutAngle(measureTaper(part, TurningSide::Outside, {88.2, 89.8}), -45.0, 1e-6));
    QVERIFY(isAboutAngle(measureTaper(part, TurningSide::Outside, {86.0, 90.0}), -45.0, 0.5));
    QVERIFY(isAboutAngle(measureTaper(part, TurningSide::Outside, {78.0, 95.0}), -45.0, 0.5));
  }

  // A hand wavers: a taper that is a little round is still one taper, along all of its range.
  void aTaperTurnedByHand() {
    const double rise = std::tan(5.0 * kTaperDegree);
    const TurnedProfile part = tapered(
        [&](double z) { return 10.0 + rise * (z - 20.0) + 0.03 * std::sin(0.4 * z) - 2e-4 * (z - 50.0) * (z - 50.0); });
    const auto taper = measureTaper(part, TurningSide::Outside, {40, 60});
    QVERIFY(isAboutAngle(taper, 5.0, 0.3));
    QVERIFY(taper->range.from < 40.1 && taper->range.to > 59.9);
    const TurnedProfile wavy = tapered([](double z) { return 20.0 + 0.01 * std::sin(z); });
    QVERIFY(isAboutAngle(measureTaper(wavy, TurningSide::Outside, {20, 80}), 0.0, 0.05));
  }
};

HANDWHEEL_TEST(TaperMeasureTest)
#include "TaperMeasureTest.moc"
