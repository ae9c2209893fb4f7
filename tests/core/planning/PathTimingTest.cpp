// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/PathTiming.h"

#include "Scenes.h"
#include "TestClass.h"

#include <rapidcheck.h>
#include <QTest>
#include <array>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// Tests paths in time: limits hold, and nothing is slower than necessary.
class PathTimingTest : public QObject {
  Q_OBJECT

 private slots:
  // With jerk 1 only: a quarter of the time for each phase, distance 2 · j · t³. With all limits reached: d/v + v/a +
  // a/j.
  void knownDurations() {
    QVERIFY(std::abs(RestToRest(2.0, 1e6, 1e6, 1.0).duration() - 4.0) < 1e-12);
    QVERIFY(std::abs(RestToRest(100.0, 2.0, 1.0, 0.5).duration() - (50.0 + 2.0 + 2.0)) < 1e-12);
    QCOMPARE(RestToRest(0.0, 1.0, 1.0, 1.0).duration(), 0.0);
    // The acceleration is reached, the velocity is not: ramps of 3 s, of which 1 s at each end with jerk; 1 · 2 · 3.
    QVERIFY(std::abs(RestToRest(6.0, 1e6, 1.0, 1.0).duration() - 6.0) < 1e-12);
    // The velocity is reached, the acceleration is not: ramps of 2 s over 1 each, and 3 s in between.
    QVERIFY(std::abs(RestToRest(5.0, 1.0, 1e6, 1.0).duration() - 7.0) < 1e-12);
  }

  // A time-optimal motion reaches a limit at every moment: that of the jerk, of the acceleration, or of the velocity.
  void aLimitIsAlwaysReached() {
    QVERIFY(rc::check("limits", [] {
      const double d = evenly(0.01, 10.0), v = evenly(0.1, 5.0), a = evenly(0.1, 20.0), j = evenly(0.5, 200.0);
      const RestToRest motion(d, v, a, j);
      constexpr int kSteps = 1000;
      const double step = motion.duration() / kSteps;
      const double rounding = 1e-13 * (1.0 + d);  // rounding of positions
      int idle = 0;
      for (int i = 2; i < kSteps - 1; ++i) {
        const double before = motion.at((i - 1) * step), at = motion.at(i * step), after = motion.at((i + 1) * step);
        const double next = motion.at((i + 2) * step);
        const bool isFast = (after - at) / step >= v * 0.999;
        const bool isHard = std::abs(after - 2.0 * at + before) / (step * step) >= a * 0.999;
        const double jerk = std::abs(next - 3.0 * after + 3.0 * at - before);
        const bool isBrisk = jerk >= 0.999 * j * step * step * step - 8.0 * rounding;
        idle += isFast || isHard || isBrisk ? 0 : 1;
      }
      RC_ASSERT(idle <= 7 * 3);  // the differences reach over the seven changes of phase
    }));
  }

