// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/BodyTip.h"

#include "TestClass.h"
#include "scene/MeshGeometry.h"
#include "scene/PrimitiveGeometry.h"
#include "scene/RigidPose.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace handwheel;

namespace {

bool isTipAt(const Body& body, const Vec3& at) {
  const auto tip = tipOf(body);
  return tip && (*tip - at).norm() < 1e-9;
}

}  // namespace

// The tip of a tool: the middle of what reaches farthest along z of the flange.
class BodyTipTest : public QObject {
  Q_OBJECT

 private slots:
  // A box of 20 x 30 x 100 mm about its origin: its end face, or an edge where it is tilted about x.
  void ofABox() {
    Body box{.name = "tool", .geometry = *PrimitiveGeometry::make(Primitive::Cuboid, {20.0, 30.0, 100.0})};
    box.pose = poseOf({1.0, 2.0, 50.0}, Vec3::Zero());
    QVERIFY(isTipAt(box, {1.0, 2.0, 100.0}));
    box.pose = poseOf({1.0, 2.0, 50.0}, {std::numbers::pi, 0.0, 0.0});
    QVERIFY(isTipAt(box, {1.0, 2.0, 100.0}));
    box.pose = poseOf({0.0, 0.0, 0.0}, {std::numbers::pi / 4.0, 0.0, 0.0});
    const double half = std::sqrt(0.5);
    QVERIFY(isTipAt(box, {0.0, -35.0 * half, 65.0 * half}));
  }

  // A point.
  void ofAMesh() {
    TriangleSoup pyramid{{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {3, 4, 25}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
    const Body body{.name = "tool", .geometry = std::make_shared<const MeshGeometry>(std::move(pyramid))};
    QVERIFY(isTipAt(body, {3.0, 4.0, 25.0}));
  }
};

HANDWHEEL_TEST(BodyTipTest)
#include "BodyTipTest.moc"
