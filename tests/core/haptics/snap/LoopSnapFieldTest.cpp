// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/snap/LoopSnapField.h"
#include "haptics/snap/SnapProxy.h"
#include "haptics/snap/SnapSum.h"

#include <QtTest>

using namespace handwheel;

namespace {

// A rectangular hole of 4 mm by 2 mm, with numbers as a mesh might have them.
struct Rectangle {
  std::vector<Vec3> points{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}};
  std::vector<std::uint32_t> vertices{70, 71, 72, 73}, edges{500, 510, 520, 530};

  SnapLoop rim() const { return {9, points, vertices, edges}; }
};

LoopSnapField rectangleScene(const Rectangle& hole, SnapOffer offer) {
  const SnapLoop rim = hole.rim();
  return snapSceneOf({&rim, 1}, offer);
}

SnapFeature heldAt(const LoopSnapField& scene, const Vec3& hand) {
  SnapProxy proxy;
  proxy.step(scene.field, SnapProfile(SnapShape::Quadratic, 0.5, 0.5), hand);
  return proxy.isHeld() ? proxy.held() : SnapFeature();
}

}  // namespace

class LoopSnapFieldTest : public QObject {
  Q_OBJECT

 private slots:
  void givesTheNumbersBack();
  void rimIsOneFeature();
  void distanceFollowsTheEdges();
  void empty();
};

void LoopSnapFieldTest::givesTheNumbersBack() {
  const Rectangle hole;
  const LoopSnapField scene = rectangleScene(hole, {});
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 &from = hole.points[i], &to = hole.points[(i + 1) % 4];
    QCOMPARE(heldAt(scene, from + Vec3(0.1, 0.1, 0.1)), (SnapFeature{SnapKind::Point, hole.vertices[i]}));
    QCOMPARE(heldAt(scene, 0.5 * (from + to) + Vec3(0.1, 0.1, 0.1)), (SnapFeature{SnapKind::Segment, hole.edges[i]}));
  }
  QCOMPARE(heldAt(scene, Vec3(2, 1, 0)), SnapFeature());
  QCOMPARE(heldAt(rectangleScene(hole, {true, false, false}), Vec3(2, 0.1, 0)), SnapFeature());
  QCOMPARE(heldAt(rectangleScene(hole, {false, true, false}), Vec3(0.1, 0.05, 0)),
           (SnapFeature{SnapKind::Segment, 500}));
}

// In the sum, too, the force at an edge next to a corner is that of the edge alone.
void LoopSnapFieldTest::rimIsOneFeature() {
  const LoopSnapField scene = rectangleScene(Rectangle(), {false, false, true});
  const SnapProfile profile(SnapShape::Triangular, 0.5, 0.5);
  for (const Vec3& hand : {Vec3(2, -0.1, 0), Vec3(0.05, -0.1, 0), Vec3(-0.06, -0.08, 0)}) {
    QCOMPARE(heldAt(scene, hand), (SnapFeature{SnapKind::Curve, 9}));
    const SnapResult pull = SnapSum().step(scene.field, profile, hand);
    QVERIFY(std::abs(pull.force.norm() - 0.5 * 0.1) <= 1e-15);
    QCOMPARE(pull.featureCount, 1u);
  }
}

void LoopSnapFieldTest::distanceFollowsTheEdges() {
  Rectangle hole;
  FidelityValues values;
  QCOMPARE(rectangleScene(hole, {}).spacing, 3.0);
  QCOMPARE(rectangleScene(hole, {}).distance(values), 1.2);
  for (Vec3& p : hole.points) p = 1e-3 * p + Vec3(1e4, 0, 0);
  QVERIFY(std::abs(rectangleScene(hole, {}).distance(values) - 1.2e-3) <= 1e-11);
}

void LoopSnapFieldTest::empty() {
  const LoopSnapField scene = snapSceneOf({}, {});
  QVERIFY(scene.field.empty());
  QCOMPARE(scene.distance({}), 0.0);
  QVERIFY(rectangleScene(Rectangle(), {false, false, false}).field.empty());
  JobState job;
  job.cancelled = true;
  const Rectangle hole;
  const SnapLoop rim = hole.rim();
  const LoopSnapField cancelled = snapSceneOf({&rim, 1}, {}, Progress(job));
  QVERIFY(cancelled.field.empty());
  QCOMPARE(cancelled.spacing, 0.0);
}

HANDWHEEL_TEST(LoopSnapFieldTest)
#include "LoopSnapFieldTest.moc"
