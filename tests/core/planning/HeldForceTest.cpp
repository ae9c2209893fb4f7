// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/HeldForce.h"

#include "Scenes.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr std::uint32_t kHeld = 1, kWall = 2, kOther = 3;
constexpr double kReach = 10.0, kStiffness = 0.5, kHalf = 10.0;  // mm, N/mm, mm
constexpr DistanceForceSettings kLaw{.reach = kReach, .stiffness = kStiffness, .largestForce = 50.0};

CollisionBody box(const Vec3& size) {
  return CollisionBody({CollisionPiece::box(Pose::Identity(), size)});
}

Pose at(const Vec3& position) {
  return Pose(Eigen::Translation3d(position));
}

// A cube of 20 mm about the point (0, 1000, 0), far from an arm of balls.
class HeldCube {
 public:
  static Vec3 middle() { return {0.0, 1000.0, 0.0}; }
  HeldCube() : m_scene(sceneOf(planarArm({100.0}, 5.0))) {
    m_scene.addObstacle(box(Vec3::Constant(2.0 * kHalf)), at(middle()), kHeld);
  }
  RobotScene& scene() { return m_scene; }
  // Adds a wall whose surface is this far from the middle of the cube, towards this side of x.
  void addWall(double x, double side = 1.0, std::uint32_t owner = kWall) {
    m_scene.addObstacle(box({100.0, 4000.0, 4000.0}), at(middle() + Vec3(side * (x + 50.0), 0.0, 0.0)), owner);
  }
  HeldForce force(const DistanceForceSettings& law = kLaw) const {
    std::uint32_t held = 0;
    ProximityQuery query = m_scene.heldQuery(
        ArmValues::Zero(1),
        [](const RobotScene::Object& object) {
          return object.owner == kHeld ? RobotScene::HeldRole::Held : RobotScene::HeldRole::Near;
        },
        held);
    return {std::move(query), held, law};
  }
  // Turned about its middle.
  static Pose turned(const Eigen::Matrix3d& by) { return at(middle()) * Pose(by) * at(-middle()); }

 private:
  RobotScene m_scene;
};

}  // namespace

// The force on a body that a hand holds.
class HeldForceTest : public QObject {
  Q_OBJECT

 private slots:
  // Before a wall: the stiffness times the distance below the reach, straight away from the wall; for a penetration the
  // depth counts, too.
  void beforeAWall() {
    HeldCube cube;
    cube.addWall(kHalf + 30.0);
    HeldForce force = cube.force();
    for (const double distance : {20.0, 10.0, 9.0, 4.0, 0.5, 0.0, -3.0}) {
      const HeldForce::Felt felt = force.at(at({30.0 - distance, 0.0, 0.0}), HeldCube::middle());
      const Vec3 expected(-kStiffness * std::max(0.0, kReach - distance), 0.0, 0.0);
      QVERIFY2((felt.wrench.force - expected).norm() < 1e-6, qPrintable(QString::number(distance)));
      QVERIFY(distance >= kReach ? std::isinf(felt.distance) : std::abs(felt.distance - distance) < 1e-6);
    }
  }

  // With one corner nearer the force is that at the corner, and the torque turns the corner away from the wall.
  void aCornerIsNearer() {
    HeldCube cube;
    cube.addWall(25.0);
    HeldForce force = cube.force();
    for (const double tilt : {0.3, -0.3}) {
      // About z, then a little about y: one corner of eight is the farthest along x.
      const Eigen::Matrix3d turn =
          (Eigen::AngleAxisd(0.1, Vec3::UnitY()) * Eigen::AngleAxisd(tilt, Vec3::UnitZ())).toRotationMatrix();
      Vec3 corner = Vec3::Zero();
      for (int i = 0; i < 8; ++i) {
        const Vec3 each = turn * Vec3(i & 1 ? kHalf : -kHalf, i & 2 ? kHalf : -kHalf, i & 4 ? kHalf : -kHalf);
        if (each.x() > corner.x()) corner = each;
      }
      const double distance = 25.0 - corner.x() - 4.0;
      const Vec3 hand(1.0, 2.0, 3.0);  // from the middle of the cube
      const Pose pose = at({4.0, 0.0, 0.0}) * HeldCube::turned(turn);
      const Vec3 middle = HeldCube::middle() + Vec3(4.0, 0.0, 0.0);
      const HeldForce::Felt felt = force.at(pose, middle + hand);
      const Vec3 expected(-kStiffness * (kReach - distance), 0.0, 0.0);
      QVERIFY(distance > 0.0 && distance < kReach);
      QVERIFY((felt.wrench.force - expected).norm() < 1e-6);
      QVERIFY((felt.wrench.torque - (corner - hand).cross(expected)).norm() < 1e-4);
      // A small turn by the torque about the middle increases the distance.
      const Vec3 about = force.at(pose, middle).wrench.torque.normalized();
      const Pose further = at(middle) * Pose(Eigen::AngleAxisd(0.01, about).toRotationMatrix()) * at(-middle) * pose;
      QVERIFY(force.at(further, middle).distance > felt.distance + 1e-3);
    }
  }

