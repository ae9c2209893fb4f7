// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/measure/ProfileMeasure.h"

#include "TestClass.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>
#include <functional>
#include <limits>

using namespace handwheel;

namespace {

constexpr double kSpacing = 0.02;  // mm
constexpr double kLength = 100.0;

// A part whose radii are given as functions of z.
TurnedProfile partOf(const std::function<double(double)>& outer, const std::function<double(double)>& inner = {}) {
  const auto count = static_cast<std::size_t>(std::lround(kLength / kSpacing)) + 1;
  std::vector<double> radii(count), bore(inner ? count : 0);
  for (std::size_t i = 0; i < count; ++i) {
    const double z = kLength * static_cast<double>(i) / static_cast<double>(count - 1);
    radii[i] = outer(z);
    if (inner) bore[i] = inner(z);
  }
  return inner ? TurnedProfile::fromRadii(radii, bore, kLength) : TurnedProfile::fromRadii(radii, kLength);
}

// ⌀40 to z 40, ⌀30 to 70, ⌀20 to the end, bored ⌀10 from 80 on.
TurnedProfile steppedShaft() {
  return partOf([](double z) { return z < 40.0   ? 20.0
                                      : z < 70.0 ? 15.0
                                                 : 10.0; },
                [](double z) { return z < 80.0 ? 0.0 : 5.0; });
}

double chosen(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

}  // namespace

// Dimensions of parts whose sizes are known.
class ProfileMeasureTest : public QObject {
  Q_OBJECT

 private slots:
  void diameters() {
    const TurnedProfile part = steppedShaft();
    const auto middle = measureDiameter(part, TurningSide::Outside, {45, 65});
    QVERIFY(middle && middle->least == 30.0 && middle->largest == 30.0 && std::abs(middle->mean - 30.0) < 1e-12);
    const auto across = measureDiameter(part, TurningSide::Outside, {65, 75});
    QVERIFY(across && across->least == 20.0 && across->largest == 30.0);
    QVERIFY(across->leastAt >= 70.0 - kSpacing && across->largestAt <= 70.0);
    const auto bore = measureDiameter(part, TurningSide::Bore, {85, 95});
    QVERIFY(bore && bore->least == 10.0 && bore->largest == 10.0);
    QVERIFY(!measureDiameter(part, TurningSide::Bore, {75, 95}));  // partly solid
    QVERIFY(!measureDiameter(part, TurningSide::Outside, {101, 110}));
    QVERIFY(!measureDiameter(part, TurningSide::Outside, {60, 50}));
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    QVERIFY(!measureDiameter(part, TurningSide::Outside, {nan, 50}));
    QVERIFY(!measureDiameter(part, TurningSide::Outside, {10, nan}));
    QCOMPARE(measureDiameter(part, TurningSide::Outside, {-inf, inf})->largest, 40.0);
  }

  // A face stands between two samples.
  void lengthsBetweenFaces() {
    const TurnedProfile part = steppedShaft();
    const auto low = measureFace(part, TurningSide::Outside, 17.0, 40.0, 1.0);
    const auto high = measureFace(part, TurningSide::Outside, 12.0, 70.0, 1.0);
    QVERIFY(low && high);
    QVERIFY(std::abs(*high - *low - 30.0) <= kSpacing);
    QCOMPARE(measureFace(part, TurningSide::Outside, 5.0, 0.0, 1.0).value(), 0.0);
    QCOMPARE(measureFace(part, TurningSide::Outside, 5.0, 99.5, 1.0).value(), kLength);
    QVERIFY(std::abs(measureFace(part, TurningSide::Bore, 2.0, 80.0, 1.0).value() - 80.0) <= kSpacing);
    QVERIFY(!measureFace(part, TurningSide::Outside, 17.0, 60.0, 1.0));
    QVERIFY(!measureFace(part, TurningSide::Outside, 25.0, 40.0, 200.0));
    QVERIFY(!measureFace(part, TurningSide::Outside, std::nan(""), 40.0, 200.0));
    QVERIFY(!measureFace(part, TurningSide::Outside, 17.0, std::nan(""), 200.0));
  }

  // A faced part ends below its bar, and a taper is met where it has the radius.
  void facesOfShorterParts() {
    const TurnedProfile part = partOf([](double z) { return z > 90.0 ? 0.0 : 20.0 - 0.1 * z; });
    QVERIFY(std::abs(measureFace(part, TurningSide::Outside, 5.0, 90.0, 2.0).value() - 90.0) <= kSpacing);
    QVERIFY(std::abs(measureFace(part, TurningSide::Outside, 16.0, 41.0, 5.0).value() - 40.0) < 1e-9);
  }

  void arcsOfEveryRadius() {
    QVERIFY(rc::check("a sphere is measured where it is", [] {
      const double radius = chosen(3.0, 40.0), centre = chosen(45.0, 55.0), axis = chosen(0.0, 5.0);
      const double half = chosen(0.3, 0.95) * radius;
      const TurnedProfile part = partOf([&](double z) {
        const double under = radius * radius - (z - centre) * (z - centre);
        return axis + (under > 0.0 ? std::sqrt(under) : 0.0) + 0.1;
      });
      const auto arc = measureArc(part, TurningSide::Outside, {centre - half, centre + half});
      RC_ASSERT(arc.has_value());
      RC_ASSERT(std::abs(arc->radius - radius) < 1e-6 * radius);
      RC_ASSERT(std::abs(arc->centre.y() - centre) < 1e-6 * radius);
      RC_ASSERT(std::abs(arc->centre.x() - axis - 0.1) < 1e-6 * radius);
      RC_ASSERT(arc->deviation < 1e-6 * radius);
    }));
    QVERIFY(!measureArc(steppedShaft(), TurningSide::Outside, {10, 30}));     // straight
    QVERIFY(!measureArc(steppedShaft(), TurningSide::Outside, {10, 10.01}));  // a point
  }

  void partsWithoutMaterial() {
    const TurnedProfile nothing = TurnedProfile::fromRadii({0.0, 0.0, 0.0}, 2.0);
    QVERIFY(!measureDiameter(nothing, TurningSide::Outside, {0, 2}));
    QVERIFY(!measureFace(nothing, TurningSide::Outside, 1.0, 1.0, 5.0));
    QVERIFY(!measureArc(nothing, TurningSide::Outside, {0, 2}));
  }
};

HANDWHEEL_TEST(ProfileMeasureTest)
#include "ProfileMeasureTest.moc"
