// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SnapShapes.h"
#include "TestClass.h"

#include <rapidcheck.h>

#include <QtTest>
#include <set>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Random positions and sizes, from a seed that shrinks with nothing else.
struct Scene {
  double scale = 1.0;
  Vec3 middle = Vec3::Zero();
  std::vector<Simplex> simplices;
  SnapField field;
};

Scene randomScene(std::mt19937& random) {
  constexpr double scales[] = {1e-3, 1.0, 1e4};
  constexpr double offsets[] = {0.0, 1e3, 1e7};
  Scene s;
  s.scale = scales[random() % 3];
  s.middle = Vec3(1.0, -0.5, 0.25) * offsets[random() % 3];
  s.simplices = randomSimplices(random, 1 + random() % 200, s.scale, s.scale * (random() % 2 ? 0.2 : 1.0), s.middle);
  s.field = fieldOf(s.simplices);
  return s;
}

// Returns the largest effect of rounding coordinates in the scene.
double roundingOf(const Scene& s) {
  return 1e-15 * (s.middle.cwiseAbs().maxCoeff() + s.scale) * 10.0;
}

}  // namespace

class SnapLayerTest : public QObject {
  Q_OBJECT

 private slots:
  void findsWhatIsNear();
  void nearestOfThoseInReach();
  void limitMayFall();
  void endsWhenItIsTooMuch();
};

void SnapLayerTest::findsWhatIsNear() {
  QVERIFY(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const Scene s = randomScene(random);
    const Vec3 hand = s.middle + randomIn(random, 1.2 * s.scale);
    const double reach = s.scale * (random() % 2 ? 0.3 : 1.0);
    for (std::size_t d = 0; d < SnapField::kDimensions; ++d) {
      std::set<std::uint32_t> found;
      const bool isAll = s.field.layer(d).forEachNear(
          hand - s.field.origin(), [&] { return reach * reach; },
          [&](const SnapItem& item, const Vec3& closest, double distance2) {
            const Real expected = distanceTo(s.simplices[item.feature.id], hand);
            RC_ASSERT(std::abs(std::sqrt(distance2) - static_cast<double>(expected)) <= roundingOf(s));
            const Vec3 q = closest + s.field.origin();
            RC_ASSERT(static_cast<double>(distanceTo(s.simplices[item.feature.id], q)) <= roundingOf(s));
            found.insert(item.feature.id);
          });
      RC_ASSERT(isAll);
      for (std::uint32_t i = 0; i < s.simplices.size(); ++i) {
        if (s.simplices[i].dimension() != d) continue;
        const auto x = static_cast<double>(distanceTo(s.simplices[i], hand));
        if (std::abs(x - reach) > roundingOf(s)) RC_ASSERT(found.contains(i) == (x < reach));
      }
    }
  }));
}

void SnapLayerTest::nearestOfThoseInReach() {
  QVERIFY(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const Scene s = randomScene(random);
    const Vec3 hand = s.middle + randomIn(random, s.scale), proxy = s.middle + randomIn(random, s.scale);
    SnapLayer::Reach reach{hand - s.field.origin(), proxy - s.field.origin(), 0.5 * s.scale};
    reach.fromProxy = random() % 2 ? 0.4 * s.scale : 1e300;
    for (std::size_t d = 0; d < SnapField::kDimensions; ++d) {
      double least = std::numeric_limits<double>::infinity();
      for (const Simplex& simplex : s.simplices) {
        if (simplex.dimension() != d) continue;
        const auto fromProxy = static_cast<double>(distanceTo(simplex, proxy));
        const bool isIn =
            static_cast<double>(distanceTo(simplex, hand)) <= reach.distance && fromProxy <= reach.fromProxy;
        if (isIn) least = std::min(least, fromProxy);
      }
      const SnapLayer::Hold hold = s.field.layer(d).nearest(reach);
      RC_ASSERT((hold.item == kNone) == std::isinf(least));
      if (hold.item == kNone) continue;
      const Simplex& simplex = s.simplices[s.field.layer(d).item(hold.item).feature.id];
      RC_ASSERT(std::abs(hold.proxyDistance - least) <= roundingOf(s));
      RC_ASSERT(std::abs(hold.handDistance - static_cast<double>(distanceTo(simplex, hand))) <= roundingOf(s));
      RC_ASSERT(std::abs((hold.point - reach.hand).norm() - hold.handDistance) <= roundingOf(s));
    }
  }));
}

void SnapLayerTest::limitMayFall() {
  std::mt19937 random(1);
  const auto simplices = randomSimplices(random, 500, 10.0, 1.0);
  const SnapField field = fieldOf(simplices);
  for (std::size_t d = 0; d < SnapField::kDimensions; ++d) {
    double best2 = 1e300;
    field.layer(d).forEachNear(
        -field.origin(), [&] { return best2; },
        [&](const SnapItem&, const Vec3&, double distance2) { best2 = distance2; });
    Real expected = 1e300;
    for (const Simplex& s : simplices)
      if (s.dimension() == d) expected = std::min(expected, distanceTo(s, Vec3::Zero()));
    QVERIFY(std::abs(std::sqrt(best2) - static_cast<double>(expected)) <= 1e-12);
  }
}

void SnapLayerTest::endsWhenItIsTooMuch() {
  std::mt19937 random(1);
  SnapFeatures features;
  for (std::uint32_t i = 0; i < 3 * SnapLayer::kMostItems; ++i) features.addPoint(i, randomIn(random, 1.0));
  const SnapField field(features);
  std::uint32_t visits = 0;
  QVERIFY(!field.layer(0).forEachNear(
      -field.origin(), [] { return 100.0; }, [&](const SnapItem&, const Vec3&, double) { ++visits; }));
  QVERIFY(visits >= SnapLayer::kMostItems);
  QVERIFY(visits < SnapLayer::kMostItems + BoxTree::kLeafSize);
}

HANDWHEEL_TEST(SnapLayerTest)
#include "SnapLayerTest.moc"
