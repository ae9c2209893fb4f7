// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/PathVerification.h"

#include "Scenes.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr std::uint32_t kBox = 9;

// A cube of triangles, which has an inside.
CollisionPiece cube(double half) {
  TriangleSoup soup;
  for (int i = 0; i < 8; ++i)
    soup.points.push_back(half * Vec3(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0));
  soup.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return CollisionPiece::ofMesh(Pose::Identity(), std::make_shared<CollisionMesh>(soup));
}

ArmValues turned(double angle) {
  return ArmValues::Constant(1, angle);
}

}  // namespace

class PathVerificationTest : public QObject {
  Q_OBJECT

 private slots:
  // One link of 1,000 mm passes two balls, there and back: the positions of the collisions are known.
  void allStretchesAreListed() {
    RobotScene scene = sceneOf(planarArm({1000.0}, 10.0));
    const double angles[] = {-0.6, 0.7};
    for (std::uint32_t i = 0; i < 2; ++i)
      addBall(scene, {700.0 * std::cos(angles[i]), 700.0 * std::sin(angles[i]), 0.0}, 60.0, i);
    const JointPath path{turned(-1.2), turned(1.2), turned(-1.2), turned(-1.1)};
    const double step = 5e-3;
    const VerifiedPath result = verified(scene, path, {}, step);
    QVERIFY((result.certified == std::vector<bool>{false, false, true}));
    QCOMPARE(result.collisions.size(), std::size_t{4});
    const double touch = std::asin(70.0 / 700.0);  // off the ball's angle
    for (std::size_t i = 0; i < 4; ++i) {
      const PathCollision& each = result.collisions[i];
      QCOMPARE(each.motion, i / 2);
      const std::uint32_t owner = i == 0 || i == 3 ? 0 : 1;
      QCOMPARE(each.deepest.owner, owner);
      const double displacement = i < 2 ? 2.4 : -2.4, begin = i < 2 ? -1.2 : 1.2;
      const double sign = i < 2 ? 1.0 : -1.0;
      QVERIFY(std::abs(begin + displacement * each.from - (angles[owner] - sign * touch)) < 2.0 * step);
      QVERIFY(std::abs(begin + displacement * each.to - (angles[owner] + sign * touch)) < 2.0 * step);
      QVERIFY(each.from <= each.deepestAt && each.deepestAt <= each.to);
    }
  }

  // Two obstacles at once are two collisions.
  void eachPairIsListed() {
    RobotScene scene = sceneOf(planarArm({1000.0}, 10.0));
    for (std::uint32_t i = 0; i < 3; ++i) addBall(scene, {300.0 + 200.0 * i, 0.0, 0.0}, 20.0, i);
    const VerifiedPath result = verified(scene, {turned(-1.0), turned(1.0)}, {});
    std::set<std::uint32_t> owners;
    for (const PathCollision& each : result.collisions) owners.insert(each.deepest.owner);
    QVERIFY((owners == std::set<std::uint32_t>{0, 1, 2}));
  }

  // An obstacle thinner than the step between samples is found by the proof, and listed.
  void thinObstaclesAreListed() {
    RobotScene scene = sceneOf(planarArm({1000.0}, 0.5));
    addBall(scene, {800.0 * std::cos(0.3456), 800.0 * std::sin(0.3456), 0.0}, 0.1, 5);
    const VerifiedPath result = verified(scene, {turned(0.0), turned(1.0)}, {}, 0.1);
    QVERIFY(!result.isCertified());
    QCOMPARE(result.collisions.size(), std::size_t{1});
    QCOMPARE(result.collisions[0].deepest.owner, 5u);
    QVERIFY(std::abs(result.collisions[0].deepestAt - 0.3456) < 1e-3);
  }

  // The surface of the cube is far from the arm, which is inside it as a whole.
  void aStartInsideIsFound() {
    RobotScene scene = sceneOf(planarArm({100.0}, 10.0));
    scene.addObstacle(CollisionBody({cube(500.0)}), Pose::Identity(), kBox);
    for (const JointPath& path : {JointPath{turned(0.0), turned(1.0)}, JointPath{turned(0.0)}}) {
      const VerifiedPath result = verified(scene, path, {});
      QVERIFY(!result.isCertified());
      QCOMPARE(result.collisions.size(), std::size_t{1});
      QCOMPARE(result.collisions[0].from, 0.0);
      QCOMPARE(result.collisions[0].to, path.size() > 1 ? 1.0 : result.collisions[0].to);
      QCOMPARE(result.collisions[0].deepest.owner, kBox);
    }
  }

  // A violated clearance is a collision.
  void clearanceCounts() {
    RobotScene scene = sceneOf(planarArm({1000.0}, 10.0));
    addBall(scene, {700.0 * std::cos(0.5), 700.0 * std::sin(0.5), 100.0}, 60.0, 1);
    QVERIFY(verified(scene, {turned(0.0), turned(1.0)}, {}).isCertified());
    MotionCheckSettings check;
    check.clearance = 40.0;
    const VerifiedPath result = verified(scene, {turned(0.0), turned(1.0)}, check, 1e-3);
    QCOMPARE(result.collisions.size(), std::size_t{1});
    QVERIFY(std::abs(result.collisions[0].deepest.distance - 30.0) < 0.1);
    // 110 mm from the row of balls, of which 100 are height.
    const double touch = std::asin(std::sqrt(110.0 * 110.0 - 100.0 * 100.0) / 700.0);
    QVERIFY(std::abs(result.collisions[0].from - (0.5 - touch)) < 2e-3);
    QVERIFY(std::abs(result.collisions[0].to - (0.5 + touch)) < 2e-3);
  }

  void extremes() {
    const RobotScene scene = sceneOf(planarArm({100.0}, 10.0));
    QVERIFY(verified(scene, {}, {}).isCertified());
    QVERIFY(verified(scene, {turned(1.0)}, {}).isCertified());
    const VerifiedPath broken = verified(scene, {turned(0.0), turned(std::nan("")), turned(0.0)}, {});
    QVERIFY((broken.certified == std::vector<bool>{false, false}));
    QCOMPARE(broken.collisions.size(), std::size_t{2});
    JobState state;
    state.cancelled = true;
    QVERIFY(verified(scene, {turned(0.0), turned(1.0)}, {}, 0.01, Progress(state)).certified.empty());
  }
};

HANDWHEEL_TEST(PathVerificationTest)
#include "PathVerificationTest.moc"
