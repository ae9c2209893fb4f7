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

constexpr double kSnapCurveStiffness = 0.7;  // N/mm

SnapField curveField(const std::vector<Vec3>& points, bool isClosed) {
  SnapFeatures features;
  features.addCurve(0, points, isClosed);
  return SnapField(features);
}

std::vector<Vec3> circle(double radius, int points) {
  std::vector<Vec3> p;
  for (int i = 0; i < points; ++i) {
    const double angle = 2.0 * M_PI * i / points;
    p.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return p;
}

}  // namespace

class SnapCurveTest : public QObject {
  Q_OBJECT

 private slots:
  void straightCurveIsOneSegment();
  void outsideOfACornerIsOnePoint();
  void circleDrawsToItself();
  void continuousInEveryBend();
  void proxySlidesAlong();
  void proxyKeepsUpWithAQuickHand();
};

// For any division, a joint adds nothing.
void SnapCurveTest::straightCurveIsOneSegment() {
  std::mt19937 random(2);
  const Vec3 from(1, 2, 3), to(11, -5, 4);
  std::vector<Vec3> points;
  for (int i = 0; i <= 500; ++i) points.push_back(from + (to - from) * (i / 500.0));
  const SnapField field = curveField(points, false);
  const std::vector<Simplex> whole{segment(from, to)};
  SnapSum sum;
  for (const SnapShape shape : kSnapShapes) {
    const SnapProfile profile(shape, kSnapCurveStiffness, 2.0);
    for (int i = 0; i < 300; ++i) {
      const Vec3 hand = from + (to - from) * (0.005 * (i - 50)) + randomIn(random, 1.2);
      const Vec3 expected = sumOf(whole, shape, kSnapCurveStiffness, 2.0, hand);
      // At the border of the spring's reach rounding decides.
      if (std::abs(static_cast<double>(distanceTo(whole[0], hand)) - 2.0) < 1e-9) continue;
      const SnapResult pull = sum.step(field, profile, hand);
      QVERIFY((pull.force - expected).norm() <= 1e-11);
      QVERIFY(pull.slope <= profile.largestSlope());
      QCOMPARE(pull.distance, 2.0);
    }
  }
}

void SnapCurveTest::outsideOfACornerIsOnePoint() {
  const SnapField field = curveField({Vec3(0, 5, 0), Vec3(0, 0, 0), Vec3(5, 0, 0)}, false);
  SnapSum sum;
  const SnapProfile profile(SnapShape::Quadratic, kSnapCurveStiffness, 2.0);
  for (const Vec3& hand : {Vec3(-0.5, -0.4, 0.2), Vec3(-0.1, -1.2, 0.0), Vec3(-1.0, -1.0, 1.0)}) {
    const SnapResult pull = sum.step(field, profile, hand);
    const Vec3 expected = sumOf({point(Vec3::Zero())}, profile.shape(), kSnapCurveStiffness, 2.0, hand);
    QVERIFY((pull.force - expected).norm() <= 1e-14);
    QCOMPARE(pull.slope, profile.largestSlope());
    QCOMPARE(pull.featureCount, 1u);
    QCOMPARE(pull.features[0], (SnapFeature{SnapKind::Curve, 0}));
  }
}

// The force inside and outside of it, beside and above is that of the nearest point, but for the chords.
void SnapCurveTest::circleDrawsToItself() {
  const double radius = 10.0, ls = 1.5;
  const SnapField field = curveField(circle(radius, 720), true);
  std::mt19937 random(4);
  SnapSum sum;
  for (const SnapShape shape : kSmoothShapes) {
    const SnapProfile profile(shape, kSnapCurveStiffness, ls);
    for (int i = 0; i < 300; ++i) {
      const double angle = 0.021 * i;
      const Vec3 on(radius * std::cos(angle), radius * std::sin(angle), 0.0);
      const Vec3 offset = randomIn(random, 1.0);
      const Vec3 hand = on * (1.0 + offset.x() / radius) + Vec3(0, 0, offset.y());
      const Vec3 expected = sumOf({point(on)}, shape, kSnapCurveStiffness, ls, hand);
      const SnapResult pull = sum.step(field, profile, hand);
      QVERIFY((pull.force - expected).norm() <= 0.02 * profile.peak());
      QCOMPARE(pull.distance, ls);
    }
  }
}

