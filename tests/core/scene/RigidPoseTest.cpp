// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/RigidPose.h"

#include "TestClass.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>
#include <numbers>

using namespace handwheel;

namespace {

constexpr double kPi = std::numbers::pi;

double angle(double most) {
  return *rc::gen::inRange(-1000, 1001) / 1000.0 * most;
}

}  // namespace

class RigidPoseTest : public QObject {
  Q_OBJECT

 private slots:
  void anglesAndBack() {
    QVERIFY(rc::check("roll, pitch and yaw give the pose again", [] {
      const Vec3 position(angle(1e6), angle(1e6), angle(1e6)), angles(angle(kPi), angle(kPi / 2), angle(kPi));
      const Pose pose = poseOf(position, angles);
      RC_ASSERT(isRigid(pose));
      const Vec3 again = rollPitchYaw(pose);
      RC_ASSERT(std::abs(again.y()) <= kPi / 2 && again.cwiseAbs().maxCoeff() <= kPi);
      RC_ASSERT(poseOf(position, again).matrix().isApprox(pose.matrix(), 1e-8));
      RC_ASSERT(poseOf(position, again).translation() == position);
    }));
  }

  void noAngleIsNegativeZero() {
    for (double v : rollPitchYaw(Pose::Identity())) QVERIFY(!std::signbit(v));
  }

  // Roll about x, then pitch about y, then yaw about z, all in the frame of the world.
  void theOrderIsThatOfUrdf() {
    const Pose pose = poseOf({1, 2, 3}, {0.5 * kPi, 0, 0.5 * kPi});
    QVERIFY((pose.linear() * Vec3::UnitY()).isApprox(Vec3::UnitZ(), 1e-12));
    QVERIFY((pose.linear() * Vec3::UnitZ()).isApprox(Vec3::UnitX(), 1e-12));
    QCOMPARE(pose.translation(), Vec3(1, 2, 3));
  }

  void whatIsNotRigid() {
    Pose pose = poseOf({1, 2, 3}, {0.3, 0.2, 0.1});
    QVERIFY(isRigid(pose));
    for (double wrong : {std::nan(""), double(INFINITY), 1.01 * kFarthestBody}) {
      Pose bad = pose;
      bad.translation().y() = wrong;
      QVERIFY(!isRigid(bad));
      QVERIFY(!nearestRigid(bad));
    }
    Pose mirrored = pose;
    mirrored.linear().col(0) *= -1.0;
    Pose scaled = pose;
    scaled.linear() *= 1.1;
    Pose flat = pose;
    flat.linear().col(2).setZero();
    for (const Pose& bad : {mirrored, scaled, flat}) {
      QVERIFY(!isRigid(bad));
      QVERIFY(!nearestRigid(bad));
    }
  }

  void posesInFewDigitsAreMended() {
    const Pose exact = poseOf({10, 20, 30}, {0.3, -0.2, 2.1});
    Pose rough = exact;
    rough.linear() = (exact.linear() * 1e4).array().round() / 1e4;
    QVERIFY(!isRigid(rough));
    const Pose mended = nearestRigid(rough).value();
    QVERIFY(isRigid(mended));
    QVERIFY((mended.linear() - exact.linear()).cwiseAbs().maxCoeff() < 2e-4);
    QCOMPARE(mended.translation(), exact.translation());
  }
};

HANDWHEEL_TEST(RigidPoseTest)
#include "RigidPoseTest.moc"
