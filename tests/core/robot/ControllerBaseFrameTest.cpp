// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/ControllerBaseFrame.h"

#include "Robots.h"
#include "TestClass.h"
#include "robot/dh/DhTable.h"

#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// The base of the controller in descriptions as people write them.
class ControllerBaseFrameTest : public QObject {
  Q_OBJECT

  static std::optional<Pose> baseIn(const std::string& inside) {
    const RobotModel robot = readOrThrow(robotOf(inside)).robot;
    return controllerBaseFrame(robot, wholeArm(robot));
  }
  static std::string turned(const std::string& type, const std::string& parent, const std::string& child,
                            const std::string& origin = "<origin xyz='0 0 0' rpy='0 0 3.141592653589793'/>") {
    return joint(parent + "-" + child, type, parent, child,
                 origin + (type == "fixed" ? "" : "<axis xyz='0 0 1'/>" + limit(-3, 3)));
  }
  static bool isAt(const std::optional<Pose>& pose, const Vec3& at, double turn) {
    const Pose wanted(Eigen::Translation3d(at) * Eigen::AngleAxisd(turn, Vec3::UnitZ()));
    return pose && (pose->matrix() - wanted.matrix()).cwiseAbs().maxCoeff() < 1e-9;
  }

 private slots:
  // The frames in the ROS descriptions of Universal Robots: half a turn against base_link, and a world below that.
  void beside() {
    const std::string arm = link("base_link") + link("base") + link("l1") + turned("fixed", "base_link", "base") +
                            turned("revolute", "base_link", "l1", "");
    QVERIFY(isAt(baseIn(arm), Vec3::Zero(), M_PI));
    const std::string raised = "<origin xyz='0 0 0.5'/>";
    QVERIFY(isAt(baseIn(link("world") + turned("fixed", "world", "base_link", raised) + arm), Vec3(0, 0, 500), M_PI));
    const std::string left = link("left_base_link") + link("left_base") + link("l1") +
                             turned("fixed", "left_base_link", "left_base") +
                             turned("revolute", "left_base_link", "l1", "");
    QVERIFY(isAt(baseIn(left), Vec3::Zero(), M_PI));
  }

  // The base itself, as tables have it, and robots that come with the program.
  void itself() {
    QVERIFY(isAt(baseIn(link("base") + link("l1") + turned("revolute", "base", "l1")), Vec3::Zero(), 0.0));
    RobotModel robot = handwheel::robotOf(*libraryTable("ur5"));
    QVERIFY(isAt(controllerBaseFrame(robot, wholeArm(robot)), Vec3::Zero(), 0.0));
    robot.links[robot.root].name = "foot";
    QVERIFY(isAt(controllerBaseFrame(robot, wholeArm(robot)), Vec3::Zero(), 0.0));
    robot.name = "another arm";
    QVERIFY(!controllerBaseFrame(robot, wholeArm(robot)));
  }

  // Each of several robots has its own.
  void severalRobots() {
    const RobotModel one =
        readOrThrow(robotOf(link("base_link") + link("l1") + link("base") + turned("fixed", "base_link", "base") +
                            turned("revolute", "base_link", "l1", "")))
            .robot;
    const Pose beside(Eigen::Translation3d(2000.0, 0.0, 0.0));
    const RobotModel both = joined(one, one, "other", beside);
    const RobotArm arm{"other", "r", linkNamed(both, "other_base_link"), linkNamed(both, "other_l1")};
    QVERIFY(isAt(controllerBaseFrame(both, arm), Vec3::Zero(), M_PI));
  }

  // A link with another name, or one that moves against the base, does not count.
  void unknown() {
    QVERIFY(!baseIn(link("base_link") + link("l1") + turned("revolute", "base_link", "l1")));
    QVERIFY(!baseIn(link("base_link") + link("table_base") + link("l1") + turned("fixed", "base_link", "table_base") +
                    turned("revolute", "base_link", "l1")));
    QVERIFY(!baseIn(link("base_link") + link("base") + turned("revolute", "base_link", "base")));
  }
};

HANDWHEEL_TEST(ControllerBaseFrameTest)
#include "ControllerBaseFrameTest.moc"
