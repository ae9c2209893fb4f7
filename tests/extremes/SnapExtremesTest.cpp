// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Extremes.h"
#include "TestClass.h"
#include "core/haptics/snap/SnapShapes.h"
#include "haptics/snap/SnapProxy.h"
#include "haptics/snap/SnapSum.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kStiffness = 0.5;  // N/mm

// In reach of a hand in the middle: all kinds, and those without length or area.
std::vector<Simplex> sceneOf(std::mt19937& random, double scale, const Vec3& middle) {
  std::vector<Simplex> simplices = randomSimplices(random, 20, scale, scale, middle);
  const auto position = [&] { return Vec3(middle + randomIn(random, scale)); };
  const Vec3 a = position(), b = position();
  simplices.push_back(segment(a, a));
  simplices.push_back(face(a, a, a));
  simplices.push_back(face(b, a, a));
  simplices.push_back(face(a, b, 0.5 * (a + b)));
  simplices.push_back(face(a, a + Vec3(scale, 0, 0), a + Vec3(0.5 * scale, 1e-6 * scale, 0)));  // a sliver
  return simplices;
}

// The same forces wherever it is and however large; the hand and the features as rounding left them there.
void forcesAt(double scale, double offset) {
  std::mt19937 random(7);
  const Vec3 middle = offset * Vec3(1.0, -0.7, 0.3);
  const auto simplices = sceneOf(random, scale, middle);
  const SnapField field = fieldOf(simplices);
  SnapSum sum;
  SnapProxy proxy;
  for (const SnapShape shape : kSmoothShapes)
    for (int i = 0; i < 50; ++i) {
      const SnapProfile profile(shape, kStiffness, 0.7 * scale);
      const Vec3 hand = middle + randomIn(random, scale);
      const Vec3 expected = sumOf(simplices, shape, kStiffness, profile.distance(), hand);
      // Needles that are no wider than a rounding of their corners have their nearest point off by as much.
      const double tolerance = 1e-6 * profile.peak() + kStiffness * 1e-15 * offset;
      QVERIFY((sum.step(field, profile, hand).force - expected).norm() <= tolerance);
      const SnapResult pull = proxy.step(field, profile, hand);
      QVERIFY(pull.force.norm() <= profile.peak() * (1.0 + 1e-12));
      if (!proxy.isHeld()) continue;
      const auto off = static_cast<double>(distanceTo(simplices[proxy.held().id], pull.proxy));
      QVERIFY(off <= 1e-8 * scale + 1e-15 * offset);
    }
}

}  // namespace

class SnapExtremesTest : public QObject {
  Q_OBJECT

 private slots:
  void scalesAndOffsets_data();
  void scalesAndOffsets();
  void strangeNumbersGiveNoStrangeForce();
  void manyAtOnePosition();
  void onlyOne();
};

void SnapExtremesTest::scalesAndOffsets_data() {
  QTest::addColumn<double>("scale");
  QTest::addColumn<double>("offset");
  for (const double scale : kScales)
    for (const double offset : kOffsets) QTest::addRow("%g mm, %g mm away", scale, offset) << scale << offset;
}

void SnapExtremesTest::scalesAndOffsets() {
  QFETCH(double, scale);
  QFETCH(double, offset);
  forcesAt(scale, offset);
}

// In the features, the hand, the stiffness and the snap distance.
void SnapExtremesTest::strangeNumbersGiveNoStrangeForce() {
  const std::vector<double> strange = strangeNumbers();
  std::mt19937 random(8);
  const auto number = [&] { return random() % 3 ? strange[random() % strange.size()] : 0.1 * (random() % 30); };
  const auto position = [&] {
    const double x = number(), y = number();
    return Vec3(x, y, number());
  };
  for (int scene = 0; scene < 300; ++scene) {
    SnapFeatures features;
    for (std::uint32_t i = 0; i < 5; ++i) {
      features.addPoint(i, position());
      features.addSegment(i, position(), position());
      features.addTriangle(i, position(), position(), position());
      features.addCurve(i, std::vector{position(), position(), position(), position()}, i % 2);
      features.addPoint(i, Vec3(0.1 * i, 0, 0));  // and something that is there
    }
    const SnapField field(features);
    SnapSum sum;
    SnapProxy proxy;
    for (int i = 0; i < 50; ++i) {
      const SnapProfile profile(kSnapShapes[i % 4], i % 3 ? 0.5 : number(), i % 5 ? 1.0 : number());
      const Vec3 hand = position();
      for (const SnapResult& pull : {sum.step(field, profile, hand), proxy.step(field, profile, hand)}) {
        QVERIFY(pull.force.allFinite());
        QVERIFY(std::isfinite(pull.slope) && pull.slope >= 0.0);
      }
    }
  }
}

// One point 10,000 times is one point that pulls 10,000 times as hard; the proxy method holds it once.
void SnapExtremesTest::manyAtOnePosition() {
  const Vec3 position(1, 2, 3), hand(1.25, 2, 3);
  SnapFeatures features;
  for (std::uint32_t i = 0; i < 10'000; ++i) features.addPoint(i, position);
  const SnapField field(features);
  const SnapProfile profile(SnapShape::Triangular, kStiffness, 1.0);
  const SnapResult pull = SnapSum().step(field, profile, hand);
  QVERIFY((pull.force - Vec3(-0.25 * kStiffness * 1e4, 0, 0)).norm() <= 1e-9);
  QCOMPARE(pull.slope, kStiffness * 1e4);
  QCOMPARE(pull.featureCount, 1u);
  SnapProxy proxy;
  QVERIFY((proxy.step(field, profile, hand).force - Vec3(-0.25 * kStiffness, 0, 0)).norm() <= 1e-12);
  QCOMPARE(proxy.held().id, 0u);
}

void SnapExtremesTest::onlyOne() {
  const SnapProfile profile(SnapShape::Triangular, kStiffness, 1.0);
  for (const double at : {0.0, 1e7, 1e50, -1e100}) {
    const Vec3 position = Vec3::Constant(at);
    SnapFeatures features;
    features.addPoint(3, position);
    const SnapField field(features);
    SnapProxy proxy;
    QCOMPARE(proxy.step(field, profile, position).force, Vec3(0, 0, 0));
    QCOMPARE(proxy.held().id, 3u);
    QCOMPARE(SnapSum().step(field, profile, position).featureCount, 1u);
    QCOMPARE(proxy.step(field, profile, position + Vec3::Constant(std::max(2.0, 1e-3 * std::abs(at)))).featureCount,
             0u);
  }
}

HANDWHEEL_TEST(SnapExtremesTest)
#include "SnapExtremesTest.moc"
