// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "machining/TurnedProfile.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr StockCylinder kBush{40.0, 60.0, 0.0};

double anyBetween(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

struct Extent {
  double lowest = std::numeric_limits<double>::infinity(), highest = -std::numeric_limits<double>::infinity();
};

// The definition: the lowest and the highest point at z of discs at very many positions of the path.
Extent extentAt(const ProfilePoint& a, const ProfilePoint& b, double radius, double z) {
  constexpr int kSamples = 20000;
  Extent extent;
  for (int i = 0; i <= kSamples; ++i) {
    const ProfilePoint c = a + static_cast<double>(i) / kSamples * (b - a);
    const double under = radius * radius - (z - c.y()) * (z - c.y());
    if (!(under >= 0.0)) continue;
    extent.lowest = std::min(extent.lowest, c.x() - std::sqrt(under));
    extent.highest = std::max(extent.highest, c.x() + std::sqrt(under));
  }
  return extent;
}

}  // namespace

class BoreTest : public QObject {
  Q_OBJECT

 private slots:
  void aStockHasNone() {
    const TurnedProfile bar(kBush, 1.0);
    QVERIFY(!bar.isBored());
    for (std::size_t i = 0; i < bar.size(); ++i) QCOMPARE(bar.inner(i), 0.0);
  }

  // A tube: volume and surface in closed form.
  void throughBore() {
    TurnedProfile tube(kBush, 0.5);
    for (std::size_t i = 0; i < tube.size(); ++i) QVERIFY(tube.limitInner(i, 12.0));
    QVERIFY(std::abs(tube.volume() / (M_PI * (400.0 - 144.0) * 60.0) - 1.0) < 1e-12);
    QVERIFY(std::abs(tube.area() / (2.0 * M_PI * (20.0 + 12.0) * 60.0 + 2.0 * M_PI * (400.0 - 144.0)) - 1.0) < 1e-12);
    QCOMPARE(tube.pieces().size(), std::size_t{1});
  }

  // A blind conical bore of radius 10 at the upper end and 0 at mid-length.
  void blindBore() {
    TurnedProfile part(kBush, 0.5);
    for (std::size_t i = 0; i < part.size(); ++i) part.limitInner(i, (part.z(i) - 30.0) / 3.0);
    QVERIFY(part.isBored());
    QCOMPARE(part.inner(0), 0.0);
    QVERIFY(std::abs(part.volume() / (kBush.volume() - M_PI * 100.0 * 30.0 / 3.0) - 1.0) < 1e-12);
    const double area = kBush.area() - M_PI * 100.0 + M_PI * 10.0 * std::hypot(10.0, 30.0);
    QVERIFY(std::abs(part.area() / area - 1.0) < 1e-12);
  }

  void boreMeetsOutside() {
    TurnedProfile part(kBush, 1.0);
    for (std::size_t i = 0; i < part.size(); ++i) part.limitInner(i, 8.0);
    QVERIFY(part.limitOuter(30, 5.0));  // deeper than the wall
    QCOMPARE(part.radius(30), 8.0);
    QVERIFY(!part.hasMaterial(30));
    QCOMPARE(part.pieces().size(), std::size_t{2});
    QVERIFY(part.limitInner(10, 25.0));  // further out than the wall
    QCOMPARE(part.inner(10), 20.0);
    QCOMPARE(part.pieces().size(), std::size_t{3});
    QVERIFY(!part.limitInner(10, 25.0));
    QVERIFY(!part.limitOuter(30, 1.0));
    for (std::size_t i = 0; i < part.size(); ++i) part.limitInner(i, 1e300);
    QCOMPARE(part.pieces().size(), std::size_t{0});
    QCOMPARE(part.volume(), 0.0);
    QCOMPARE(part.area(), 0.0);
  }

