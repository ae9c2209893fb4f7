// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/scene/SceneForces.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "haptics/scene/MeshHaptics.h"

#include <QtTest>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Returns a cube of 10 mm, whose top is at z = 10.
TouchedSurface cubeFeel(double stiffness, double damping = 0.0) {
  const TriangleSoup s = cube(10.0);
  return {ContactSurface(s.points, s.triangles), stiffness, damping, {}};
}

ForceOut feltAt(SceneForces& scene, const Vec3& position, double limit = std::numeric_limits<double>::infinity(),
                double dampingLimit = std::numeric_limits<double>::infinity(), const Vec3& velocity = Vec3::Zero()) {
  TipState tip;
  tip.position = position;
  tip.velocity = velocity;
  tip.isRestart = false;
  tip.stiffnessLimit = limit;
  tip.dampingLimit = dampingLimit;
  ForceOut out;
  out.proxy = position;
  scene.tick(tip, out);
  return out;
}

bool isNear(const Vec3& a, const Vec3& b) {
  return (a - b).norm() < 1e-5;
}

}  // namespace

class SceneForcesTest : public QObject {
  Q_OBJECT

 private slots:
  void nothingToFeel() {
    SceneForces scene({});
    const ForceOut out = feltAt(scene, {1, 2, 3});
    QVERIFY(out.force.isZero(0.0) && !out.isContact && out.stiffness == 0.0);
    QCOMPARE(out.proxy, Vec3(1, 2, 3));
  }

  // A tip that appears inside of a cube, or to which the cube appears, comes to rest on the side of its approach.
  void aTipThatAppearsComesFromTheViewer() {
    for (const Vec3& from : {Vec3(0, 0, 1), Vec3(0, -1, 0), Vec3(1, 0, 0)}) {
      const Vec3 inside = Vec3::Constant(5.0) + 0.5 * from;
      const auto scene = [&] {
        MeshHaptics feel;
        feel.surface = cubeFeel(0.5);
        feel.comesFrom = from;
        return SceneForces(forceSources(std::move(feel)));
      };
      SceneForces first = scene();
      ForceOut out;
      for (int i = 0; i < 10; ++i) out = feltAt(first, inside);
      QVERIFY(out.isContact && isNear(out.proxy, Vec3::Constant(5.0) + 5.0 * from));
      SceneForces nothing({});
      feltAt(nothing, inside);
      SceneForces second = scene();
      second.follow(nothing);
      for (int i = 0; i < 10; ++i) out = feltAt(second, inside);
      QVERIFY(out.isContact && isNear(out.proxy, Vec3::Constant(5.0) + 5.0 * from));
      SceneForces third = scene();  // beside it, nothing is between
      const Vec3 beside = Vec3::Constant(5.0) + 30.0 * from.unitOrthogonal();
      for (int i = 0; i < 10; ++i) out = feltAt(third, beside);
      QVERIFY(!out.isContact && out.proxy == beside);
    }
  }

  void sumsWhatActs() {
    MeshHaptics feel;
    feel.surface = cubeFeel(0.5);
    feel.springs = {{Vec3(5, 5, 20), 0.1}};
    SceneForces scene(forceSources(std::move(feel)));
    QVERIFY(isNear(feltAt(scene, {5, 5, 12}).force, {0, 0, 0.8}));
    const ForceOut out = feltAt(scene, {5, 5, 8});
    QVERIFY(isNear(out.force, {0, 0, 1.0 + 1.2}));
    QVERIFY(out.isContact && isNear(out.proxy, {5, 5, 10}));
    QCOMPARE(out.stiffness, 0.6);
    QCOMPARE(out.asked, 0.6);
    QVERIFY(!out.isSoftened);
    const ForceOut soft = feltAt(scene, {5, 5, 8}, 0.3);
    QCOMPARE(soft.stiffness, 0.3);
    QCOMPARE(soft.asked, 0.6);
  }