  // Between two walls their forces are added: none in the middle. A larger force than the largest is scaled down with
  // its torque.
  void addsAndLimits() {
    HeldCube cube;
    cube.addWall(kHalf + 5.0);
    cube.addWall(kHalf + 5.0, -1.0, kOther);
    HeldForce force = cube.force();
    QVERIFY(force.at(Pose::Identity(), HeldCube::middle()).wrench.force.norm() < 1e-9);
    const Vec3 felt = force.at(at({2.0, 0.0, 0.0}), HeldCube::middle()).wrench.force;
    QVERIFY((felt - kStiffness * Vec3(-7.0 + 3.0, 0.0, 0.0)).norm() < 1e-6);  // 3 mm from one, 7 mm from the other
    DistanceForceSettings weak = kLaw;
    weak.largestForce = 1.0;
    const Vec3 hand = HeldCube::middle() + Vec3(0.0, 50.0, 0.0);
    const DistanceWrench all = force.at(at({2.0, 0.0, 0.0}), hand).wrench;
    const DistanceWrench limited = cube.force(weak).at(at({2.0, 0.0, 0.0}), hand).wrench;
    QVERIFY(std::abs(limited.force.norm() - 1.0) < 1e-9);
    QVERIFY((limited.torque - all.torque * (1.0 / all.force.norm())).norm() < 1e-6 * all.torque.norm());
  }

  // Links push a body as walls do; an object that is left out does not, nor does one that it touched at first.
  void linksAndOthers() {
    RobotScene scene = sceneOf(planarArm({100.0}, 5.0));  // the last ball of the link is at x 100
    scene.addObstacle(box(Vec3::Constant(20.0)), at({100.0 + 5.0 + 4.0 + 10.0, 0.0, 0.0}), kHeld);
    scene.addObstacle(box({20.0, 20.0, 20.0}), at({119.0, 0.0, -20.0}), kWall);  // its face touches that of the cube
    const auto forceWith = [&](RobotScene::HeldRole ofLinks) {
      std::uint32_t held = 0;
      ProximityQuery query = scene.heldQuery(
          ArmValues::Zero(1),
          [&](const RobotScene::Object& object) {
            return object.link != kNone    ? ofLinks
                   : object.owner == kHeld ? RobotScene::HeldRole::Held
                                           : RobotScene::HeldRole::Near;
          },
          held);
      return HeldForce(std::move(query), held, kLaw);
    };
    const Vec3 hand(119.0, 0.0, 0.0);
    HeldForce all = forceWith(RobotScene::HeldRole::Near), without = forceWith(RobotScene::HeldRole::LeftOut);
    const Vec3 ofLink(kStiffness * (kReach - 4.0), 0.0, 0.0), ofFloor(0.0, 0.0, kStiffness * kReach);
    QVERIFY((all.at(Pose::Identity(), hand).wrench.force - ofLink - ofFloor).norm() < 1e-6);
    QVERIFY((without.at(Pose::Identity(), hand).wrench.force - ofFloor).norm() < 1e-6);
    all.leaveOutTouching();
    QVERIFY((all.at(Pose::Identity(), hand).wrench.force - ofLink).norm() < 1e-6);
  }

  // For all poses and sizes the force is finite and within its limit.
  void anything() {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    HeldCube cube;
    cube.addWall(kHalf + 5.0);
    cube.scene().addObstacle(box(Vec3::Constant(2e7)), at({-2e7, 0.0, 0.0}), kOther);
    cube.scene().addObstacle(CollisionBody(), Pose::Identity(), 4);
    HeldForce force = cube.force();
    for (const double value : {0.0, 5.0, 15.0, 60.0, -1e7, 1e9, 1e300, kInfinite, std::nan("")}) {
      const HeldForce::Felt felt = force.at(at({value, 0.0, 0.0}), HeldCube::middle());
      QVERIFY2(felt.wrench.force.allFinite() && felt.wrench.torque.allFinite(), qPrintable(QString::number(value)));
      QVERIFY(felt.wrench.force.norm() <= kLaw.largestForce + 1e-9 && !std::isnan(felt.distance));
      QVERIFY(force.at(Pose::Identity(), Vec3::Constant(value)).wrench.torque.allFinite());
    }
    QVERIFY(std::abs(force.at(Pose::Identity(), HeldCube::middle()).distance - 5.0) < 1e-6);
    // Nothing is held.
    HeldForce nothing(ProximityQuery({}, {}), 0, kLaw);
    QVERIFY(nothing.at(Pose::Identity(), Vec3::Zero()).wrench.force.isZero(0.0));
  }
};

HANDWHEEL_TEST(HeldForceTest)
#include "HeldForceTest.moc"
