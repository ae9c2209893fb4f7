// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SnapShapes.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::size_t countOf(const SnapFeatures& features, SnapItem::Shape shape) {
  return static_cast<std::size_t>(std::count_if(features.items().begin(), features.items().end(),
                                                [&](const SnapItem& item) { return item.shape == shape; }));
}

struct Curve {
  std::vector<Vec3> points;
  bool isClosed;
  std::size_t segments, joints;
};

}  // namespace

class SnapFeaturesTest : public QObject {
  Q_OBJECT

 private slots:
  void leavesOutInvalidPositions();
  void curvesBecomeSegmentsAndJoints();
  void curveCountsOnceEverywhere();
  void nothingFromNothing();
};

void SnapFeaturesTest::leavesOutInvalidPositions() {
  const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY();
  for (const double bad : {kNaN, kInfinity, -kInfinity, 1e101}) {
    const Vec3 b(0.0, bad, 0.0);
    SnapFeatures features;
    features.addPoint(0, b);
    features.addSegment(1, o, b);
    features.addTriangle(2, o, x, b);
    features.addCurve(3, std::vector{o, x, b, y}, false);
    QCOMPARE(features.items().size(), 0u);
    QCOMPARE(features.leftOut(), 4u);
    features.addPoint(4, o);
    QCOMPARE(features.items().size(), 1u);
    QCOMPARE(features.items()[0].feature, (SnapFeature{SnapKind::Point, 4}));
  }
}

void SnapFeaturesTest::curvesBecomeSegmentsAndJoints() {
  const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY();
  const Curve curves[] = {
      {{o, x}, false, 1, 0},   {{o, x, y}, false, 2, 1},   {{o, x, y}, true, 3, 3},  {{o, o, x, x, x}, false, 1, 0},
      {{o, x, o}, true, 1, 0}, {{o, x, y, o}, true, 3, 3}, {{o, x, o}, false, 2, 1}, {{o, o}, true, 1, 0},
      {{o}, false, 1, 0},      {{}, false, 0, 0},          {{}, true, 0, 0}};
  for (const Curve& curve : curves) {
    SnapFeatures features;
    features.addCurve(7, curve.points, curve.isClosed);
    QCOMPARE(countOf(features, SnapItem::Shape::Segment), curve.segments);
    QCOMPARE(countOf(features, SnapItem::Shape::Joint), curve.joints);
    QCOMPARE(features.items().size(), curve.segments + curve.joints);
    for (const SnapItem& item : features.items()) {
      QCOMPARE(item.feature, (SnapFeature{SnapKind::Curve, 7}));
      QCOMPARE(item.dimension(), 1u);
    }
  }
}

// Euler: at any point the pieces that count, less the joints that count against them, are one where the nearest point
// is unique on each side, and the pieces of a straight line are one everywhere.
void SnapFeaturesTest::curveCountsOnceEverywhere() {
  std::mt19937 random(3);
  std::vector<Vec3> points;
  for (int i = 0; i <= 20; ++i) points.push_back(Vec3(1.0, 2.0, 3.0) * i);
  SnapFeatures features;
  features.addCurve(0, points, false);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 hand = Vec3(10, 20, 30) + randomIn(random, 60.0);
    double count = 0.0, absolute = 0.0;
    for (const SnapItem& item : features.items()) {
      count += item.countAt(hand);
      absolute += std::abs(item.countAt(hand));
    }
    QCOMPARE(count, 1.0);
    QCOMPARE(absolute, 1.0);
  }
}

void SnapFeaturesTest::nothingFromNothing() {
  QVERIFY(SnapField().empty());
  QVERIFY(SnapField(SnapFeatures()).empty());
  SnapFeatures features;
  features.addPoint(0, Vec3(kNaN, 0, 0));
  QVERIFY(SnapField(features).empty());
  features.addPoint(1, Vec3(1, 2, 3));
  QVERIFY(!SnapField(features).empty());
}

HANDWHEEL_TEST(SnapFeaturesTest)
#include "SnapFeaturesTest.moc"
