// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/TurnedProfile.h"

#include "TestClass.h"
#include "machining/TurningPass.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr StockCylinder kProfileBar{40.0, 100.0, 0.0};

double between(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

ProfilePoint anyPosition() {
  return {between(-5.0, 40.0), between(-10.0, 110.0)};
}

// The definition: the lowest point at z of discs at very many positions of the path.
double envelope(const ProfilePoint& a, const ProfilePoint& b, double radius, double z) {
  constexpr int kSamples = 20000;
  double lowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kSamples; ++i) {
    const ProfilePoint c = a + static_cast<double>(i) / kSamples * (b - a);
    const double under = radius * radius - (z - c.y()) * (z - c.y());
    if (under >= 0.0) lowest = std::min(lowest, c.x() - std::sqrt(under));
  }
  return lowest;
}

}  // namespace

class TurnedProfileTest : public QObject {
  Q_OBJECT

 private slots:
  void anUncutBar() {
    const TurnedProfile bar(kProfileBar, 0.3);
    QVERIFY(bar.spacing() <= 0.3);
    QCOMPARE(bar.length(), 100.0);
    QVERIFY(std::abs(bar.volume() / kProfileBar.volume() - 1.0) < 1e-12);
    QVERIFY(std::abs(bar.area() / kProfileBar.area() - 1.0) < 1e-12);
    const TurnedProfile cone = TurnedProfile::fromRadii({3.0, 0.0}, 4.0);
    QVERIFY(std::abs(cone.volume() - M_PI * 12.0) < 1e-12 && std::abs(cone.area() - M_PI * 24.0) < 1e-12);
    // The coarsest and the finest spacing.
    QCOMPARE(TurnedProfile(kProfileBar, 1e9).size(), std::size_t{2});
    QCOMPARE(TurnedProfile({1.0, 1e6, 0.0}, 1e-6).size(), TurnedProfile::kMostSamples);
  }

  // A bar with the samples of a part is that from which it was cut, to the last bit, in all whole lengths.
  void theBarOfAPart() {
    for (const double spacing : {0.05, 0.013, 0.01}) {
      for (int length = 5; length <= 1000; ++length) {
        const StockCylinder stock{40.0, static_cast<double>(length), 3.0};
        const TurnedProfile bar(stock, spacing);
        QVERIFY2(TurnedProfile::barOf(stock, bar.size()) == bar, qPrintable(QString::number(length)));
      }
    }
  }

  void countsItsPieces() {
    QCOMPARE(TurnedProfile::fromRadii({3.0, 1.0, 2.0}, 4.0).pieces().size(), std::size_t{1});
    QCOMPARE(TurnedProfile::fromRadii({0.0, 1.0, 0.0}, 4.0).pieces().size(), std::size_t{1});
    QCOMPARE(TurnedProfile::fromRadii({1.0, 0.0, 0.0, 2.0, 0.0, 1.0}, 4.0).pieces().size(), std::size_t{3});
    QCOMPARE(TurnedProfile::fromRadii({0.0, 0.0}, 4.0).pieces().size(), std::size_t{0});
  }

  // A straight pass leaves a cylinder; the removed ring and the two quarter circles of the nose are known.
  void aStraightPass() {
    TurnedProfile part(kProfileBar, 0.01);
    const double nose = 2.0, depth = 3.0;
    part.cut({20.0 - depth + nose, 30.0}, {20.0 - depth + nose, 60.0}, nose);
    for (const double z : {30.0, 45.0, 60.0}) {
      QVERIFY(std::abs(part.radius(static_cast<std::size_t>(std::lround(z / part.spacing()))) - 17.0) < 1e-12);
    }
    QCOMPARE(part.radius(0), 20.0);
    const double ring = M_PI * (20.0 * 20.0 - 17.0 * 17.0) * 30.0;
    // The ends by numerical integration of the definition.
    double ends = 0.0;
    constexpr int kSlices = 200000;
    for (int i = 0; i < kSlices; ++i) {
      const double x = nose * (i + 0.5) / kSlices;
      const double r = std::min(20.0, 19.0 - std::sqrt(nose * nose - x * x));
      ends += 2.0 * M_PI * (400.0 - r * r) * nose / kSlices;
    }
    QVERIFY(std::abs((kProfileBar.volume() - part.volume()) / (ring + ends) - 1.0) < 1e-4);
  }

  void cutsTheEnvelopeOfTheSweep() {
    QVERIFY(rc::check("what is left is the lower envelope of all discs", [] {
      TurnedProfile part(kProfileBar, 2.0);
      const ProfilePoint a = anyPosition(), b = anyPosition();
      const double nose = between(0.2, 8.0);
      const TurnedProfile before = part;
      const TurnedProfile::Range changed = part.cut(a, b, nose);
      for (std::size_t i = 0; i < part.size(); ++i) {
        const double expected = std::max(0.0, std::min(20.0, envelope(a, b, nose, part.z(i))));
        // Between two of these positions the envelope is lower, most so at the flanks.
        RC_ASSERT(part.radius(i) <= expected + 1e-12);
        RC_ASSERT(part.radius(i) >= expected - 0.35);
        RC_ASSERT((part.radius(i) != before.radius(i)) ==
                  (i >= changed.first && i < changed.last && part.radius(i) < 20.0));
      }
      RC_ASSERT(before == TurnedProfile(kProfileBar, 2.0));  // a copy is not touched
    }));
  }

  void materialOnlyLeaves() {
    QVERIFY(rc::check("radii never grow, never fall below zero, and a second pass removes nothing", [] {
      TurnedProfile part(kProfileBar, 1.0);
      TurningPass pass;
      pass.noseRadius = between(0.5, 5.0);
      for (int i = 0; i < 6; ++i) pass.path.push_back(anyPosition());
      double volume = part.volume();
      for (int i = 0; i < 2; ++i) {
        cut(part, pass);
        RC_ASSERT(part.volume() <= volume);
        volume = part.volume();
      }
      const TurnedProfile once = part;
      RC_ASSERT(cut(part, pass).isEmpty());
      RC_ASSERT(part == once);
      for (std::size_t i = 0; i < part.size(); ++i) RC_ASSERT(part.radius(i) >= 0.0 && part.radius(i) <= 20.0);
    }));
  }

  void nothingOfNoNumber() {
    TurnedProfile part(kProfileBar, 1.0);
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf}) {
      QVERIFY(part.cut({bad, 50}, {10, 50}, 1.0).isEmpty());
      QVERIFY(part.cut({10, 50}, {10, bad}, 1.0).isEmpty());
    }
    QVERIFY(part.cut({10, 50}, {10, 60}, nan).isEmpty());
    QVERIFY(part.cut({10, 50}, {10, 60}, 0.0).isEmpty());
    QVERIFY(part.cut({10, 1e300}, {10, 1e301}, 1.0).isEmpty());
    QVERIFY(part == TurnedProfile(kProfileBar, 1.0));
    part.cut({-1e9, -1e9}, {-1e9, 1e9}, 1e8);  // all of it
    QCOMPARE(part.volume(), 0.0);
  }
};

HANDWHEEL_TEST(TurnedProfileTest)
#include "TurnedProfileTest.moc"