  void boresTheEnvelopeOfTheSweep() {
    QVERIFY(rc::check("what is left begins at the upper envelope of all discs", [] {
      TurnedProfile part(kBush, 2.0);
      const ProfilePoint a(anyBetween(-5.0, 30.0), anyBetween(-10.0, 70.0)),
          b(anyBetween(-5.0, 30.0), anyBetween(-10.0, 70.0));
      const double nose = anyBetween(0.2, 8.0);
      const TurnedProfile before = part;
      const TurnedProfile::Range changed = part.cutBore(a, b, nose);
      for (std::size_t i = 0; i < part.size(); ++i) {
        const Extent extent = extentAt(a, b, nose, part.z(i));
        // Between two of these positions the envelope is wider, most so at the flanks.
        constexpr double kFlank = 0.35;
        if (extent.lowest >= 20.0 && extent.lowest < 20.0 + kFlank) continue;
        // A disc outside of the part leaves it.
        const double expected = extent.lowest >= 20.0 ? 0.0 : std::min(20.0, std::max(0.0, extent.highest));
        RC_ASSERT(part.inner(i) >= expected - 1e-12);
        RC_ASSERT(part.inner(i) <= expected + kFlank);
        RC_ASSERT(part.radius(i) == 20.0);
        const bool isIn = i >= changed.first && i < changed.last;
        RC_ASSERT((part.inner(i) != before.inner(i)) == (isIn && part.inner(i) > 0.0));
      }
      RC_ASSERT(before == TurnedProfile(kBush, 2.0));  // a copy is not touched
    }));
  }

  void materialOnlyLeaves() {
    QVERIFY(rc::check("in any order of limits and cuts, from both sides", [] {
      TurnedProfile part(kBush, 1.0);
      for (int step = 0; step < 30; ++step) {
        const TurnedProfile before = part;
        const ProfilePoint a(anyBetween(-5.0, 30.0), anyBetween(-10.0, 70.0)),
            b(anyBetween(-5.0, 30.0), anyBetween(-10.0, 70.0));
        const double nose = anyBetween(0.2, 5.0);
        const std::size_t i = std::min(part.size() - 1, static_cast<std::size_t>(anyBetween(0.0, 61.0)));
        switch (*rc::gen::inRange(0, 4)) {
          case 0:
            part.cut(a, b, nose);
            break;
          case 1:
            part.cutBore(a, b, nose);
            break;
          case 2: {
            const bool isChanged = part.limitOuter(i, a.x());
            RC_ASSERT(isChanged == (part.radius(i) != before.radius(i)));
            break;
          }
          default: {
            const bool isChanged = part.limitInner(i, a.x());
            RC_ASSERT(isChanged == (part.inner(i) != before.inner(i)));
          }
        }
        for (std::size_t k = 0; k < part.size(); ++k) {
          RC_ASSERT(part.radius(k) <= before.radius(k) && part.inner(k) >= before.inner(k));
          RC_ASSERT(part.inner(k) >= 0.0 && part.inner(k) <= part.radius(k));
        }
        RC_ASSERT(part.volume() <= before.volume() * (1.0 + 1e-12));
      }
    }));
  }

  void nothingOfNoNumber() {
    TurnedProfile part(kBush, 1.0);
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf}) {
      QVERIFY(!part.limitOuter(3, bad));
      QVERIFY(!part.limitInner(3, bad));
      QVERIFY(part.cutBore({bad, 30}, {10, 30}, 1.0).isEmpty());
      QVERIFY(part.cutBore({10, 30}, {10, bad}, 1.0).isEmpty());
    }
    QVERIFY(part.cutBore({10, 30}, {10, 40}, nan).isEmpty());
    QVERIFY(part.cutBore({10, 30}, {10, 40}, 0.0).isEmpty());
    QVERIFY(!part.limitInner(3, 0.0));
    QVERIFY(!part.limitInner(3, -1.0));
    QVERIFY(!part.limitOuter(3, 20.0));
    QVERIFY(part == TurnedProfile(kBush, 1.0));
    QVERIFY(part.limitInner(3, 1e-9));
    QVERIFY(!(part == TurnedProfile(kBush, 1.0)));
    QVERIFY(part.limitOuter(3, 20.0 - 1e-9));
  }

  void fromSavedRadii() {
    const TurnedProfile part = TurnedProfile::fromRadii({3.0, 2.0, 2.0}, {1.0, 2.0, 0.0}, 4.0);
    QCOMPARE(part.inner(0), 1.0);
    QCOMPARE(part.inner(1), 2.0);
    QCOMPARE(part.inner(2), 0.0);
    QCOMPARE(part.pieces().size(), std::size_t{2});
    QVERIFY(TurnedProfile::fromRadii({3.0, 2.0}, {0.0, 0.0}, 4.0) == TurnedProfile::fromRadii({3.0, 2.0}, 4.0));
  }
};

HANDWHEEL_TEST(BoreTest)
#include "BoreTest.moc"