  // In a path no joint exceeds its own velocity, nor the acceleration and the jerk that follow from it, and one of them
  // reaches its velocity in each long motion.
  void jointsKeepTheirLimits() {
    RobotModel robot = planarArm({500.0, 500.0}, 30.0);
    const double most[] = {0.5, 0.0};  // rad/s; 0: not known
    for (std::size_t i = 0; i < 2; ++i) robot.joints[robot.dofs[i]].limits.velocity = most[i];
    const RobotScene scene = sceneOf(robot);
    PathTimingSettings settings;
    settings.turning = 2.0;
    JointPath path(3, ArmValues::Zero(2));
    path[1] << 1.0, 0.5;
    path[2] << 1.1, -2.5;
    const TimedPath timed(scene, path, settings);
    const double step = 1e-3;
    std::array<ArmValues, 2> fastest{ArmValues::Zero(2), ArmValues::Zero(2)};
    const Eigen::Array2d velocity(0.5, 2.0), acceleration = velocity / 0.25, jerk = acceleration / 0.1;
    for (double t = 2.0 * step; t < timed.duration(); t += step) {
      const auto valuesAgo = [&](int back) -> Eigen::Array2d { return timed.valuesAt(t - back * step).array(); };
      const Eigen::Array2d v = ((valuesAgo(0) - valuesAgo(1)) / step).abs();
      const Eigen::Array2d a = ((valuesAgo(0) - 2.0 * valuesAgo(1) + valuesAgo(2)) / (step * step)).abs();
      QVERIFY((v <= velocity * (1.0 + 1e-9)).all());
      QVERIFY((a <= acceleration * (1.0 + 1e-6)).all());
      if (t > 3.0 * step) {
        const Eigen::Array2d j =
            ((valuesAgo(0) - 3.0 * valuesAgo(1) + 3.0 * valuesAgo(2) - valuesAgo(3)) / (step * step * step)).abs();
        QVERIFY((j <= jerk * (1.0 + 1e-3)).all());
      }
      ArmValues& seen = fastest[timed.motionAt(t)];
      seen = seen.cwiseMax(v.matrix());
    }
    QVERIFY(std::abs(fastest[0][0] - 0.5) < 1e-6);
    QVERIFY(std::abs(fastest[1][1] - 2.0) < 1e-6);
    // d/v + v/a + a/j, twice.
    QVERIFY(std::abs(timed.duration() - (1.0 / 0.5 + 0.35 + 3.0 / 2.0 + 0.35)) < 1e-9);
  }

  // By differences: velocity, acceleration and jerk stay within their limits, and the distance is covered.
  void limitsHold() {
    QVERIFY(rc::check("limits", [] {
      const double d = evenly(0.01, 10.0), v = evenly(0.1, 5.0), a = evenly(0.1, 20.0), j = evenly(0.5, 200.0);
      const RestToRest motion(d, v, a, j);
      const double step = motion.duration() / 2000.0;
      RC_ASSERT(std::abs(motion.at(motion.duration()) - d) < 1e-12);
      RC_ASSERT(std::abs(motion.at(0.5 * motion.duration()) - 0.5 * d) < 1e-9 * (1.0 + d));
      double lastVelocity = 0.0, lastAcceleration = 0.0;
      for (int i = 1; i <= 2000; ++i) {
        const double velocity = (motion.at(i * step) - motion.at((i - 1) * step)) / step;
        const double acceleration = i > 1 ? (velocity - lastVelocity) / step : 0.0;
        RC_ASSERT(velocity >= -1e-9 && velocity <= v * (1.0 + 1e-6));
        RC_ASSERT(std::abs(acceleration) <= a * (1.0 + 1e-3) + 1e-6);
        if (i > 2)
          RC_ASSERT(std::abs(acceleration - lastAcceleration) / step <= j * 1.01 + 1e-9 / (step * step * step));
        lastVelocity = velocity;
        lastAcceleration = acceleration;
      }
    }));
  }

  void aPathStopsAtItsWaypoints() {
    const RobotModel robot = planarArm({500.0, 500.0}, 30.0);
    const RobotScene scene = sceneOf(robot);
    JointPath path(3, ArmValues::Zero(2));
    path[1] << 1.0, 0.5;
    path[2] << 1.0, -0.5;
    const TimedPath timed(scene, path, {});
    for (std::size_t i = 0; i < path.size(); ++i) QVERIFY(timed.valuesAt(timed.beginOf(i)) == path[i]);
    QCOMPARE(timed.motionAt(-1.0), std::size_t{0});
    QCOMPARE(timed.motionAt(1e9), std::size_t{1});
    QVERIFY(timed.valuesAt(1e9) == path[2]);
    // Half the speed takes longer; a path of one waypoint, and one that does not move, take no time.
    const MotionPace half[] = {{.speed = 0.5}, {.speed = 0.5}};
    QVERIFY(TimedPath(scene, path, {}, half).duration() > timed.duration());
    QCOMPARE(TimedPath(scene, {path[0]}, {}).duration(), 0.0);
    QCOMPARE(TimedPath(scene, {path[0], path[0]}, {}).duration(), 0.0);
  }

