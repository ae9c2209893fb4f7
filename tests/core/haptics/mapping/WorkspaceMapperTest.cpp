// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mapping/WorkspaceMapper.h"

#include <rapidcheck.h>
#include <QtTest>
#include <numbers>

#include "HapticPoses.h"
#include "TestClass.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

DeviceState placed(const Vec3& position, const Eigen::Quaterniond& orientation = Eigen::Quaterniond::Identity(),
                   std::uint32_t buttons = 0) {
  DeviceState state;
  state.position = position;
  state.orientation = orientation;
  state.buttons = buttons;
  state.status = DeviceStatus::Ready;
  return state;
}

Eigen::Quaterniond about(const Vec3& axis, double angle) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
}

}  // namespace

class WorkspaceMapperTest : public QObject {
  Q_OBJECT

 private slots:
  // mTh = mTc · cTh, eq. 6-12, by hand: the view looks along -x with z up, so its right is y, its up z, its back x.
  void isTheProductOfViewAndDevice() {
    WorkspaceMapping mapping;
    mapping.sceneFromView.linear().col(0) = Vec3::UnitY();
    mapping.sceneFromView.linear().col(1) = Vec3::UnitZ();
    mapping.sceneFromView.linear().col(2) = Vec3::UnitX();
    mapping.sceneFromView.translation() = Vec3(100, 0, 0);
    mapping.scale = 2.0;
    WorkspaceMapper mapper;
    mapper.setMapping(mapping);
    const auto tip = mapper.map(placed({1, 2, 3}), {10, 0, 0}, 0.001);
    QVERIFY((tip.position - Vec3(106, 2, 4)).norm() < 1e-12);
    QVERIFY((tip.velocity - Vec3(0, 20, 0)).norm() < 1e-12);
    QVERIFY(tip.hasDiscontinuity);
    QVERIFY(!mapper.map(placed({1, 2, 3}), Vec3::Zero(), 0.001).hasDiscontinuity);
  }

  // For a proper mapping at scale 1 the whole pose is the product of poses; turned stylus and all.
  void posesMultiply() {
    QVERIFY(rc::check("product of poses", [] {
      WorkspaceMapping mapping;
      mapping.sceneFromView.linear() = anyRotation().toRotationMatrix();
      mapping.sceneFromView.translation() = anyVector();
      WorkspaceMapper mapper;
      mapper.setMapping(mapping);
      const Vec3 position = anyVector();
      const Eigen::Quaterniond orientation = anyRotation();
      const auto tip = mapper.map(placed(position, orientation), Vec3::Zero(), 0.001);
      Pose device = Pose::Identity();
      device.linear() = orientation.toRotationMatrix();
      device.translation() = position;
      const Pose expected = mapping.sceneFromView * device;
      RC_ASSERT((tip.position - expected.translation()).norm() < 1e-9);
      RC_ASSERT((tip.orientation.toRotationMatrix() - expected.linear()).norm() < 1e-9);
    }));
  }

  // For any mapping, the velocity is the derivative of the position.
  void velocityIsTheDerivative() {
    QVERIFY(rc::check("derivative", [] {
      WorkspaceMapper mapper;
      mapper.setMapping(anyMapping());
      const Vec3 start = anyVector(), velocity = anyVector();
      const auto first = mapper.map(placed(start), velocity, 0.001);
      const auto second = mapper.map(placed(start + 0.5 * velocity), velocity, 0.5);
      const Vec3 moved = second.position - first.position;
      RC_ASSERT((moved - 0.5 * second.velocity).norm() <= 1e-9 * (1.0 + moved.norm() + first.position.norm()));
    }));
  }

  // With the clutch held the tip stays while the hand moves and turns. Released, it goes on from there by the mapping.
  void theClutchDoesNotLeap() {
    QVERIFY(rc::check("no leap", [] {
      WorkspaceMapping mapping = anyMapping();
      mapping.clutchButtons = 1;
      WorkspaceMapper mapper;
      mapper.setMapping(mapping);
      const auto before = mapper.map(placed(anyVector(), anyRotation()), Vec3::Zero(), 0.001);
      const double size = 1.0 + before.position.norm() + 200.0 * mapping.scale;
      DeviceState held;
      for (int i = 0; i < 5; ++i) {
        held = placed(anyVector(), anyRotation(), 1);
        const auto during = mapper.map(held, anyVector(), 0.001);
        RC_ASSERT(during.isHeld);
        RC_ASSERT((during.position - before.position).norm() <= 1e-12 * size);
        RC_ASSERT(during.velocity.isZero(0.0));
        RC_ASSERT(during.orientation.angularDistance(before.orientation) < 1e-6);
      }
      held.buttons = 0;
      const auto after = mapper.map(held, Vec3::Zero(), 0.001);
      RC_ASSERT(!after.isHeld && !after.hasDiscontinuity);
      RC_ASSERT((after.position - before.position).norm() <= 1e-12 * size);
      held.position += Vec3(1, 0, 0);
      const Vec3 moved = mapper.map(held, Vec3::Zero(), 0.001).position - after.position;
      const Vec3 expected = mapping.scale * (mapping.sceneFromView.linear() * mapping.viewFromDevice().col(0));
      RC_ASSERT((moved - expected).norm() <= 1e-9 * size);
    }));
  }

