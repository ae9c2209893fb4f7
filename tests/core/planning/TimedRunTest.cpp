// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/TimedRun.h"

#include "Scenes.h"
#include "TestClass.h"
#include "planning/PathTiming.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using Rates = Eigen::Array3d;

const Rates kVelocity(1.0, 2.0, 3.0);  // rad/s
constexpr double kToSpeed = 0.2, kToAcceleration = 0.05;

RobotScene limitedScene() {
  RobotModel robot = planarArm({500.0, 400.0, 300.0}, 30.0);
  for (std::size_t i = 0; i < 3; ++i)
    robot.joints[robot.dofs[i]].limits.velocity = kVelocity[static_cast<Eigen::Index>(i)];
  return sceneOf(robot);
}

PathTimingSettings settings() {
  PathTimingSettings all;
  all.timeToSpeed = kToSpeed;
  all.timeToRamp = kToAcceleration;
  return all;
}

struct PacedPath {
  JointPath joints;
  std::vector<MotionPace> paces;
};

// Joint motions and lines with random, round or repeated values, to and fro; some that stand still.
PacedPath anyPath(bool hasBlends) {
  PacedPath path;
  path.joints.emplace_back(ArmValues::Zero(3));
  const int motions = *rc::gen::inRange(1, 7);
  for (int i = 0; i < motions; ++i) {
    const int kind = *rc::gen::inRange(0, 4);
    const bool isLine = *rc::gen::arbitrary<bool>();
    const ArmValues from = path.joints.back();
    ArmValues to(3);
    for (double& value : to)
      value = kind == 0 ? evenly(-2.0, 2.0) : kind == 1 ? 0.5 * *rc::gen::inRange(-4, 5) : from[0];
    if (kind == 2 && path.joints.size() > 1) to = path.joints[path.joints.size() - 2];  // back again
    if (kind == 3) to[0] += evenly(-0.01, 0.01);
    const double blend = hasBlends && i + 1 < motions && *rc::gen::arbitrary<bool>() ? evenly(0.5, 40.0) : 0.0;
    const MotionPace pace{.speed = isLine ? 1.0 : evenly(0.05, 1.0),
                          .length = 700.0 * (to - from).norm(),
                          .toolSpeed = isLine ? evenly(10.0, 2000.0) : 0.0};
    // A line bends in joint space, as an arc does.
    const int points = isLine ? *rc::gen::inRange(1, 30) : 1;
    for (int k = 1; k <= points; ++k) {
      const double share = static_cast<double>(k) / points;
      ArmValues at = from + share * (to - from);
      at[2] += 0.3 * (to - from).norm() * std::sin(M_PI * share) * (points > 1 ? 1.0 : 0.0);
      path.joints.push_back(k == points ? to : at);
      path.paces.push_back(pace);
      path.paces.back().length /= points;
      path.paces.back().isContinued = k < points || blend > 0.0;
      path.paces.back().zone = k == points ? blend : 0.0;
    }
  }
  return path;
}

// The largest shares of velocity, acceleration and jerk that joints have, by differences. No difference of a motion
// within its limits exceeds these.
struct Reached {
  double velocity = 0.0, acceleration = 0.0, jerk = 0.0;
};

Reached reachedIn(const TimedPath& timed) {
  const Rates acceleration = kVelocity / kToSpeed, jerk = acceleration / kToAcceleration;
  const double step = std::max(2e-3, timed.duration() / 4000.0);
  Reached reached;
  Rates last[4];
  for (int i = 0; (i - 3) * step <= timed.duration(); ++i) {
    last[3] = last[2];
    last[2] = last[1];
    last[1] = last[0];
    last[0] = timed.valuesAt(i * step).array();
    if (i < 3) continue;
    const auto most = [](const Rates& difference, const Rates& allowed) {
      return (difference.abs() / allowed).maxCoeff();
    };
    reached.velocity = std::max(reached.velocity, most((last[0] - last[1]) / step, kVelocity));
    reached.acceleration =
        std::max(reached.acceleration, most((last[0] - 2.0 * last[1] + last[2]) / (step * step), acceleration));
    reached.jerk =
        std::max(reached.jerk, most((last[0] - 3.0 * last[1] + 3.0 * last[2] - last[3]) / std::pow(step, 3), jerk));
  }
  return reached;
}