  // Differences of the timed path: with zones every joint keeps velocity and acceleration in corners, too, and a
  // reversal costs time. At corners the path stays within the zone.
  void cornersKeepLimits() {
    RobotModel robot = planarArm({500.0, 500.0}, 30.0);
    for (std::size_t i = 0; i < 2; ++i) robot.joints[robot.dofs[i]].limits.velocity = 2.0;
    const RobotScene scene = sceneOf(robot);
    const Eigen::Array2d velocity(2.0, 2.0), acceleration = velocity / 0.25;
    const auto go = [](std::initializer_list<std::array<double, 2>> points) {
      JointPath path;
      for (const auto& [a, b] : points) {
        path.emplace_back(2);
        path.back() << a, b;
      }
      return path;
    };
    const JointPath straight = go({{0, 0}, {0.4, 0}, {0.8, 0}, {1.2, 0}}),
                    zigzag = go({{0, 0}, {0.4, 0}, {0, 0}, {0.4, 0}}),
                    around = go({{0, 0}, {0.4, 0}, {0.4, 0.5}, {0.1, 0.9}});
    const auto timedOf = [&](const JointPath& path) {
      std::vector<MotionPace> paces(3, {.length = 400.0, .toolSpeed = 300.0, .isContinued = true, .zone = 20.0});
      return TimedPath(scene, path, {}, paces);
    };
    for (const JointPath& path : {straight, zigzag, around}) {
      const TimedPath timed = timedOf(path);
      const double step = 1e-3;
      for (double t = 0.0; t <= timed.duration() + 3.0 * step; t += step) {
        const auto valuesAgo = [&](int back) -> Eigen::Array2d { return timed.valuesAt(t - back * step).array(); };
        QVERIFY((((valuesAgo(0) - valuesAgo(1)) / step).abs() <= velocity * (1.0 + 1e-9)).all());
        const Eigen::Array2d a = ((valuesAgo(0) - 2.0 * valuesAgo(1) + valuesAgo(2)) / (step * step)).abs();
        QVERIFY2((a <= acceleration * (1.0 + 1e-3)).all(), qPrintable(QString::number(a.maxCoeff())));
      }
      QVERIFY(timed.valuesAt(0.0) == path.front() && timed.valuesAt(timed.duration()) == path.back());
      // 20 of 400 mm: the path leaves the corner by a share of 0.05 at most.
      for (std::size_t i = 1; i < 3; ++i) {
        double nearest = 1.0;
        for (double t = 0.0; t < timed.duration(); t += step)
          nearest = std::min(nearest, (timed.valuesAt(t) - path[i]).norm());
        QVERIFY(nearest <= 0.05 * 0.5 + 1e-9);
      }
    }
    // By hand: 300 mm/s are 0.3 rad/s, and 40 mm of zone at each corner are passed in 0.133 s, or 0.133 s / x at a
    // share x of the speed. A reversal by 0.6 x rad/s with a jerk of 80 rad/s^3 takes 2 sqrt(0.6 x / 80): x is 0.84 at
    // most, and each costs 0.025 s.
    QVERIFY(timedOf(zigzag).duration() > timedOf(straight).duration() + 0.05);
    // With stops it takes longer than with zones.
    const std::vector<MotionPace> stops(3, {.length = 400.0, .toolSpeed = 300.0});
    QVERIFY(TimedPath(scene, around, {}, stops).duration() > timedOf(around).duration());
  }

