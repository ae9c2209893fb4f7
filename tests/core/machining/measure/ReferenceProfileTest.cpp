// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/measure/ReferenceProfile.h"

#include "TestClass.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr double kEverywhere = std::numeric_limits<double>::infinity();
constexpr AxisRange kAll{-kEverywhere, kEverywhere};

// ⌀40, from z 50 on ⌀30; bored ⌀10 from 60 on. 100 mm long.
ReferenceProfile steppedTarget() {
  return *ReferenceProfile::make({{20, 0}, {20, 50}, {15, 50}, {15, 100}}, {{0, 60}, {5, 60}, {5, 100}});
}

TurnedProfile turned(double outerError, double boreError, double length = 100.0) {
  constexpr std::size_t kCount = 5001;
  std::vector<double> radii(kCount), inner(kCount);
  for (std::size_t i = 0; i < kCount; ++i) {
    const double z = 100.0 * static_cast<double>(i) / (kCount - 1);
    radii[i] = z > length ? 0.0 : z < 50.0 ? 20.0 : 15.0 + outerError;
    inner[i] = z < 60.0 || z > length ? 0.0 : 5.0 + boreError;
  }
  return TurnedProfile::fromRadii(radii, inner, 100.0);
}

}  // namespace

// The deviation of parts from the shape that they are to have.
class ReferenceProfileTest : public QObject {
  Q_OBJECT

 private slots:
  void theExactPart() {
    const ReferenceDeviation deviation = deviationFrom(steppedTarget(), turned(0, 0), kAll);
    QVERIFY(deviation.largest() <= 0.02 + 1e-9);  // of a face between two samples
  }

  void tooMuchAndTooLittle() {
    const ReferenceDeviation left = deviationFrom(steppedTarget(), turned(0.3, 0.0), {55, 95});
    QVERIFY(std::abs(left.left - 0.3) < 1e-9 && left.gouged < 1e-9);
    const ReferenceDeviation gouged = deviationFrom(steppedTarget(), turned(-0.2, 0.0), {55, 95});
    QVERIFY(std::abs(gouged.gouged - 0.2) < 1e-9 && gouged.left < 1e-9);
    const ReferenceDeviation wide = deviationFrom(steppedTarget(), turned(0.0, 0.1), {65, 95});
    QVERIFY(std::abs(wide.gouged - 0.1) < 1e-9 && wide.left < 1e-9);
    const ReferenceDeviation narrow = deviationFrom(steppedTarget(), turned(0.0, -0.1), {65, 95});
    QVERIFY(std::abs(narrow.left - 0.1) < 1e-9 && narrow.gouged < 1e-9);
    // The range leaves out the rest.
    QVERIFY(deviationFrom(steppedTarget(), turned(0.3, 0.0), {5, 45}).largest() < 1e-9);
  }

  // Too short a part has lost the end, by as much as is missing.
  void tooShort() {
    const ReferenceDeviation deviation = deviationFrom(steppedTarget(), turned(0, 0, 98.0), {70, 100});
    QVERIFY(std::abs(deviation.gouged - 2.0) < 0.03);
    const ReferenceProfile shorter =
        *ReferenceProfile::make({{20, 0}, {20, 50}, {15, 50}, {15, 98}}, {{0, 60}, {5, 60}, {5, 98}});
    const ReferenceDeviation longer = deviationFrom(shorter, turned(0, 0), {70, 100});
    QVERIFY(std::abs(longer.left - 2.0) < 0.03);
  }

  void aSolidPartThatShouldBeBored() {
    const TurnedProfile solid = TurnedProfile::fromRadii({15.0, 15.0, 15.0, 15.0}, 100.0);
    const ReferenceProfile tube = *ReferenceProfile::make({{15, 0}, {15, 100}}, {{5, 0}, {5, 100}});
    QVERIFY(std::abs(deviationFrom(tube, solid, kAll).left - 5.0) < 1e-9);
    const ReferenceProfile bar = *ReferenceProfile::make({{15, 0}, {15, 100}}, {});
    const TurnedProfile bored = TurnedProfile::fromRadii({15.0, 15.0}, {4.0, 4.0}, 100.0);
    QVERIFY(std::abs(deviationFrom(bar, bored, kAll).gouged - 4.0) < 1e-9);
  }

  // The distance by trying very many points of every line.
  void theNearestPoint() {
    const ReferenceProfile target = *ReferenceProfile::make({{3, 0}, {9, 2}, {9, 7}, {4, 7}, {4, 9}, {12, 20}}, {});
    std::vector<ProfilePoint> closed = target.outer();
    closed.insert(closed.begin(), ProfilePoint(0, 0));
    closed.emplace_back(0.0, 20.0);
    for (int k = 0; k < 400; ++k) {
      const ProfilePoint p(0.7 * (k % 20), -2.0 + 1.2 * (k / 20));
      double best = kEverywhere;
      for (std::size_t i = 0; i + 1 < closed.size(); ++i) {
        for (int t = 0; t <= 2000; ++t)
          best = std::min(best, (p - closed[i] - t / 2000.0 * (closed[i + 1] - closed[i])).norm());
      }
      QVERIFY(std::abs(target.distance(TurningSide::Outside, p) - best) < 0.01);
    }
  }

  void whatIsNoTarget() {
    const auto refuses = [](std::vector<ProfilePoint> outer, std::vector<ProfilePoint> inner) {
      return !ReferenceProfile::make(std::move(outer), std::move(inner));
    };
    QVERIFY(refuses({}, {}));
    QVERIFY(refuses({{1, 0}}, {}));
    QVERIFY(refuses({{1, 0}, {1, 0}}, {}));
    QVERIFY(refuses({{1, 0}, {-1, 5}}, {}));
    QVERIFY(refuses({{1, 5}, {1, 0}}, {}));
    QVERIFY(refuses({{1, 0}, {std::nan(""), 5}}, {}));
    QVERIFY(refuses({{1, 0}, {1, kEverywhere}}, {}));
    QVERIFY(refuses({{1, 0}, {1, 1e300}}, {}));
    QVERIFY(refuses({{1, 0}, {1, 5}}, {{0.5, 0}}));
    QVERIFY(refuses({{1, 0}, {1, 5}}, {{2, 0}, {2, 5}}));
    QVERIFY(refuses({{1, 0}, {1, 5}}, {{0.5, 0}, {0.5, 6}}));
    QVERIFY(refuses(std::vector<ProfilePoint>(ReferenceProfile::kMostPoints + 1, {1, 0}), {}));
  }
};

HANDWHEEL_TEST(ReferenceProfileTest)
#include "ReferenceProfileTest.moc"
