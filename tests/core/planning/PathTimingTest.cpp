// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/PathTiming.h"

#include "Scenes.h"
#include "TestClass.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// Paths in time: limits hold, and nothing is slower than it must be.
class PathTimingTest : public QObject {
  Q_OBJECT

 private slots:
  // With jerk 1 only: a quarter of the time each way, distance 2 · j · t³. With all limits reached: d/v + v/a + a/j.
  void knownDurations() {
    QVERIFY(std::abs(RestToRest(2.0, 1e6, 1e6, 1.0).duration() - 4.0) < 1e-12);
    QVERIFY(std::abs(RestToRest(100.0, 2.0, 1.0, 0.5).duration() - (50.0 + 2.0 + 2.0)) < 1e-12);
    QCOMPARE(RestToRest(0.0, 1.0, 1.0, 1.0).duration(), 0.0);
  }

  // By differences: velocity, acceleration and jerk stay within their limits, and the way is done.
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

  void aPathStopsAtItsPlaces() {
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
    // Half as fast takes longer; a path of one place, and one that does not move, take no time.
    const double half[] = {0.5, 0.5};
    QVERIFY(TimedPath(scene, path, {}, half).duration() > timed.duration());
    QCOMPARE(TimedPath(scene, {path[0]}, {}).duration(), 0.0);
    QCOMPARE(TimedPath(scene, {path[0], path[0]}, {}).duration(), 0.0);
  }
};

HANDWHEEL_TEST(PathTimingTest)
#include "PathTimingTest.moc"
