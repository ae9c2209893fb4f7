// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mapping/WorkspaceMapping.h"

#include <rapidcheck.h>
#include <QtTest>

#include "HapticPoses.h"
#include "TestClass.h"

using namespace handwheel;
using namespace handwheel::test;

class WorkspaceMappingTest : public QObject {
  Q_OBJECT

 private slots:
  void axesArePermutedAndInverted() {
    WorkspaceMapping mapping;
    mapping.axes = {DeviceAxis{1, false}, DeviceAxis{2, true}, DeviceAxis{0, false}};
    QCOMPARE(Vec3(mapping.viewFromDevice() * Vec3(1, 2, 3)), Vec3(2, -3, 1));
  }

  // Virtual work: the work of the scene's force along the scene's motion is, but for scale and gain, that of the
  // device's force along the device's motion.
  void forcesAreTheTransposedMotions() {
    QVERIFY(rc::check("virtual work", [] {
      const WorkspaceMapping mapping = anyMapping();
      const Vec3 motion = anyVector(), force = anyVector();
      const Vec3 sceneMotion = mapping.scale * (mapping.sceneFromView.linear() * (mapping.viewFromDevice() * motion));
      const double work = mapping.deviceForce(force).dot(motion) * mapping.scale;
      const double sceneWork = force.dot(sceneMotion) * mapping.forceGain;
      RC_ASSERT(std::abs(work - sceneWork) <= 1e-9 * (1.0 + std::abs(sceneWork)));
      // Torque is the cross product of arm and force, for both handednesses.
      const Vec3 arm = anyVector();
      WorkspaceMapping rigid = mapping;
      rigid.scale = rigid.forceGain = 1.0;
      const Vec3 expected = rigid.deviceForce(arm).cross(rigid.deviceForce(force));
      RC_ASSERT((rigid.deviceTorque(arm.cross(force)) - expected).norm() <= 1e-9 * (1.0 + expected.norm()));
    }));
  }

  // A spring of the stiffness in the scene feels as stiff as required at the device.
  void stiffnessIsFeltAtTheDevice() {
    WorkspaceMapping mapping;
    mapping.scale = 4.0;
    mapping.forceGain = 0.5;
    const double stiffness = mapping.sceneStiffness(3.0);
    const Vec3 sceneForce(-stiffness * mapping.scale * 1.0, 0, 0);  // 1 mm of the device
    QVERIFY(qAbs(mapping.deviceForce(sceneForce).x() + 3.0) < 1e-12);
  }

  void theDeadZoneIsContinuous() {
    QVERIFY(outsideDeadZone({1, 2, 2}, 3.0).isZero(0.0));
    QVERIFY(outsideDeadZone({0, 0, 0}, 3.0).isZero(0.0));
    QVERIFY((outsideDeadZone({0, 5, 0}, 3.0) - Vec3(0, 2, 0)).norm() < 1e-12);
    QVERIFY(outsideDeadZone({3.0 + 1e-9, 0, 0}, 3.0).norm() < 1e-8);
    QCOMPARE(outsideDeadZone({1, 2, 3}, 0.0), Vec3(1, 2, 3));
    QVERIFY(rc::check("no two points further apart", [] {
      const Vec3 a = anyVector(), b = anyVector();
      RC_ASSERT((outsideDeadZone(a, 5.0) - outsideDeadZone(b, 5.0)).norm() <= (a - b).norm() + 1e-9);
    }));
  }
};

HANDWHEEL_TEST(WorkspaceMappingTest)
#include "WorkspaceMappingTest.moc"