  // A curved line of the tool between stops, by its points: velocity, acceleration and jerk.
  void curvesKeepJerk() {
    RobotModel robot = planarArm({500.0, 500.0}, 30.0);
    for (std::size_t i = 0; i < 2; ++i) robot.joints[robot.dofs[i]].limits.velocity = 1.0;
    const RobotScene scene = sceneOf(robot);
    JointPath path;
    for (int i = 0; i <= 40; ++i) {
      path.emplace_back(2);
      path.back() << 0.02 * i, 0.3 * std::sin(0.1 * i);
    }
    const std::vector<MotionPace> paces(40, {.length = 10.0, .toolSpeed = 1000.0, .isContinued = true});
    const TimedPath timed(scene, path, {}, paces);
    const double step = 2e-3, velocity = 1.0, acceleration = velocity / 0.25, jerk = acceleration / 0.1;
    for (double t = 0.0; t <= timed.duration(); t += step) {
      const auto valuesAgo = [&](int back) -> Eigen::Array2d { return timed.valuesAt(t - back * step).array(); };
      QVERIFY((((valuesAgo(0) - valuesAgo(1)) / step).abs() <= velocity * (1.0 + 1e-9)).all());
      const Eigen::Array2d a = (valuesAgo(0) - 2.0 * valuesAgo(1) + valuesAgo(2)).abs() / (step * step);
      QVERIFY((a <= acceleration * (1.0 + 1e-6)).all());
      const Eigen::Array2d j =
          (valuesAgo(0) - 3.0 * valuesAgo(1) + 3.0 * valuesAgo(2) - valuesAgo(3)).abs() / (step * step * step);
      QVERIFY2((j <= jerk * (1.0 + 1e-3)).all(), qPrintable(QString::number(j.maxCoeff())));
    }
  }

  // A line of the tool in three motions: its own speed, by the profile of the whole, and that of the joints if they are
  // the limit.
  void aLineHasItsSpeed() {
    const RobotModel robot = planarArm({500.0, 500.0}, 30.0);
    const RobotScene scene = sceneOf(robot);
    JointPath path(4, ArmValues::Zero(2));
    for (int i = 1; i < 4; ++i) path[static_cast<std::size_t>(i)][0] = 0.1 * i;
    for (const double speed : {10.0, 50.0}) {
      const std::vector<MotionPace> paces(3, {.length = 100.0, .toolSpeed = speed, .isContinued = true});
      const TimedPath timed(scene, path, {}, paces);
      const double cruise = 300.0 / speed;
      QVERIFY(timed.duration() > cruise && timed.duration() < cruise + 1.0);
      for (std::size_t i = 0; i < 4; ++i) QVERIFY((timed.valuesAt(timed.beginOf(i)) - path[i]).norm() < 1e-6);
      // In its middle the tool has the requested speed: 0.1 rad of the joint to 100 mm.
      const double middle = 0.5 * timed.duration(), step = 1e-3;
      const double joint = timed.valuesAt(middle + step)[0] - timed.valuesAt(middle - step)[0];
      QVERIFY(std::abs(joint / (2.0 * step) * 1000.0 - speed) < 1e-3 * speed);
    }
    const std::vector<MotionPace> fast(3, {.length = 100.0, .toolSpeed = 1e9, .isContinued = true});
    const TimedPath limited(scene, path, {}, fast);
    double fastest = 0.0;
    for (double t = 0.0; t < limited.duration(); t += 1e-3)
      fastest = std::max(fastest, std::abs(limited.valuesAt(t + 1e-3)[0] - limited.valuesAt(t)[0]) / 1e-3);
    const double allowed = scene.joint(0).velocity.value_or(0.0) > 0.0 ? *scene.joint(0).velocity : M_PI;
    QVERIFY(fastest <= allowed * 1.001);
    // With stops it takes longer.
    std::vector<MotionPace> stops(3, {.length = 100.0, .toolSpeed = 50.0});
    const std::vector<MotionPace> on(3, {.length = 100.0, .toolSpeed = 50.0, .isContinued = true});
    QVERIFY(TimedPath(scene, path, {}, stops).duration() > TimedPath(scene, path, {}, on).duration() + 0.01);
  }
};

HANDWHEEL_TEST(PathTimingTest)
#include "PathTimingTest.moc"