void SnapCurveTest::continuousInEveryBend() {
  QVERIFY(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    std::vector<Vec3> points;
    for (std::size_t i = 0, n = 2 + random() % 20; i < n; ++i) points.push_back(randomIn(random, 2.0));
    const SnapField field = curveField(points, random() % 2);
    SnapSum sum;
    const Vec3 from = randomIn(random, 3.0), to = points[random() % points.size()] * 2.0 - from;
    const double items = 2.0 * static_cast<double>(points.size());
    for (const SnapShape shape : kSmoothShapes) {
      const SnapProfile profile(shape, kSnapCurveStiffness, 1.5);
      Vec3 before = sum.step(field, profile, from).force;
      for (int i = 1; i <= 1000; ++i) {
        const Vec3 now = sum.step(field, profile, from + (to - from) * (0.001 * i)).force;
        RC_ASSERT((now - before).norm() <=
                  slopeByEquation(shape) * kSnapCurveStiffness * items * 0.001 * (to - from).norm());
        before = now;
      }
    }
  }));
}

// Around the circle and back, the hand a little inside: always held, the proxy always at the hand's foot.
void SnapCurveTest::proxySlidesAlong() {
  const double radius = 10.0;
  const SnapField field = curveField(circle(radius, 720), true);
  const SnapProfile profile(SnapShape::Triangular, kSnapCurveStiffness, 1.5);
  SnapProxy proxy;
  for (int i = 0; i <= 4000; ++i) {
    const double angle = 4.0 * M_PI * std::sin(0.001 * i);
    const Vec3 on(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    const SnapResult pull = proxy.step(field, profile, 0.96 * on + Vec3(0, 0, 0.3));
    QVERIFY(proxy.isHeld());
    QVERIFY((pull.proxy - on).norm() <= 0.01);
    QVERIFY(std::abs(pull.force.norm() - kSnapCurveStiffness * 0.5) <= 0.005);
  }
}

// Half a millimetre in a tick, along segments of 3 micrometres, over a face that lies in reach: the curve holds all
// around.
void SnapCurveTest::proxyKeepsUpWithAQuickHand() {
  const double radius = 10.0;
  SnapFeatures features;
  features.addCurve(0, circle(radius, 20'000), true);
  features.addTriangle(1, Vec3(-90, -90, -1.6), Vec3(90, -90, -1.6), Vec3(0, 90, -1.6));
  const SnapField field(features);
  const SnapProfile profile(SnapShape::Triangular, kSnapCurveStiffness, 1.5);
  SnapProxy proxy;
  proxy.step(field, profile, Vec3(radius, 0, 0.5));
  for (int i = 0; i <= 500; ++i) {
    const Vec3 on(radius * std::cos(0.05 * i), radius * std::sin(0.05 * i), 0.0);
    const SnapResult pull = proxy.step(field, profile, 1.02 * on - Vec3(0, 0, 1.2));
    QCOMPARE(proxy.held(), (SnapFeature{SnapKind::Curve, 0}));
    QVERIFY((pull.proxy - on).norm() <= 4e-5);  // 2 % further out moves the foot on a chord by 2 % of its half
  }
  // The hand goes further than the snap distance at once, and not yet from the curve: it holds still, without a slide.
  proxy.step(field, profile, Vec3(-radius, 0, -0.5));
  QCOMPARE(proxy.held(), (SnapFeature{SnapKind::Curve, 0}));
  proxy.step(field, profile, Vec3(0, 0, -0.5));
  QCOMPARE(proxy.held(), (SnapFeature{SnapKind::Facet, 1}));
}

HANDWHEEL_TEST(SnapCurveTest)
#include "SnapCurveTest.moc"
