// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SnapShapes.h"
#include "TestClass.h"
#include "haptics/snap/SnapProxy.h"
#include "haptics/snap/SnapSum.h"

#include <rapidcheck.h>

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kStiffness = 0.7;  // N/mm
constexpr double kDistance = 2.0;   // mm, within which thousands of features lie

std::vector<double> distancesTo(const std::vector<Simplex>& simplices, const Vec3& hand) {
  std::vector<double> distances;
  for (const Simplex& s : simplices) distances.push_back(static_cast<double>(distanceTo(s, hand)));
  std::sort(distances.begin(), distances.end());
  return distances;
}

}  // namespace

// Cases with more features in reach than may act.
class SnapCrowdTest : public QObject {
  Q_OBJECT

 private slots:
  void shrinksToTheFirstLeftOut();
  void continuousInTheCrowd();
  void continuousIntoTheCrowd();
  void almostAtOnePoint();
  void proxyHoldsTheNearest();
  void longOnesAcrossEachOther();
};

void SnapCrowdTest::shrinksToTheFirstLeftOut() {
  std::mt19937 random(1);
  const auto simplices = randomSimplices(random, 3000, 1.0, 0.2);
  const SnapField field = fieldOf(simplices);
  for (const std::size_t most : {std::size_t{1}, std::size_t{16}, SnapSum::kMost, std::size_t{500}}) {
    SnapSum sum(most);
    for (int i = 0; i < 50; ++i) {
      const Vec3 hand = randomIn(random, 1.0);
      const double expected = distancesTo(simplices, hand)[most];
      for (const SnapShape shape : kSmoothShapes) {
        const SnapProfile profile(shape, kStiffness, kDistance);
        const SnapResult pull = sum.step(field, profile, hand);
        QVERIFY(!pull.isCutShort);
        QVERIFY(std::abs(pull.distance - expected) <= 1e-9);
        const Vec3 force = sumOf(simplices, shape, kStiffness, expected, hand);
        QVERIFY((pull.force - force).norm() <= 1e-7 * kStiffness);
      }
    }
  }
}

void SnapCrowdTest::continuousInTheCrowd() {
  std::mt19937 random(2);
  const auto simplices = randomSimplices(random, 3000, 1.0, 0.2);
  const SnapField field = fieldOf(simplices);
  constexpr std::size_t most = 16;
  constexpr int steps = 20'000;
  SnapSum sum(most);
  for (const SnapShape shape : kSmoothShapes) {
    const SnapProfile profile(shape, kStiffness, kDistance);
    const Vec3 from = randomIn(random, 1.0), to = randomIn(random, 1.0);
    Vec3 before = sum.step(field, profile, from).force;
    for (int i = 1; i <= steps; ++i) {
      const SnapResult pull = sum.step(field, profile, from + (to - from) * (static_cast<double>(i) / steps));
      const double bound = 2.0 * slopeByEquation(shape) * kStiffness * most * (to - from).norm() / steps;
      QVERIFY((pull.force - before).norm() <= bound);
      QVERIFY(pull.slope <= 2.0 * slopeByEquation(shape) * kStiffness * most);
      before = pull.force;
    }
  }
}

// Moves from few features in reach to thousands.
void SnapCrowdTest::continuousIntoTheCrowd() {
  std::mt19937 random(3);
  const auto simplices = randomSimplices(random, 3000, 1.0, 0.2);
  const SnapField field = fieldOf(simplices);
  constexpr int steps = 20'000;
  SnapSum sum;
  const SnapProfile profile(SnapShape::Gaussian, kStiffness, kDistance);
  const Vec3 from(4.0, 0.3, 0.2), to(0.0, 0.1, 0.0);
  Vec3 before = sum.step(field, profile, from).force;
  QCOMPARE(before, Vec3(0, 0, 0));
  bool wasWhole = false, wasShrunk = false;
  for (int i = 1; i <= steps; ++i) {
    const SnapResult pull = sum.step(field, profile, from + (to - from) * (static_cast<double>(i) / steps));
    QVERIFY((pull.force - before).norm() <= 2.0 * 1.8401 * kStiffness * SnapSum::kMost * (to - from).norm() / steps);
    (pull.distance == kDistance ? wasWhole : wasShrunk) = true;
    before = pull.force;
  }
  QVERIFY(wasWhole && wasShrunk);
}

// Ten thousand points that are not quite equal, further from the origin than their distances: no force to speak of, and
// none that is not finite.
void SnapCrowdTest::almostAtOnePoint() {
  std::mt19937 random(4);
  for (const double offset : {0.0, 1e7}) {
    const Vec3 middle = Vec3::Constant(offset);
    std::vector<Simplex> simplices;
    for (int i = 0; i < 10'000; ++i) simplices.push_back(point(middle + randomIn(random, 1e-7)));
    const SnapField field = fieldOf(simplices);
    SnapSum sum;
    for (const SnapShape shape : kSnapShapes)
      for (int i = 0; i < 100; ++i) {
        const SnapResult pull =
            sum.step(field, SnapProfile(shape, kStiffness, kDistance), middle + randomIn(random, i % 2 ? 1.0 : 1e-7));
        QVERIFY(pull.force.allFinite());
        // Each acts over no more than their distance.
        const double apart = 4e-7;
        QVERIFY(pull.distance < kDistance);
        if (shape != SnapShape::Spring) QVERIFY(pull.force.norm() <= 2.0 * kStiffness * apart * SnapSum::kMost);
      }
  }
}

void SnapCrowdTest::proxyHoldsTheNearest() {
  std::mt19937 random(5);
  std::vector<Simplex> simplices;
  for (int i = 0; i < 10'000; ++i) simplices.push_back(point(randomIn(random, 1.0)));
  const SnapField field = fieldOf(simplices);
  const SnapProfile profile(SnapShape::Triangular, kStiffness, kDistance);
  for (int i = 0; i < 100; ++i) {
    const Vec3 hand = randomIn(random, 1.0);
    SnapProxy proxy;
    const SnapResult pull = proxy.step(field, profile, hand);
    QVERIFY(std::abs((pull.proxy - hand).norm() - distancesTo(simplices, hand)[0]) <= 1e-12);
    QVERIFY((pull.proxy - simplices[proxy.held().id].corners[0]).norm() <= 1e-15);
    // It stays there: the others are further from it.
    QCOMPARE(proxy.step(field, profile, hand + Vec3(0.1, 0.1, 0.1)).proxy, pull.proxy);
  }
}

// Their boxes all overlap and tell nothing: the work of a tick ends, and it says so.
void SnapCrowdTest::longOnesAcrossEachOther() {
  std::mt19937 random(6);
  std::vector<Simplex> simplices;
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 d = randomIn(random, 1.0);
    simplices.push_back(segment(Vec3(-100, -100, -100) + d, Vec3(100, 100, 100) + 50.0 * d));
  }
  const SnapField field = fieldOf(simplices);
  SnapSum sum;
  SnapProxy proxy;
  const SnapProfile profile(SnapShape::Triangular, kStiffness, kDistance);
  QVERIFY(sum.step(field, profile, Vec3(10, 10, 10)).isCutShort);
  QVERIFY(sum.step(field, profile, Vec3(10, 10, 10)).force.allFinite());
  QVERIFY(!sum.step(field, profile, Vec3(200, 0, 0)).isCutShort);
  QVERIFY(!proxy.step(field, profile, Vec3(200, 0, 0)).isCutShort);
}

HANDWHEEL_TEST(SnapCrowdTest)
#include "SnapCrowdTest.moc"
