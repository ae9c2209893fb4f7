// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/ToolTrack.h"

#include "Scenes.h"
#include "TestClass.h"
#include "robot/ShapeSurfaces.h"
#include "robot/arm/ClosedFormIk.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace handwheel;
using namespace handwheel::test;

namespace {

SerialArm armCalled(const char* name) {
  const DhTable& table = *libraryTable(name);
  return armOf(std::vector<DhRow>(table.joints.begin(), table.joints.end()));
}

RobotScene sceneCalled(const char* name) {
  RobotScene scene = sceneOf(robotOf(*libraryTable(name)));
  scene.allowPairs(scene.alwaysMeeting());
  scene.allowPairs(scene.closePairsMeeting(ArmValues::Zero(6)));
  return scene;
}

// Poses that look down along a straight line in y.
std::vector<Pose> lineOfPoses(const Vec3& begin, double length, int count) {
  SurfaceTrack track;
  for (int i = 0; i < count; ++i)
    track.points.push_back({begin + Vec3(0.0, length * i / (count - 1), 0.0), Vec3::UnitY(), Vec3::UnitZ()});
  return toolPoses(track, {});
}

double angleOf(const Pose& a, const Pose& b) {
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
}

}  // namespace

// Tools along curves.
class ToolTrackTest : public QObject {
  Q_OBJECT

 private slots:
  // The tool points to the part; leads ahead, leans to the right, stays away: from the definition of each angle.
  void attitudes() {
    SurfaceTrack track;
    track.points = {{{1.0, 2.0, 3.0}, Vec3::UnitX(), Vec3::UnitZ()}};
    const auto pose = [&](const ToolAttitude& attitude) { return toolPoses(track, attitude).front(); };
    QVERIFY((pose({}).linear().col(2) + Vec3::UnitZ()).norm() < 1e-12);
    QVERIFY((pose({}).linear().col(0) - Vec3::UnitX()).norm() < 1e-12);
    QVERIFY(std::abs(pose({}).linear().determinant() - 1.0) < 1e-12);
    // With a lead of 30° the tool points ahead: its axis has sin 30° along the curve.
    QVERIFY((pose({.lead = std::numbers::pi / 6.0}).linear().col(2) - Vec3(0.5, 0.0, -std::sqrt(0.75))).norm() < 1e-12);
    // Along x, standing on the surface, the right side is -y: the body of the tool is there.
    QVERIFY((pose({.tilt = std::numbers::pi / 6.0}).linear().col(2) - Vec3(0.0, 0.5, -std::sqrt(0.75))).norm() < 1e-12);
    QVERIFY((pose({.spin = 0.7}).linear().col(2) + Vec3::UnitZ()).norm() < 1e-12);
    QVERIFY(std::abs((pose({.lead = 0.3, .standoff = 10.0}).translation() - Vec3(1.0, 2.0, 3.0)).norm() - 10.0) < 1e-9);
    QVERIFY(pose({.standoff = 10.0}).translation().isApprox(Vec3(1.0, 2.0, 13.0)));
  }

  // Every pose is reached exactly, neighbours without a leap, in closed form and by iteration.
  void everyPoseIsReached() {
    for (const char* name : {"irb120", "ur5"}) {
      const SerialArm arm = armCalled(name);
      const RobotScene scene = sceneCalled(name);
      const Pose tool(Eigen::Translation3d(0.0, 0.0, 50.0));
      const std::vector<Pose> poses = lineOfPoses({350.0, -150.0, 200.0}, 300.0, 7);
      const FollowedTrack track = followTrack(scene, arm, tool, poses, arm.middle(), {});
      QVERIFY(track.outcome == FollowedTrack::Outcome::Solved);
      QCOMPARE(track.values.size(), poses.size());
      for (std::size_t i = 0; i < poses.size(); ++i) {
        QVERIFY(arm.isWithinLimits(track.values[i]));
        const Pose there = arm.tipPose(track.values[i]) * tool;
        QVERIFY((there.translation() - poses[i].translation()).norm() < 1e-6 && angleOf(there, poses[i]) < 1e-6);
        if (i == 0) continue;
        QVERIFY(checkLine(scene, arm, tool, track.values[i - 1], track.values[i], {}, {}).isFree());
      }
    }
  }

