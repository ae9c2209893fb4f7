// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/MotionCheck.h"

#include "Scenes.h"
#include "TestClass.h"
#include "robot/Kinematics.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

ArmValues anyValues(Eigen::Index count) {
  ArmValues values(count);
  for (double& v : values) v = evenly(-3.0, 3.0);
  return values;
}

}  // namespace

class MotionCheckTest : public QObject {
  Q_OBJECT

 private slots:
  // One link of 1,000 mm sweeps a quarter of a circle past a ball between two samples.
  void aThinObstacleIsNotMissed() {
    const RobotModel robot = planarArm({1000.0}, 10.0);
    RobotScene scene = sceneOf(robot);
    QVERIFY(scene.isSound());
    addBall(scene, {700.0 * std::cos(0.777), 700.0 * std::sin(0.777), 0.0}, 0.5, 7);
    const ArmValues from = ArmValues::Constant(1, 0.0), to = ArmValues::Constant(1, M_PI / 2);
    MotionCheck check(scene, from, to, {});
    QVERIFY(check.run() == MotionCheck::State::Blocked);
    QCOMPARE(check.blockedBy().owner, 7u);
    QVERIFY(std::abs(check.blockedAt() * M_PI / 2 - 0.777) < 0.02);
    MotionCheck before(scene, from, ArmValues::Constant(1, 0.75), {});
    QVERIFY(before.run() == MotionCheck::State::Free);
    // 10 mm of the link and 0.5 of the ball at 700 mm: the collision begins at 0.777 - asin(10.5 / 700).
    const double touch = 0.777 - std::asin(10.5 / 700.0);
    QVERIFY(MotionCheck(scene, from, ArmValues::Constant(1, touch - 1e-3), {}).run() == MotionCheck::State::Free);
    QVERIFY(MotionCheck(scene, from, ArmValues::Constant(1, touch + 1e-3), {}).run() == MotionCheck::State::Blocked);
  }

  // Cylinders in a block, for which only a distance of 0 is known: they are too near with no clearance at all.
  void whatMeetsIsTooNear() {
    const RobotModel robot = robotOf(*libraryTable("irb120"));
    RobotScene scene = sceneOf(robot);
    scene.allowPairs(overlappingLinks(*libraryTable("irb120")));
    scene.addObstacle(CollisionBody({CollisionPiece::box(Pose::Identity(), {200.0, 200.0, 200.0})}),
                      Pose(Eigen::Translation3d(0.0, 0.0, 500.0)), 3);
    const ArmValues values = ArmValues::Zero(6);
    QCOMPARE(scene.nearestObstacle(values, 1e9).distance, 0.0);
    QCOMPARE(scene.tooNear(values, 0.0, 0.0).owner, 3u);
    QVERIFY(!scene.isFree(values, 0.0, 0.0));
  }

  // A motion found free is free at each of very many points, and keeps both clearances; a blocked one is too near at
  // the reported point.
  void freeIsFree() {
    int free = 0;
    QVERIFY(rc::check([&free] {
      const RobotModel robot = planarArm({300.0, 250.0, 200.0}, 15.0);
      RobotScene scene = sceneOf(robot);
      for (std::uint32_t i = 0; i < 6; ++i)
        addBall(scene, {evenly(-700, 700), evenly(-700, 700), evenly(-20, 20)}, evenly(1, 30), i);
      MotionCheckSettings settings;
      settings.clearance = *rc::gen::element(0.0, 5.0);
      settings.ownClearance = *rc::gen::element(0.0, 2.0);
      const ArmValues from = anyValues(3), to = anyValues(3);
      MotionCheck check(scene, from, to, settings);
      if (check.run() == MotionCheck::State::Free) {
        ++free;
        RC_ASSERT(leastAlong(scene, from, to, 2e-3) >= std::min(settings.clearance, settings.ownClearance));
        for (int i = 0; i <= 3000; ++i)
          RC_ASSERT(scene.nearestObstacle(from + i / 3000.0 * (to - from), 1e9).distance >= settings.clearance);
      } else {
        const ArmValues at = from + check.blockedAt() * (to - from);
        const bool isOwn = check.blockedBy().otherLink != kNone;
        RC_ASSERT((isOwn ? scene.nearest(at, 1e9) : scene.nearestObstacle(at, 1e9)).distance <=
                  (isOwn ? settings.ownClearance : settings.clearance) + settings.resolution);
      }
    }));
    QVERIFY(free > 10);
  }

  // An arm of more links than there are bits to mark those that are near to something: 14, and 91 pairs of them.
  void manyLinks() {
    int free = 0, blocked = 0;
    QVERIFY(rc::check([&] {
      const RobotModel robot = planarArm(std::vector<double>(14, 60.0), 8.0);
      RobotScene scene = sceneOf(robot);
      for (std::uint32_t i = 0; i < 9; ++i)
        addBall(scene, {evenly(-800, 800), evenly(-800, 800), evenly(-20, 20)}, evenly(1, 30), i);
      ArmValues from(14), to(14);
      for (Eigen::Index i = 0; i < 14; ++i) {
        from[i] = evenly(-0.4, 0.4);
        to[i] = from[i] + evenly(-0.3, 0.3);
      }
      MotionCheck check(scene, from, to, {});
      if (check.run() == MotionCheck::State::Free) {
        ++free;
        RC_ASSERT(leastAlong(scene, from, to, 2e-3) > 0.0);
      } else {
        ++blocked;
        const ArmValues at = from + check.blockedAt() * (to - from);
        const RobotScene::Nearest nearest = scene.nearest(at, 1e9);
        RC_ASSERT(nearest.distance <= 0.05);
        RC_ASSERT(!isFreeAt(scene, at, {}) && blockerAt(scene, at, {}).link != kNone);
      }
    }));
    QVERIFY(free > 10 && blocked > 10);
  }