constexpr double kRounding = 1e-3;

}  // namespace

// Tests the rates of timed paths by numerical differentiation.
class TimedRunTest : public QObject {
  Q_OBJECT

 private slots:
  void finePaths() {
    const RobotScene scene = limitedScene();
    QVERIFY(rc::check("velocity, acceleration and jerk", [&] {
      const PacedPath path = anyPath(false);
      const TimedPath timed(scene, path.joints, settings(), path.paces);
      const Reached reached = reachedIn(timed);
      RC_ASSERT(reached.velocity <= 1.0 + kRounding);
      RC_ASSERT(reached.acceleration <= 1.0 + kRounding);
      RC_ASSERT(reached.jerk <= 1.0 + kRounding);
      for (std::size_t i = 0; i + 1 < path.joints.size(); ++i)
        RC_ASSERT((timed.valuesAt(timed.beginOf(i)) - path.joints[i]).norm() < 1e-6);
    }));
  }

  void blendedPaths() {
    const RobotScene scene = limitedScene();
    QVERIFY(rc::check("velocity and acceleration", [&] {
      const PacedPath path = anyPath(true);
      const TimedPath timed(scene, path.joints, settings(), path.paces);
      const Reached reached = reachedIn(timed);
      RC_ASSERT(reached.velocity <= 1.0 + kRounding);
      RC_ASSERT(reached.acceleration <= 1.0 + kRounding);
      // The speed of each motion, which is left out of account where it begins and ends.
      double least = 0.0;
      for (std::size_t i = 0; i < path.paces.size(); ++i) {
        const MotionPace& pace = path.paces[i];
        const double joints = ((path.joints[i + 1] - path.joints[i]).array().abs() / kVelocity).maxCoeff();
        least += std::max(joints / pace.speed, pace.toolSpeed > 0.0 ? pace.length / pace.toolSpeed : 0.0);
      }
      RC_ASSERT(timed.duration() >= 0.999 * least);
    }));
  }

  // A straight motion in pieces that are blended is no faster than the whole, and hardly slower: corners that are none
  // cost nothing. Reversals cost time where their zones are passed in less than the change of the velocities takes.
  void straightOn() {
    const RobotScene scene = limitedScene();
    QVERIFY(rc::check("pieces of a motion", [&] {
      ArmValues end(3);
      for (double& value : end) value = evenly(-2.0, 2.0);
      const int pieces = *rc::gen::inRange(2, 6);
      const double length = 1000.0, speed = evenly(50.0, 500.0);
      const auto durationOf = [&](int count, bool isZigzag) {
        JointPath path{ArmValues::Zero(3)};
        std::vector<MotionPace> paces;
        for (int i = 1; i <= count; ++i) {
          path.emplace_back(isZigzag ? i % 2 * end / count : i * end / count);
          const bool isLast = i == count;
          paces.push_back({.length = length / count,
                           .toolSpeed = speed,
                           .isContinued = !isLast,
                           .zone = isLast ? 0.0 : 0.05 * length / count});
        }
        return TimedPath(scene, path, settings(), paces).duration();
      };
      const double whole = durationOf(1, false), blended = durationOf(pieces, false);
      RC_ASSERT(blended >= whole * (1.0 - 1e-6));
      RC_ASSERT(blended <= 1.02 * whole);
      const double reversed = durationOf(pieces, true);
      RC_ASSERT(reversed >= blended * (1.0 - 1e-9));
      const double takes = (2.0 * end.array().abs() * speed / length / (kVelocity / kToSpeed)).maxCoeff();
      const double passes = 2.0 * 0.05 * length / pieces / speed;
      if (takes > passes) RC_ASSERT(reversed > blended + 0.2 * (takes - passes));
    }));
  }
};

HANDWHEEL_TEST(TimedRunTest)
#include "TimedRunTest.moc"