  // A thread pulls with k times its length, and damps with b times the speed against the motion.
  void pullsLikeAThread() {
    MeshHaptics feel;
    feel.springs = {{Vec3(1, 0, 0), 0.1, 0.002}};
    SceneForces scene(forceSources(std::move(feel)));
    const double open = std::numeric_limits<double>::infinity();
    const ForceOut out = feltAt(scene, {11, 0, 0}, open, open, {30, 40, 0});
    QVERIFY(isNear(out.force, {-1.0 - 0.06, -0.08, 0}));
    // Half of the damping of a device of 0.002 N·s/mm is left to it, and half of the stiffness that it carries.
    const ForceOut soft = feltAt(scene, {11, 0, 0}, 0.1, 0.002, {30, 40, 0});
    QVERIFY(soft.isSoftened);
    QVERIFY(isNear(soft.force, {-0.5 - 0.03, -0.04, 0}));
  }

  // k times the angle about the axis of the shortest rotation; opposite quaternions give none, and the position has no
  // part in it.
  void turnsTheTip() {
    const auto torqueAt = [](const Eigen::Quaterniond& from, std::vector<Spring> springs) {
      MeshHaptics feel;
      feel.springs = std::move(springs);
      SceneForces scene(forceSources(std::move(feel)));
      TipState tip;
      tip.position = Vec3(4, 5, 6);
      tip.orientation = from;
      ForceOut out;
      scene.tick(tip, out);
      return out.torque;
    };
    const auto turnedBy = [](double angle, const Vec3& axis) {
      return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
    };
    const Eigen::Quaterniond from = turnedBy(0.7, Vec3(1, -2, 2) / 3.0);
    const Vec3 axis = Vec3(2, 1, -2) / 3.0;
    for (const double angle : {0.0, 1e-9, 0.3, 1.5, 3.1}) {
      for (const double sign : {1.0, -1.0}) {
        Spring spring;
        spring.turn = turnedBy(sign * angle, axis) * from;
        spring.turning = 40.0;
        QVERIFY((torqueAt(from, {spring}) - 40.0 * sign * angle * axis).norm() < 1e-6);
        Spring same = spring;
        same.turn.coeffs() *= -1.0;  // the same orientation
        QVERIFY((torqueAt(from, {same}) - 40.0 * sign * angle * axis).norm() < 1e-6);
        Spring back = spring;
        back.turn = turnedBy(-sign * angle, axis) * from;
        QVERIFY(torqueAt(from, {spring, back}).norm() < 1e-6);
      }
    }
    QVERIFY((torqueAt(from, {{Vec3::Zero(), 0.0, 0.0, turnedBy(4.0, axis) * from, 40.0}}) -
             40.0 * (4.0 - 2.0 * M_PI) * axis)
                .norm() < 1e-6);
    QVERIFY(torqueAt(from, {{Vec3(9, 9, 9), 1.0}}).isZero(0.0));
  }

