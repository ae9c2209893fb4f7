// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SnapShapes.h"
#include "TestClass.h"
#include "haptics/snap/SnapSum.h"

#include <rapidcheck.h>

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kSnapSumStiffness = 0.7;  // N/mm

struct Jump {
  double largest = 0.0;  // N, from one position of the hand to the next
  double peak = 0.0;     // N
};

// The hand goes straight from one position to another, in steps of a servo sample.
template <class Force>
Jump sweep(const Vec3& from, const Vec3& to, int steps, Force force) {
  Jump jump;
  Vec3 before = force(from);
  for (int i = 1; i <= steps; ++i) {
    const Vec3 now = force(from + (to - from) * (static_cast<double>(i) / steps));
    jump.largest = std::max(jump.largest, (now - before).norm());
    jump.peak = std::max(jump.peak, now.norm());
    before = now;
  }
  return jump;
}

// Returns one simplex of each kind, also those without length or area.
std::vector<Simplex> eachKind() {
  const Vec3 a(0, 0, 0), b(3, 1, 0), c(0, 2, 1);
  return {point(a), segment(a, b), face(a, b, c), segment(a, a), face(a, a, a), face(a, b, b), face(a, b, 2.0 * b)};
}

}  // namespace

class SnapSumTest : public QObject {
  Q_OBJECT

 private slots:
  void isTheSum();
  void continuousAcrossOneFeature();
  void springLeapsAtItsBorder();
  void continuousAcrossMany();
  void slopeIsABound();
  void equalFeaturesCount();
  void tellsWhatActs();
  void nothingForNothing();
};

void SnapSumTest::isTheSum() {
  QVERIFY(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    constexpr double scales[] = {1e-3, 1.0, 1e4};
    constexpr double offsets[] = {0.0, 1e3, 1e7};
    const double scale = scales[random() % 3];
    const Vec3 middle = Vec3(1.0, -0.5, 0.25) * offsets[random() % 3];
    const auto simplices = randomSimplices(random, 1 + random() % 60, scale, 0.5 * scale, middle);
    const SnapField field = fieldOf(simplices);
    SnapSum sum;
    for (const SnapShape shape : kSnapShapes) {
      const SnapProfile profile(shape, kSnapSumStiffness, 0.8 * scale);
      const Vec3 hand = middle + randomIn(random, scale);
      const Vec3 expected = sumOf(simplices, shape, kSnapSumStiffness, profile.distance(), hand);
      const SnapResult pull = sum.step(field, profile, hand);
      // The nearest point of a needle is off by a share of its width, and far from the origin by the rounding of the
      // coordinates.
      const double rounded = static_cast<double>(simplices.size()) * 0x1p-50 * hand.norm();
      RC_ASSERT((pull.force - expected).norm() <= 1e-8 * profile.peak() + kSnapSumStiffness * rounded);
      RC_ASSERT(pull.distance == profile.distance());
      RC_ASSERT(pull.proxy == hand);
      RC_ASSERT(!pull.isCutShort);
    }
  }));
}

void SnapSumTest::continuousAcrossOneFeature() {
  const double ls = 1.5;
  std::mt19937 random(5);
  SnapSum sum;
  for (const Simplex& s : eachKind()) {
    const SnapField field = fieldOf({s});
    for (int line = 0; line < 10; ++line) {
      const Vec3 from = s.corners[0] + randomIn(random, 2.5), through = s.corners.back() + randomIn(random, 0.4);
      const Vec3 to = 2.0 * through - from;
      // At 1 kHz: a careful hand at 2 mm/s, a quick one at 100.
      const int steps = static_cast<int>((to - from).norm() / (line % 2 ? 0.1 : 0.002)) + 1;
      for (const SnapShape shape : kSmoothShapes) {
        const SnapProfile profile(shape, kSnapSumStiffness, ls);
        const Jump jump = sweep(from, to, steps, [&](const Vec3& p) { return sum.step(field, profile, p).force; });
        QVERIFY(jump.peak > 0.1 * profile.peak());  // it did go through
        QVERIFY(jump.largest <= slopeByEquation(shape) * kSnapSumStiffness * (to - from).norm() / steps * (1.0 + 1e-9));
      }
    }
  }
}

void SnapSumTest::springLeapsAtItsBorder() {
  const double ls = 1.5, step = 1e-3;
  const SnapField field = fieldOf({point(Vec3::Zero())});
  SnapSum sum;
  const auto jumpOf = [&](SnapShape shape) {
    const SnapProfile profile(shape, kSnapSumStiffness, ls);
    return sweep(Vec3(2, 0, 0), Vec3(1, 0, 0), static_cast<int>(1.0 / step),
                 [&](const Vec3& p) { return sum.step(field, profile, p).force; })
        .largest;
  };
  QVERIFY(std::abs(jumpOf(SnapShape::Spring) - kSnapSumStiffness * ls) <= kSnapSumStiffness * step);
  for (const SnapShape shape : kSmoothShapes) QVERIFY(jumpOf(shape) <= 2.0 * kSnapSumStiffness * step);
}

