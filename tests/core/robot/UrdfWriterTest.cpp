// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/UrdfWriter.h"

#include "Robots.h"
#include "TestClass.h"
#include "robot/Kinematics.h"
#include "robot/dh/DhTable.h"

#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

double farthest(const RobotModel& a, const RobotModel& b, const JointValues& values) {
  const auto first = linkPoses(a, values), second = linkPoses(b, values);
  double most = 0.0;
  for (std::size_t l = 0; l < first.size(); ++l)
    most = std::max(most, (first[l].matrix() - second[l].matrix()).cwiseAbs().maxCoeff());
  return most;
}

JointValues someValues(const RobotModel& robot) {
  JointValues values(Eigen::Index(robot.dofs.size()));
  for (double& value : values) value = anyNumber(-3.0, 3.0);
  return values;
}

}  // namespace

// Tests that a written robot is read as the same robot.
class UrdfWriterTest : public QObject {
  Q_OBJECT

 private slots:
  void theLibrary() {
    for (const LibraryRobot& each : robotLibrary()) {
      const RobotModel robot = handwheel::robotOf(*libraryTable(each.id));
      const ImportedRobot again = readOrThrow(urdfOf(robot));
      QVERIFY2(again.damage.empty(), each.id);
      QCOMPARE(again.robot.links.size(), robot.links.size());
      for (std::size_t l = 0; l < robot.links.size(); ++l) {
        QCOMPARE(again.robot.links[l].visuals.size(), robot.links[l].visuals.size());
        QCOMPARE(again.robot.links[l].collisions.size(), robot.links[l].collisions.size());
      }
      for (std::size_t dof = 0; dof < robot.dofs.size(); ++dof) {
        const Joint &a = robot.jointOfDof(dof), &b = again.robot.jointOfDof(dof);
        QCOMPARE(b.name, a.name);
        QCOMPARE(b.kind, a.kind);
        QCOMPARE(b.limits.lower, a.limits.lower);
        QCOMPARE(b.limits.upper, a.limits.upper);
        QCOMPARE(b.limits.velocity.has_value(), a.limits.velocity.has_value());
      }
      QVERIFY(rc::check(each.id, [&] { RC_ASSERT(farthest(robot, again.robot, someValues(robot)) < 1e-9); }));
    }
  }

  // Two axes of the rotation in line (pitch ±90°), a name with XML characters, a joint that follows another.
  void extremes() {
    const std::string inside = "<axis xyz='0 0 1'/>" + limit(-2, 2);
    std::string urdf = link("a&amp;b") + link("c") + link("d") +
                       joint("first", "revolute", "a&amp;b", "c",
                             "<origin xyz='0.1 0.2 0.3' rpy='0.7 1.5707963267948966 0.2'/>" + inside) +
                       joint("second", "revolute", "c", "d",
                             "<origin rpy='0 -1.5707963267948966 3'/>" + inside +
                                 "<mimic joint='first' multiplier='-0.5' offset='0.25'/>");
    const ImportedRobot robot = readOrThrow(test::robotOf(urdf));
    const ImportedRobot again = readOrThrow(urdfOf(robot.robot));
    QCOMPARE(again.robot.links[0].name, std::string("a&b"));
    QVERIFY(rc::check("the same places",
                      [&] { RC_ASSERT(farthest(robot.robot, again.robot, someValues(robot.robot)) < 1e-9); }));
  }

  // Joints that follow others of any kind, also those that stand; slides count in metres there.
  void anyTree() {
    QVERIFY(rc::check("the same places", [] {
      const RobotModel robot = readOrThrow(anyRobot()).robot;
      const RobotModel again = readOrThrow(urdfOf(robot)).robot;
      RC_ASSERT(again.dofs.size() == robot.dofs.size());
      RC_ASSERT(farthest(robot, again, someValues(robot)) < 1e-6);
    }));
  }
};

HANDWHEEL_TEST(UrdfWriterTest)
#include "UrdfWriterTest.moc"
