// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/servo/ForceTest.h"

#include <QtTest>

using namespace handwheel;

class ForceTestTest : public QObject {
  Q_OBJECT

 private slots:
  // For any mapping, it pulls at the device along one axis at a time, in both senses, up to the force and no further,
  // and a half sine leaves no leap: |dF/dt| ≤ π F / T.
  void pullsAlongTheAxesOfTheDevice() {
    WorkspaceMapping mapping;
    mapping.axes = {DeviceAxis{2, true}, DeviceAxis{0, false}, DeviceAxis{1, false}};
    mapping.sceneFromView = Eigen::Translation3d(1e3, 0, 0) * Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized());
    mapping.forceGain = 3.0;
    mapping.scale = 12.0;
    ForceTest test(0.5, mapping);
    Vec3 least = Vec3::Zero(), most = Vec3::Zero(), before = Vec3::Zero();
    const double steepest = 0.001 * M_PI * 0.5 / ForceTest::kPullTime;
    for (int i = 0; i < 6000; ++i) {
      TipState tip;
      tip.time = 100.0 + 0.001 * i;
      ForceOut out;
      test.tick(tip, out);
      const Vec3 force = mapping.deviceForce(out.force);
      least = least.cwiseMin(force);
      most = most.cwiseMax(force);
      QVERIFY((force - before).norm() <= steepest * 1.001);
      QVERIFY(force.norm() - force.cwiseAbs().maxCoeff() < 1e-12);
      if (tip.time > 100.0 + ForceTest::kDuration) QVERIFY(force.isZero(0.0));
      before = force;
    }
    QVERIFY((most - Vec3::Constant(0.5)).norm() < 1e-4);
    QVERIFY((least + Vec3::Constant(0.5)).norm() < 1e-4);
  }

  void aClockThatJumpsBack() {
    ForceTest test(0.5, {});
    for (const double time : {10.0, -1e300, std::numeric_limits<double>::quiet_NaN()}) {
      TipState tip;
      tip.time = time;
      ForceOut out;
      test.tick(tip, out);
      QVERIFY(out.force.isZero(0.0));
    }
  }
};

HANDWHEEL_TEST(ForceTestTest)
#include "ForceTestTest.moc"