  // The path is the shortest one through the ladder, compared with all combinations.
  void shortestPath() {
    const SerialArm arm = armCalled("irb120");
    const RobotScene scene = sceneCalled("irb120");
    const std::vector<Pose> poses = lineOfPoses({350.0, -50.0, 250.0}, 100.0, 3);
    ArmValues near(6);
    near << 0.1, 0.2, 0.1, 0.0, 0.5, 0.0;
    const FollowedTrack track = followTrack(scene, arm, Pose::Identity(), poses, near, {});
    QVERIFY(track.outcome == FollowedTrack::Outcome::Solved);
    const auto costOf = [&](const std::vector<ArmValues>& values) {
      double cost = (values[0] - near).cwiseAbs().maxCoeff();
      for (std::size_t i = 1; i < values.size(); ++i) cost += (values[i] - values[i - 1]).cwiseAbs().maxCoeff();
      return cost;
    };
    const auto ik = ClosedFormIk::of(arm);
    std::vector<std::vector<ArmValues>> all(3);
    for (std::size_t i = 0; i < 3; ++i) {
      IkSolutions solutions;
      ik->solve(poses[i], near, solutions);
      for (const auto& each : solutions) {
        if (const auto within = withinLimits(arm, each.values, near)) all[i].push_back(*within);
      }
    }
    double least = 1e9;
    for (const ArmValues& a : all[0]) {
      for (const ArmValues& b : all[1]) {
        for (const ArmValues& c : all[2]) {
          const bool isFree = checkLine(scene, arm, Pose::Identity(), a, b, {}, {}).isFree() &&
                              checkLine(scene, arm, Pose::Identity(), b, c, {}, {}).isFree();
          if (isFree) least = std::min(least, costOf({a, b, c}));
        }
      }
    }
    QVERIFY(std::abs(costOf(track.values) - least) < 1e-6);
  }

  // A ball on the path of the straight elbow: another path is taken, and it is free by a check of its own.
  void pathsAroundObstacles() {
    const SerialArm arm = armCalled("irb120");
    RobotScene scene = sceneCalled("irb120");
    const std::vector<Pose> poses = lineOfPoses({350.0, -100.0, 250.0}, 200.0, 5);
    const FollowedTrack free = followTrack(scene, arm, Pose::Identity(), poses, arm.middle(), {});
    QVERIFY(free.outcome == FollowedTrack::Outcome::Solved);
    std::array<Pose, 6> frames;
    arm.jointPoses(free.values[2], frames);
    addBall(scene, frames[3].translation() + Vec3(0.0, 0.0, 60.0), 30.0, 1);
    const FollowedTrack other = followTrack(scene, arm, Pose::Identity(), poses, arm.middle(), {.spins = 12});
    if (other.outcome == FollowedTrack::Outcome::Solved) {
      QVERIFY(leastAlong(scene, other.values, 0.01) > 0.0);
    } else {
      QVERIFY(other.outcome == FollowedTrack::Outcome::Blocked);
      QCOMPARE(other.blocked.owner, 1u);
    }
  }

  // An obstacle to every configuration is named, with the point at which it blocks.
  void whatBlocksIsNamed() {
    const SerialArm arm = armCalled("irb120");
    RobotScene scene = sceneCalled("irb120");
    const std::vector<Pose> poses = lineOfPoses({350.0, -100.0, 250.0}, 200.0, 5);
    addBall(scene, poses[3].translation(), 20.0, 7);
    const FollowedTrack track = followTrack(scene, arm, Pose::Identity(), poses, arm.middle(), {});
    QVERIFY(track.outcome == FollowedTrack::Outcome::Blocked);
    QVERIFY(track.failedAt >= 1 && track.failedAt <= 3);  // the wrist is wide
    QCOMPARE(track.blocked.owner, 7u);
    const std::vector<Pose> far = lineOfPoses({350.0, -100.0, 2000.0}, 200.0, 5);
    QVERIFY(followTrack(scene, arm, Pose::Identity(), far, arm.middle(), {}).outcome ==
            FollowedTrack::Outcome::OutOfReach);
    QVERIFY(followTrack(scene, arm, Pose::Identity(), {}, arm.middle(), {}).values.empty());
  }

  // A tool that is round reaches with its own turn free what it cannot with it fixed.
  void freeTurns() {
    const SerialArm arm = armCalled("irb120");
    const RobotScene scene = sceneCalled("irb120");
    int fixed = 0, free = 0;
    for (double spin = -3.0; spin < 3.1; spin += 0.5) {
      SurfaceTrack track;
      for (int i = 0; i < 4; ++i)
        track.points.push_back({Vec3(350.0, -150.0 + 100.0 * i, 250.0), Vec3::UnitY(), Vec3::UnitZ()});
      const std::vector<Pose> poses = toolPoses(track, {.spin = spin});
      const auto isSolved = [&](int spins) {
        return followTrack(scene, arm, Pose::Identity(), poses, arm.middle(), {.spins = spins}).outcome ==
               FollowedTrack::Outcome::Solved;
      };
      fixed += isSolved(1) ? 1 : 0;
      free += isSolved(24) ? 1 : 0;
    }
    QCOMPARE(free, 13);
    QVERIFY(fixed <= free);
  }

  void cancelled() {
    const SerialArm arm = armCalled("irb120");
    JobState state;
    state.cancelled = true;
    const FollowedTrack track =
        followTrack(sceneCalled("irb120"), arm, Pose::Identity(), lineOfPoses({350.0, -100.0, 250.0}, 200.0, 5),
                    arm.middle(), {}, Progress(state));
    QVERIFY(track.outcome == FollowedTrack::Outcome::Cancelled);
  }
};

HANDWHEEL_TEST(ToolTrackTest)
#include "ToolTrackTest.moc"