  // Orbiting the view: the tip stays, and then moves as seen by the new camera.
  void anotherViewKeepsTheTip() {
    WorkspaceMapper mapper;
    mapper.map(placed({1, 2, 3}), Vec3::Zero(), 0.001);
    WorkspaceMapping turned;
    turned.sceneFromView.linear() = about(Vec3::UnitY(), std::numbers::pi / 2).toRotationMatrix();
    turned.scale = 5.0;
    mapper.setMapping(turned);
    auto tip = mapper.map(placed({1, 2, 3}), Vec3::Zero(), 0.001);
    QVERIFY(!tip.hasDiscontinuity);
    QVERIFY((tip.position - Vec3(1, 2, 3)).norm() < 1e-12);
    tip = mapper.map(placed({2, 2, 3}), Vec3::Zero(), 0.001);
    QVERIFY((tip.position - Vec3(1, 2, -2)).norm() < 1e-12);
    turned.keepsTip = false;
    mapper.setMapping(turned);
    tip = mapper.map(placed({2, 2, 3}), Vec3::Zero(), 0.001);
    QVERIFY(tip.hasDiscontinuity);
    QVERIFY((tip.position - Vec3(15, 10, -10)).norm() < 1e-12);
  }

  // A displacement of 5 mm, 1 of them dead, at 3 mm/s per mm for 2 s, at scale 10.
  void rateControlIntegratesTime() {
    for (const int steps : {10, 1000}) {
      WorkspaceMapping mapping;
      mapping.isRateControl = true;
      mapping.rateGain = 3.0;
      mapping.angularRateGain = 0.5;
      mapping.scale = 10.0;
      mapping.deadZone = 1.0;
      mapping.angularDeadZone = 0.1;
      mapping.sceneFromView.translation() = Vec3(7, 0, 0);
      WorkspaceMapper mapper;
      mapper.setMapping(mapping);
      const DeviceState pushed = placed({0, 5, 0}, about(Vec3::UnitZ(), 0.5));
      WorkspaceMapper::Tip tip;
      for (int i = 0; i < steps; ++i) tip = mapper.map(pushed, Vec3::Zero(), 2.0 / steps);
      QVERIFY((tip.position - Vec3(7, 10.0 * 3.0 * 4.0 * 2.0, 0)).norm() < 1e-9);
      QVERIFY((tip.velocity - Vec3(0, 120, 0)).norm() < 1e-9);
      QVERIFY(tip.orientation.angularDistance(about(Vec3::UnitZ(), 0.4 * 0.5 * 2.0)) < 1e-6);
      const auto rest = mapper.map(placed({0.5, 0.5, 0}, about(Vec3::UnitZ(), 0.05)), Vec3::Zero(), 1.0);
      QCOMPARE(rest.position, tip.position);
      QVERIFY(rest.velocity.isZero(0.0));
    }
  }

  void rateControlHasAClutchToo() {
    WorkspaceMapping mapping;
    mapping.isRateControl = true;
    mapping.clutchButtons = 4;
    WorkspaceMapper mapper;
    mapper.setMapping(mapping);
    mapper.map(placed({1, 0, 0}), Vec3::Zero(), 0.001);
    const auto tip = mapper.map(placed({1, 0, 0}, Eigen::Quaterniond::Identity(), 4), Vec3::Zero(), 1.0);
    QVERIFY(tip.isHeld);
    QVERIFY((tip.position - Vec3(0.001, 0, 0)).norm() < 1e-12);
  }

  // A mirrored axis mirrors the sense of rotation: a turn to the left is seen as a turn to the right.
  void mirroredAxesMirrorTheRotation() {
    WorkspaceMapping mapping;
    mapping.axes[0].isInverted = true;
    WorkspaceMapper mapper;
    mapper.setMapping(mapping);
    auto tip = mapper.map(placed(Vec3::Zero(), about(Vec3::UnitZ(), 0.3)), Vec3::Zero(), 0.001);
    QVERIFY(tip.orientation.angularDistance(about(Vec3::UnitZ(), -0.3)) < 1e-9);
    tip = mapper.map(placed(Vec3::Zero(), about(Vec3::UnitX(), 0.3)), Vec3::Zero(), 0.001);
    QVERIFY(tip.orientation.angularDistance(about(Vec3::UnitX(), 0.3)) < 1e-9);
  }
};

HANDWHEEL_TEST(WorkspaceMapperTest)
#include "WorkspaceMapperTest.moc"