void SnapSumTest::continuousAcrossMany() {
  QVERIFY(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto simplices = randomSimplices(random, 1 + random() % 60, 3.0, 2.0);
    const SnapField field = fieldOf(simplices);
    SnapSum sum;
    const Vec3 from = randomIn(random, 4.0), to = randomIn(random, 4.0);
    for (const SnapShape shape : kSmoothShapes) {
      const SnapProfile profile(shape, kSnapSumStiffness, 1.5);
      const Jump jump = sweep(from, to, 500, [&](const Vec3& p) { return sum.step(field, profile, p).force; });
      const double bound = slopeByEquation(shape) * kSnapSumStiffness * static_cast<double>(simplices.size());
      RC_ASSERT(jump.largest <= bound * (to - from).norm() / 500.0 * (1.0 + 1e-9));
    }
  }));
}

// Between two positions at both of which the same features act, the force is no steeper than it says.
void SnapSumTest::slopeIsABound() {
  QVERIFY(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto simplices = randomSimplices(random, 1 + random() % 20, 2.0, 2.0);
    const SnapField field = fieldOf(simplices);
    SnapSum sum;
    const Vec3 a = randomIn(random, 3.0), b = a + randomIn(random, 1e-4);
    for (const SnapShape shape : kSmoothShapes) {
      const SnapProfile profile(shape, kSnapSumStiffness, 1.5);
      const SnapResult at = sum.step(field, profile, a), then = sum.step(field, profile, b);
      RC_ASSERT((then.force - at.force).norm() <=
                std::max(at.slope, then.slope) * (b - a).norm() * (1.0 + 1e-6) + 1e-15);
    }
  }));
}

void SnapSumTest::equalFeaturesCount() {
  const Vec3 a(0, 0, 0), b(3, 1, 0), c(0, 2, 1), hand(0.5, 0.6, 0.7);
  std::vector<Simplex> simplices;
  for (int i = 0; i < 300; ++i) {
    simplices.push_back(point(a));
    simplices.push_back(i % 2 ? segment(a, b) : segment(b, a));
    simplices.push_back(i % 3 == 0 ? face(a, b, c) : i % 3 == 1 ? face(c, a, b) : face(c, b, a));
  }
  const SnapField field = fieldOf(simplices);
  SnapSum sum;
  for (const SnapShape shape : kSnapShapes) {
    const SnapProfile profile(shape, kSnapSumStiffness, 1.5);
    const SnapResult pull = sum.step(field, profile, hand);
    const Vec3 expected = sumOf(simplices, shape, kSnapSumStiffness, 1.5, hand);
    QVERIFY((pull.force - expected).norm() <= 1e-12 * expected.norm());
    QCOMPARE(pull.slope, 900.0 * profile.largestSlope());
    QCOMPARE(pull.distance, 1.5);
  }
}

void SnapSumTest::tellsWhatActs() {
  QVERIFY(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto simplices = randomSimplices(random, 1 + random() % 30, 2.0, 1.0);
    const Vec3 hand = randomIn(random, 2.0);
    const SnapProfile profile(SnapShape::Quadratic, kSnapSumStiffness, 1.5);
    SnapSum sum;
    const SnapResult pull = sum.step(fieldOf(simplices), profile, hand);
    std::vector<std::pair<double, std::uint32_t>> strongest;
    for (std::uint32_t i = 0; i < simplices.size(); ++i) {
      const Real x = distanceTo(simplices[i], hand);
      if (const Real force = forceByEquation(profile.shape(), kSnapSumStiffness, 1.5, x); force > 0)
        strongest.emplace_back(-static_cast<double>(force), i);
    }
    std::sort(strongest.begin(), strongest.end());
    RC_ASSERT(pull.featureCount == std::min(strongest.size(), SnapResult::kShown));
    RC_ASSERT(std::abs(pull.slope - 2.0 * kSnapSumStiffness * static_cast<double>(strongest.size())) <= 1e-9);
    for (std::uint32_t i = 0; i < pull.featureCount; ++i) {
      RC_ASSERT(pull.features[i].id == strongest[i].second);
      RC_ASSERT(pull.features[i].kind == simplices[strongest[i].second].kind);
    }
  }));
}

void SnapSumTest::nothingForNothing() {
  using Limits = std::numeric_limits<double>;
  SnapSum sum;
  const SnapProfile profile(SnapShape::Triangular, kSnapSumStiffness, 1.5);
  const SnapField field = fieldOf({point(Vec3(1, 1, 1))});
  QCOMPARE(sum.step(SnapField(), profile, Vec3(1, 2, 3)).force, Vec3(0, 0, 0));
  QCOMPARE(sum.step(field, SnapProfile(), Vec3(1, 1, 1.5)).force, Vec3(0, 0, 0));
  QCOMPARE(sum.step(field, profile, Vec3(1, 1, 1)).force, Vec3(0, 0, 0));  // at the feature itself
  QCOMPARE(sum.step(field, profile, Vec3(1, 1, 1)).featureCount, 1u);
  for (const double bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Limits::max(), 1e200}) {
    const SnapResult pull = sum.step(field, profile, Vec3(1, bad, 1));
    QCOMPARE(pull.force, Vec3(0, 0, 0));
    QCOMPARE(pull.slope, 0.0);
    QCOMPARE(pull.featureCount, 0u);
  }
}

HANDWHEEL_TEST(SnapSumTest)
#include "SnapSumTest.moc"