  // Like a force, the torque of a target that is caught grows within a tenth of a second, in equal steps.
  void aTurningSpringGrowsIn() {
    SceneForces nothing({});
    feltAt(nothing, Vec3::Zero());
    MeshHaptics feel;
    feel.springs = {{Vec3::Zero(), 0.0, 0.0, Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Vec3::UnitY())), 60.0}};
    SceneForces scene(forceSources(std::move(feel)));
    scene.follow(nothing);
    for (int i = 0; i <= 120; ++i)
      QVERIFY(isNear(feltAt(scene, Vec3::Zero()).torque, {0, 30.0 * std::min(1.0, i / 100.0), 0}));
  }

  void snapsToAFeature() {
    SnapFeatures features;
    features.addPoint(7, {0, 0, 0});
    MeshHaptics feel;
    feel.snap = SnapAttraction{SnapField(features), SnapProfile(SnapShape::Triangular, 0.4, 4.0), SnapMethod::Sum};
    SceneForces scene(forceSources(std::move(feel)));
    QVERIFY(isNear(feltAt(scene, {1, 0, 0}).force, {-0.4, 0, 0}));
    QCOMPARE(scene.source<SnapForce>(kSnapSource)->pull().featureCount, 1u);
  }

  // A face draws a tip above it by the quadratic profile, and leaves one that touches it to the surface. Through the
  // surface the force changes by no more than the stiffer of the two allows. `held` is set for points and edges.
  void aFaceDrawsOnlyFromAbove() {
    SnapFeatures features;
    features.addTriangle(1, {0, 0, 10}, {10, 0, 10}, {10, 10, 10});
    features.addPoint(2, {0, 0, 10});
    MeshHaptics feel;
    feel.surface = cubeFeel(0.5);
    feel.snap = SnapAttraction{SnapField(features), SnapProfile(SnapShape::Quadratic, 0.3, 2.0), SnapMethod::Proxy};
    SceneForces scene(forceSources(std::move(feel)));
    const ForceOut above = feltAt(scene, {7, 3, 10.5});
    QVERIFY(isNear(above.force, {0, 0, -2.0 * 0.3 * 0.5 * 1.5 / 2.0}) && isNear(above.proxy, {7, 3, 10}));
    QVERIFY(!above.isContact && !above.isHeld);
    QCOMPARE(above.stiffness, 0.6);
    Vec3 last = above.force;
    for (double z = 10.5; z > 9.0; z -= 1e-3) {
      const ForceOut out = feltAt(scene, {7, 3, z});
      QVERIFY((out.force - last).norm() <= 0.6 * 1e-3 + 1e-6);
      if (z < 10.0 - 1e-3) QVERIFY(out.isContact && isNear(out.force, {0, 0, 0.5 * (10.0 - z)}));
      last = out.force;
    }
    feltAt(scene, {7, 3, 14});
    const ForceOut corner = feltAt(scene, {0.5, 0.25, 10.5});
    QVERIFY(corner.isHeld && isNear(corner.held, {0, 0, 10}));
    QVERIFY(!feltAt(scene, {7, 3, 14}).isHeld);
  }

  // Forces too stiff for the loop are softened alike, damping and springs: K <= limit (1 - B / dampingLimit).
  void isSoftenedAsAWhole() {
    MeshHaptics feel;
    feel.surface = cubeFeel(1.5, 0.002);
    feel.springs = {{Vec3(5, 5, 20), 0.5}};
    SceneForces scene(forceSources(std::move(feel)));
    feltAt(scene, {5, 5, 12});
    const ForceOut still = feltAt(scene, {5, 5, 8}, 1.0, 0.004);
    QVERIFY(still.isSoftened);
    QVERIFY(std::abs(still.stiffness - 0.5) < 1e-12);
    QVERIFY(isNear(still.force, {0, 0, 0.25 * (1.5 * 2 + 0.5 * 12)}));
    // With more damping than the device has, half of its own is applied.
    const ForceOut slow = feltAt(scene, {5, 5, 8}, 1.0, 0.001, {0, 0, -10});
    QVERIFY(std::abs(slow.stiffness - 0.5) < 1e-12);
    QVERIFY(isNear(slow.force, {0, 0, 0.25 * (1.5 * 2 + 0.5 * 12) + 0.0005 * 10}));
  }

  void goesOnFromTheOneBefore() {
    MeshHaptics before, after;
    before.surface = cubeFeel(0.5);
    after.surface = before.surface;
    after.surface->surface.update(std::vector<std::uint32_t>{0}, {});  // an edit of the bottom
    SceneForces first(forceSources(std::move(before))), second(forceSources(std::move(after)));
    feltAt(first, {5, 5, 12});
    feltAt(first, {5, 5, 7});
    second.follow(first);
    const ForceOut out = feltAt(second, {5, 5, 7});
    QVERIFY(out.isContact && isNear(out.force, {0, 0, 1.5}));
    // A scene of another model begins at the tip, at any position.
    MeshHaptics other;
    other.surface = cubeFeel(0.5);
    SceneForces elsewhere(forceSources(std::move(other)));
    elsewhere.follow(first);
    QVERIFY(!feltAt(elsewhere, {5, 5, 7}).isContact);
    // A scene without a predecessor does so, too.
    MeshHaptics alone;
    alone.surface = cubeFeel(0.5);
    SceneForces third(forceSources(std::move(alone)));
    QVERIFY(!feltAt(third, {5, 5, 7}).isContact);
  }

  void beginsAnewAfterALeap() {
    MeshHaptics feel;
    feel.surface = cubeFeel(0.5);
    SceneForces scene(forceSources(std::move(feel)));
    feltAt(scene, {5, 5, 12});
    TipState tip;
    tip.position = Vec3(5, 5, 5);
    tip.isRestart = true;
    ForceOut out;
    scene.tick(tip, out);
    QVERIFY(!out.isContact && out.force.isZero(0.0));
  }

  // While a thread of 10 mm is pulled along a surface, a target is caught, and let go again: each time 1 N comes and
  // goes within a tenth of a second, in equal steps, and the surface pushes all the while.
  void aSpringGrowsInAndFades() {
    const Vec3 tip(5, 5, 9), target(5, 7, 9);
    const TouchedSurface surface = cubeFeel(0.5);
    const auto scene = [&](bool hasTarget) {
      MeshHaptics feel;
      feel.surface = surface;
      feel.springs = {{Vec3(-5, 5, 9), 0.1}};
      if (hasTarget) feel.springs.push_back({target, 0.5});
      return std::make_unique<SceneForces>(forceSources(std::move(feel)));
    };
    auto now = scene(false);
    feltAt(*now, {5, 5, 12});
    const Vec3 thread(-1.0, 0, 0.5);
    QVERIFY(isNear(feltAt(*now, tip).force, thread));
    for (const bool hasTarget : {true, false}) {
      auto next = scene(hasTarget);
      next->follow(*now);
      now = std::move(next);
      const Vec3 change = hasTarget ? Vec3(0, 1, 0) : Vec3(0, -1, 0);
      const Vec3 from = hasTarget ? thread : Vec3(thread + Vec3(0, 1, 0));
      for (int i = 0; i <= 120; ++i) QVERIFY(isNear(feltAt(*now, tip).force, from + std::min(1.0, i / 100.0) * change));
    }
  }

  // A button is pressed where a feature pulls most, 0.3 N/mm over 5 mm by the quadratic profile: 0.75 N that go in
  // steps.
  void aFeatureThatIsLetGoFades() {
    SnapFeatures features;
    features.addPoint(7, {0, 0, 0});
    MeshHaptics feel;
    feel.snap = SnapAttraction{SnapField(features), SnapProfile(SnapShape::Quadratic, 0.3, 5.0)};
    SceneForces drawn(forceSources(std::move(feel)));
    const Vec3 tip(2.5, 0, 0);
    QVERIFY(isNear(feltAt(drawn, tip).force, {-0.75, 0, 0}));
    SceneForces held({});
    held.follow(drawn);
    for (int i = 0; i <= 120; ++i)
      QVERIFY(isNear(feltAt(held, tip).force, {-0.75 * std::max(0.0, 1.0 - i / 100.0), 0, 0}));
  }

  // Scenes are exchanged in each tick, with the same spring: the force does not lag behind a hand that moves to and fro
  // at 10 Hz and 5 mm.
  void exchangedScenesDoNotLag() {
    const auto scene = [] {
      MeshHaptics feel;
      feel.springs = {{Vec3(0, 0, 0), 0.5}};
      return std::make_unique<SceneForces>(forceSources(std::move(feel)));
    };
    auto now = scene();
    const double open = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 500; ++i) {
      const double phase = 2.0 * M_PI * 0.01 * i;
      const Vec3 tip(5.0 * std::sin(phase), 0, 0), velocity(5.0 * 2.0 * M_PI * 10.0 * std::cos(phase), 0, 0);
      const Vec3 force = feltAt(*now, tip, open, open, velocity).force;
      QVERIFY2((force + 0.5 * tip).norm() < 0.005, qPrintable(QString::number(i)));
      auto next = scene();
      next->follow(*now);
      now = std::move(next);
    }
  }

  // A tip that comes from elsewhere has no past.
  void afterARestartNothingFades() {
    MeshHaptics feel;
    feel.springs = {{Vec3(10, 0, 0), 0.5}};
    SceneForces before(forceSources(std::move(feel)));
    feltAt(before, Vec3::Zero());
    SceneForces after({});
    after.follow(before);
    TipState tip;
    ForceOut out;
    after.tick(tip, out);
    QVERIFY(tip.isRestart && out.force.isZero(0.0));
  }
};

HANDWHEEL_TEST(SceneForcesTest)
#include "SceneForcesTest.moc"
