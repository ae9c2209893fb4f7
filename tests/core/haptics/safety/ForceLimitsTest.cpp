// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/safety/ForceLimits.h"

#include <rapidcheck.h>
#include <QtTest>
#include <limits>

using namespace handwheel;

namespace {

SafetySettings settings() {
  SafetySettings s;
  s.slewRate = 1000.0;
  s.torqueSlewRate = 20000.0;
  s.gripperSlewRate = 100.0;
  s.maxForce = 8.0;
  s.maxTorque = 150.0;
  s.maxGripperForce = 2.0;
  return s;
}

Vec3 anyVector() {
  const int exponent = *rc::gen::inRange(-300, 300);
  Vec3 v;
  for (double& x : v) x = std::ldexp(*rc::gen::inRange(-1000, 1001), exponent);
  return v;
}

DeviceForce anyForce() {
  return {anyVector(), anyVector(), anyVector().x()};
}

}  // namespace

class ForceLimitsTest : public QObject {
  Q_OBJECT

 private slots:
  void finite() {
    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(isFinite({}));
    QVERIFY(isFinite({Vec3::Constant(1e308), Vec3::Zero(), -1e308}));
    QVERIFY(!isFinite({{0, nan, 0}, Vec3::Zero(), 0}));
    QVERIFY(!isFinite({Vec3::Zero(), {inf, 0, 0}, 0}));
    QVERIFY(!isFinite({Vec3::Zero(), Vec3::Zero(), -inf}));
  }

  void clampKeepsTheDirection() {
    QVERIFY(rc::check("in the ball, along the force, and unchanged inside", [] {
      const DeviceForce asked = anyForce();
      const DeviceForce sent = clamped(asked, settings());
      RC_ASSERT(sent.force.stableNorm() <= 8.0 * (1 + 1e-12));
      RC_ASSERT(sent.torque.stableNorm() <= 150.0 * (1 + 1e-12));
      RC_ASSERT(std::abs(sent.gripper) <= 2.0);
      if (asked.force.stableNorm() <= 8.0) RC_ASSERT(sent.force == asked.force);
      if (asked.force.stableNorm() > 8.0)
        RC_ASSERT(sent.force.dot(asked.force.stableNormalized()) >= 8.0 * (1 - 1e-12));
    }));
  }

  void slewIsABoundedStraightStep() {
    QVERIFY(rc::check("bounded, straight, and arrives", [] {
      const DeviceForce last = clamped(anyForce(), settings()), asked = anyForce();
      const DeviceForce sent = slewed(last, asked, 0.001, settings());
      const Vec3 step = sent.force - last.force, change = asked.force - last.force;
      RC_ASSERT(step.norm() <= 1.0 + 1e-9);
      if (change.stableNorm() <= 1.0) RC_ASSERT(sent.force == asked.force);
      if (change.stableNorm() > 1.0) RC_ASSERT(step.dot(change.stableNormalized()) >= 1.0 - 1e-9);
      RC_ASSERT((sent.torque - last.torque).norm() <= 20.0 + 1e-9);
      RC_ASSERT(std::abs(sent.gripper - last.gripper) <= 0.1 + 1e-12);
      // The clamp that follows does not undo it.
      RC_ASSERT((clamped(sent, settings()).force - last.force).norm() <= 1.0 + 1e-9);
    }));
  }
};

HANDWHEEL_TEST(ForceLimitsTest)
#include "ForceLimitsTest.moc"
