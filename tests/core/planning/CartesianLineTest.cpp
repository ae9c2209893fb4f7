// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/CartesianLine.h"

#include "TestClass.h"
#include "robot/arm/ClosedFormIk.h"
#include "robot/arm/NumericalIk.h"
#include "robot/dh/DhTable.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

SerialArm irb120() {
  const DhTable& table = *libraryTable("irb120");
  return armOf(std::vector<DhRow>(table.joints.begin(), table.joints.end()));
}

// Returns the joint values for a pose next to others.
ArmValues reached(const SerialArm& arm, const Pose& tip, const ArmValues& near) {
  return solvedNumerically(arm, tip, near, {.tolerance = 1e-10, .seconds = 1.0}).values;
}

}  // namespace

// Straight lines of the tool.
class CartesianLineTest : public QObject {
  Q_OBJECT

 private slots:
  // The tool is on the line everywhere between two waypoints, also half way.
  void staysOnTheLine() {
    const SerialArm arm = irb120();
    ArmValues from(6);
    from << 0.2, 0.3, 0.1, 0.1, 0.6, 0.0;
    const Pose tool(Eigen::Translation3d(0.0, 0.0, 80.0));
    Pose goal = arm.tipPose(from);
    goal.translation() += Vec3(20.0, -150.0, 60.0);
    const ArmValues to = reached(arm, goal, from);
    const LineSettings settings;
    const FollowedLine line = followLine(arm, tool, from, to, settings);
    QCOMPARE(line.reached, 1.0);
    QVERIFY(line.path.front() == from && line.path.back() == to);
    const Vec3 a = (arm.tipPose(from) * tool).translation(), b = (arm.tipPose(to) * tool).translation();
    for (std::size_t i = 1; i < line.path.size(); ++i) {
      QVERIFY((line.path[i] - line.path[i - 1]).cwiseAbs().maxCoeff() <= settings.largestStep);
      for (const double share : {0.25, 0.5, 0.75, 1.0}) {
        const ArmValues at = line.path[i - 1] + share * (line.path[i] - line.path[i - 1]);
        const Vec3 off = (arm.tipPose(at) * tool).translation() - a;
        QVERIFY(off.cross((b - a).normalized()).norm() <= settings.deviation);
      }
    }
  }

  // The same pose with the wrist turned over is not reached along a line without a leap.
  void anotherConfigurationIsNotReached() {
    const SerialArm arm = irb120();
    ArmValues from(6);
    from << 0.2, 0.3, 0.1, 0.4, 0.6, 0.2;
    ArmValues flipped = from;
    flipped[3] += from[3] > 0 ? -M_PI : M_PI;
    flipped[4] = -from[4];
    flipped[5] += M_PI;
    QVERIFY(poseError(arm.tipPose(from), arm.tipPose(flipped)).norm() < 1e-9);
    QVERIFY(followLine(arm, Pose::Identity(), from, flipped).reached < 1.0);
  }

  void outOfReach() {
    const SerialArm arm = irb120();
    // Both ends can be reached, the middle of the line goes through the arm's own axis.
    ArmValues from = ArmValues::Zero(6), to = ArmValues::Zero(6);
    from[4] = to[4] = 0.5;
    from[0] = -1.5;
    to[0] = 1.6;
    const FollowedLine line = followLine(arm, Pose::Identity(), from, to);
    QVERIFY(line.reached < 1.0);
    QVERIFY(line.path.front() == from);
  }

  void noPathAtAll() {
    const SerialArm arm = irb120();
    const ArmValues at = ArmValues::Constant(6, 0.3);
    const FollowedLine line = followLine(arm, Pose::Identity(), at, at);
    QCOMPARE(line.reached, 1.0);
    QVERIFY(line.path.back() == at);
  }
};

HANDWHEEL_TEST(CartesianLineTest)
#include "CartesianLineTest.moc"