  // The test of a free configuration agrees with the blocker, and with the list of violations.
  void freeConfigurations() {
    QVERIFY(rc::check([] {
      const RobotModel robot = planarArm({300.0, 250.0, 200.0}, 15.0);
      RobotScene scene = sceneOf(robot);
      for (std::uint32_t i = 0; i < 9; ++i)
        addBall(scene, {evenly(-700, 700), evenly(-700, 700), evenly(-20, 20)}, evenly(1, 60), i);
      MotionCheckSettings settings;
      settings.clearance = *rc::gen::element(0.0, 20.0);
      const ArmValues at = anyValues(3);
      const RobotScene::Nearest blocker = blockerAt(scene, at, settings);
      RC_ASSERT(isFreeAt(scene, at, settings) == (blocker.link == kNone));
      const double margin = 0.5 * settings.resolution;
      const auto all = scene.allTooNear(at, settings.clearance + margin, margin);
      RC_ASSERT(all.empty() == (blocker.link == kNone));
      for (const RobotScene::Nearest& each : all) RC_ASSERT(each.owner != kNone || each.otherLink != kNone);
    }));
  }

  // The reversed motion is the same.
  void bothDirections() {
    QVERIFY(rc::check([] {
      const RobotModel robot = planarArm({300.0, 250.0}, 15.0);
      RobotScene scene = sceneOf(robot);
      addBall(scene, {evenly(-500, 500), evenly(-500, 500), 0.0}, 20.0, 1);
      const ArmValues from = anyValues(2), to = anyValues(2);
      const double least = leastAlong(scene, from, to, 1e-3);
      if (std::abs(least) < 0.2) return;  // too near to decide
      const auto expected = least > 0.0 ? MotionCheck::State::Free : MotionCheck::State::Blocked;
      RC_ASSERT(MotionCheck(scene, from, to, {}).run() == expected);
      RC_ASSERT(MotionCheck(scene, to, from, {}).run() == expected);
    }));
  }

  // Links meet each other, too.
  void aFoldedArmMeetsItself() {
    const RobotModel robot = planarArm({300.0, 50.0, 300.0}, 15.0);
    const RobotScene scene = sceneOf(robot);
    ArmValues from = ArmValues::Zero(3), to = ArmValues::Zero(3);
    to << 0.0, 1.6, 2.9;
    MotionCheck check(scene, from, to, {});
    QVERIFY(check.run() == MotionCheck::State::Blocked);
    QCOMPARE(robot.links[check.blockedBy().link].name, std::string("link_1"));
    QCOMPARE(robot.links[check.blockedBy().otherLink].name, std::string("link_3"));
    to << 0.0, 1.6, 1.4;  // back along itself, 50 mm beside
    QVERIFY(MotionCheck(scene, from, to, {}).run() == MotionCheck::State::Free);
  }

  // So many turns that checking all of them would take a lifetime.
  void anEndlessMotionIsCancelled() {
    const RobotModel robot = planarArm({300.0, 250.0}, 15.0);
    RobotScene scene = sceneOf(robot);
    addBall(scene, {700.0, 0.0, 0.0}, 100.0, 1);  // 35 mm beyond the reach
    MotionCheck endless(scene, ArmValues::Zero(2), ArmValues::Constant(2, 1e9), {});
    JobState state;
    std::thread person([&] {
      while (state.polls < 1000) std::this_thread::yield();
      state.cancelled = true;
    });
    QVERIFY(endless.run(Progress(state)) == MotionCheck::State::Open);
    person.join();
    QVERIFY(endless.steps() >= 999);
    // The search continues from there.
    ArmValues half = ArmValues::Zero(2);
    half[0] = 3.0;
    MotionCheck motion(scene, ArmValues::Zero(2), half, {}), whole(scene, ArmValues::Zero(2), half, {});
    QVERIFY(motion.run(Progress(state)) == MotionCheck::State::Open);
    QCOMPARE(motion.steps(), std::uint64_t{0});
    QVERIFY(motion.run() == MotionCheck::State::Free && whole.run() == MotionCheck::State::Free);
    QCOMPARE(motion.steps(), whole.steps());
  }

  void extremes() {
    const RobotModel robot = planarArm({300.0, 250.0}, 15.0);
    RobotScene scene = sceneOf(robot);
    const ArmValues still = ArmValues::Zero(2);
    QVERIFY(MotionCheck(scene, still, still, {}).run() == MotionCheck::State::Free);
    addBall(scene, {400.0, 0.0, 0.0}, 100.0, 1);
    MotionCheck inside(scene, still, still, {});
    QVERIFY(inside.run() == MotionCheck::State::Blocked);
    QVERIFY(inside.blockedBy().distance <= 0.0);
    ArmValues broken = still;
    broken[0] = std::nan("");
    QVERIFY(MotionCheck(scene, still, broken, {}).run() == MotionCheck::State::Blocked);
    // Many turns at once.
    QVERIFY(MotionCheck(scene, still, ArmValues::Constant(2, 1e3), {}).run() == MotionCheck::State::Blocked);
  }
};

HANDWHEEL_TEST(MotionCheckTest)
#include "MotionCheckTest.moc"
