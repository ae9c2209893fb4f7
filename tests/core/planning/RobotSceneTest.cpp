// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/RobotScene.h"

#include "Scenes.h"
#include "TestClass.h"
#include "planning/PathShortcuts.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A ball of 2 mm on two slides, along x and y.
RobotModel slidingBall() {
  DhTable table;
  for (const char* const name : {"y", "x"}) {
    DhJoint joint;
    joint.name = name;
    joint.isPrismatic = true;
    joint.alpha = M_PI / 2;
    joint.lower = -100.0;
    joint.upper = 100.0;
    table.joints.push_back(joint);
  }
  RobotModel robot = handwheel::robotOf(table);
  robot.shapes.clear();
  for (Link& link : robot.links) {
    link.visuals.clear();
    link.collisions.clear();
  }
  robot.links[2].collisions.push_back({0, Pose::Identity(), {}});
  robot.shapes.emplace_back(SphereShape{2.0});
  return robot;
}

ArmValues two(double first, double second) {
  ArmValues values(2);
  values << first, second;
  return values;
}

}  // namespace

class RobotSceneTest : public QObject {
  Q_OBJECT

 private slots:
  // If the joints deviate by at most so much anywhere on a motion, no point of the arm is farther away than the bound.
  void boundAlongAMotion() {
    QVERIFY(rc::check([] {
      const std::vector<double> lengths{400.0, 300.0, 200.0};
      const RobotModel robot = test::planarArm(lengths, 5.0);
      const RobotScene scene = sceneOf(robot);
      ArmValues from(3), to(3), spread(3), off(3);
      for (Eigen::Index i = 0; i < 3; ++i) {
        from[i] = evenly(-2.0, 2.0);
        to[i] = from[i] + evenly(-0.1, 0.1);
        spread[i] = evenly(0.0, 0.01);
        off[i] = evenly(-1.0, 1.0) * spread[i];
      }
      const auto end = [&](const ArmValues& values) {
        double turn = 0.0;
        Vec3 at = Vec3::Zero();
        for (Eigen::Index i = 0; i < 3; ++i) {
          turn += values[i];
          at += lengths[static_cast<std::size_t>(i)] * Vec3(std::cos(turn), std::sin(turn), 0.0);
        }
        return at;
      };
      const ArmValues on = from + evenly(0.0, 1.0) * (to - from);
      RC_ASSERT((end(on + off) - end(on)).norm() <= scene.travelBound(from, to, spread));
      // The bound is useful only while it is not much more than that of a single configuration.
      RC_ASSERT(scene.travelBound(from, to, spread) <= 1.5 * scene.travelBound(from, spread) + 1e-9);
    }));
  }

  // The first and the third link of an arm that is folded, as rows of balls.
  void depthOfWhatOverlaps() {
    const RobotScene scene = sceneOf(planarArm({600.0, 100.0, 600.0}, 25.0));
    ArmValues folded(3);
    folded << 0.0, M_PI / 2.0, M_PI / 2.0;
    QVERIFY(scene.overlappingLinks(folded).empty());  // 100 mm apart
    folded << 0.0, 2.9, 0.0;
    const auto overlapping = scene.overlappingLinks(folded);
    QCOMPARE(overlapping.size(), std::size_t{1});
    QVERIFY(overlapping[0].otherLink != overlapping[0].link);
    // All pairs of balls of both links, by hand.
    double depth = 0.0;
    for (double x = 50.0; x <= 600.0; x += 25.0) {
      for (double y = 50.0; y <= 600.0; y += 25.0) {
        const Vec3 along(std::cos(2.9), std::sin(2.9), 0.0);
        depth = std::max(depth, 50.0 - (Vec3(x, 0.0, 0.0) - Vec3(600.0, 0.0, 0.0) - (100.0 + y) * along).norm());
      }
    }
    QVERIFY(depth > 1.0);
    QVERIFY(std::abs(-overlapping[0].distance - depth) < 1e-9);
    const auto touches = scene.touches(folded, overlapping[0], 1000);
    QVERIFY(!touches.empty() && std::abs(-touches.front().distance - depth) < 1e-9);
  }

  // A row of balls of 5 mm every 5 mm along x against one of 8 mm beside it: each ball that it meets, by hand.
  void placesThatTouch() {
    const Vec3 beside(52.0, 10.0, 0.0), away(52.0, 20.0, 0.0);
    const ArmValues straight = ArmValues::Zero(1);
    RobotScene scene = sceneOf(planarArm({100.0}, 5.0));
    addBall(scene, beside, 8.0, 3);
    const auto touches = scene.touches(straight, scene.nearest(straight, 1e9), 100);
    const std::vector<double> deepestFirst{50.0, 55.0, 45.0, 60.0};
    QCOMPARE(touches.size(), deepestFirst.size());
    for (std::size_t i = 0; i < touches.size(); ++i) {
      const Vec3 ball(deepestFirst[i], 0.0, 0.0), direction = (ball - beside).normalized();
      QVERIFY(std::abs(touches[i].distance - ((ball - beside).norm() - 13.0)) < 1e-9);
      QVERIFY((touches[i].normal - direction).norm() < 1e-9);
      QVERIFY((touches[i].first - (ball - 5.0 * direction)).norm() < 1e-9);
      QVERIFY((touches[i].second - (beside + 8.0 * direction)).norm() < 1e-9);
    }
    QCOMPARE(scene.touches(straight, scene.nearest(straight, 1e9), 2).size(), std::size_t{2});
    // If nothing touches, the closest points are returned.
    RobotScene apart = sceneOf(planarArm({100.0}, 5.0));
    addBall(apart, away, 8.0, 3);
    const auto closest = apart.touches(straight, apart.nearest(straight, 1e9), 100);
    QCOMPARE(closest.size(), std::size_t{1});
    QVERIFY(std::abs(closest[0].distance - (std::hypot(2.0, 20.0) - 13.0)) < 1e-9);
    QVERIFY(apart.touches(straight, {0.0}, 100).empty());
  }

  // Around a ball in the corner: along one side and along the other, without the waypoints in between.
  void shortcutsLeaveOutWhatTheyCan() {
    RobotScene scene = sceneOf(slidingBall());
    QVERIFY(scene.isSound());
    // Returns the position of the ball on the slides at these values.
    const auto at = [&](double first, double second) {
      const SerialArm arm =
          armOf(std::vector<DhRow>{{.alpha = M_PI / 2, .isPrismatic = true}, {.alpha = M_PI / 2, .isPrismatic = true}});
      return arm.tipPose(two(first, second)).translation().eval();
    };
    addBall(scene, at(30.0, 16.0), 13.0, 7);
    JointPath path;
    for (int i = 0; i <= 6; ++i) path.push_back(two(10.0 * i, 0.0));
    for (int i = 1; i <= 3; ++i) path.push_back(two(60.0, 10.0 * i));
    const JointPath found = shortened(scene, path, {}, 0, 10.0, 1);
    QCOMPARE(found.size(), std::size_t{3});
    QVERIFY(found.front() == path.front() && found.back() == path.back());
    QVERIFY(leastAlong(scene, found, 0.1) > 0.0);
  }
};

HANDWHEEL_TEST(RobotSceneTest)
#include "RobotSceneTest.moc"
