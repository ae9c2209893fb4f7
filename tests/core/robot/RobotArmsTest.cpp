// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/RobotArms.h"

#include "Robots.h"
#include "TestClass.h"
#include "robot/Kinematics.h"
#include "robot/UrdfWriter.h"
#include "robot/dh/DhTable.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

Pose anyBase() {
  const auto three = [](double size) {
    return Vec3(anyNumber(-size, size), anyNumber(-size, size), anyNumber(-size, size));
  };
  const Vec3 position = three(2000.0), turn = three(3.0);
  return Eigen::Translation3d(position) * Eigen::AngleAxisd(turn.z(), Vec3::UnitZ()) *
         Eigen::AngleAxisd(turn.y(), Vec3::UnitY()) * Eigen::AngleAxisd(turn.x(), Vec3::UnitX());
}

// Two robots in one model, the second under "b".
struct Pair {
  RobotModel first = readOrThrow(anyRobot()).robot, second = readOrThrow(anyRobot()).robot;
  Pose base = anyBase();
  RobotModel model = joined(first, second, "b", base);
  std::vector<RobotArm> arms = {{"a", "r", first.root, toolLink(first)},
                                {"b", "r", linkNamed(model, "b_" + second.links[second.root].name),
                                 linkNamed(model, "b_" + second.links[toolLink(second)].name)}};
};

JointValues together(const JointValues& first, const JointValues& second) {
  JointValues both(first.size() + second.size());
  both << first, second;
  return both;
}

double farthest(const Pose& a, const Pose& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

// Compares the poses of the links of `robot` with those of the same names in `other`, in the frame of the other's base.
bool areTheSame(const RobotModel& robot, const JointValues& values, const RobotModel& other, const JointValues& others,
                const Pose& frame = Pose::Identity(), const std::string& prefix = {}) {
  const auto poses = linkPoses(robot, values), theirs = linkPoses(other, others);
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const std::uint32_t there = linkNamed(other, prefix + robot.links[l].name);
    if (there == kNone || farthest(frame * poses[l], theirs[there]) > 1e-6) return false;
  }
  return true;
}

}  // namespace

// Several robots in one model move as each would alone, from its own base on.
class RobotArmsTest : public QObject {
  Q_OBJECT

 private slots:
  void eachMovesAsAlone() {
    QVERIFY(rc::check("poses of both", [] {
      const Pair pair;
      const JointValues a = anyValues(pair.first), b = anyValues(pair.second);
      const JointValues both = together(a, b);
      RC_ASSERT(std::size_t(both.size()) == pair.model.dofs.size());
      RC_ASSERT(areTheSame(pair.first, a, pair.model, both));
      RC_ASSERT(areTheSame(pair.second, b, pair.model, both, pair.base, "b_"));
      RC_ASSERT(farthest(basePose(pair.model, pair.arms[1]), pair.base) == 0.0);
    }));
  }

  // A cell keeps what it wrote and read.
  void whatIsWrittenIsTheSame() {
    QVERIFY(rc::check("written and read", [] {
      const Pair pair;
      const RobotModel again = readOrThrow(urdfOf(pair.model)).robot;
      const JointValues values = anyValues(pair.model);
      RC_ASSERT(again.dofs.size() == pair.model.dofs.size());
      for (std::size_t dof = 0; dof < again.dofs.size(); ++dof)
        RC_ASSERT(again.jointOfDof(dof).name == pair.model.jointOfDof(dof).name);
      RC_ASSERT(areTheSame(again, values, pair.model, values));
    }));
  }

  void whoseLinksAndJoints() {
    QVERIFY(rc::check("owners", [] {
      const Pair pair;
      const auto links = armsOfLinks(pair.model, pair.arms), dofs = armsOfDofs(pair.model, pair.arms);
      for (std::size_t l = 0; l < links.size(); ++l) RC_ASSERT(links[l] == (l < pair.first.links.size() ? 0u : 1u));
      for (std::size_t d = 0; d < dofs.size(); ++d) RC_ASSERT(dofs[d] == (d < pair.first.dofs.size() ? 0u : 1u));
    }));
  }

  void theSecondIsRemoved() {
    QVERIFY(rc::check("the first remains", [] {
      const Pair pair;
      const RobotModel rest = withoutArm(pair.model, pair.arms, 1);
      const JointValues a = anyValues(pair.first);
      RC_ASSERT(rest.links.size() == pair.first.links.size());
      RC_ASSERT(rest.dofs.size() == pair.first.dofs.size());
      RC_ASSERT(rest.root == pair.first.root);
      RC_ASSERT(areTheSame(pair.first, a, rest, a));
    }));
  }

  // The other one stays where it is, on the bare root.
  void theFirstIsRemoved() {
    QVERIFY(rc::check("the second remains", [] {
      const Pair pair;
      const RobotModel rest = withoutArm(pair.model, pair.arms, 0);
      const JointValues b = anyValues(pair.second);
      RC_ASSERT(rest.links.size() == pair.second.links.size() + 1);
      RC_ASSERT(rest.dofs.size() == pair.second.dofs.size());
      RC_ASSERT(rest.links[rest.root].name == "world");
      RC_ASSERT(areTheSame(pair.second, b, rest, b, pair.base, "b_"));
      const RobotModel again = readOrThrow(urdfOf(rest)).robot;
      RC_ASSERT(areTheSame(rest, b, again, b));
    }));
  }

  void aBaseIsMoved() {
    QVERIFY(rc::check("it alone is elsewhere", [] {
      const Pair pair;
      const Pose base = anyBase();
      const RobotModel moved = withBaseAt(pair.model, pair.arms[1], base);
      const JointValues a = anyValues(pair.first), b = anyValues(pair.second);
      RC_ASSERT(areTheSame(pair.first, a, moved, together(a, b)));
      RC_ASSERT(areTheSame(pair.second, b, moved, together(a, b), base, "b_"));
    }));
  }

  // Tables give plain shapes in place of a robot's own, also after they were stored; the box of a description is what
  // its author says that the robot is.
  void plainShapes() {
    const auto isPlain = [](const RobotModel& robot) {
      return hasPlainShapes(robot, std::vector<RobotArm>{{"a", "r", robot.root, robot.root}}, 0);
    };
    const RobotModel table = robotOf(*libraryTable("irb120"));
    QVERIFY(isPlain(table));
    QVERIFY(isPlain(readOrThrow(urdfOf(table)).robot));
    const std::string box = "<visual><geometry><box size='1 1 1'/></geometry></visual>";
    QVERIFY(!isPlain(withBothShapes(readOrThrow(robotOf(link("l", box))).robot)));
    QVERIFY(!isPlain(withBothShapes(readOrThrow(robotOf(link("l", std::string()))).robot)));
  }

  // Shapes go with their links: the meshes of two descriptions may have one name.
  void shapes() {
    const std::string mesh = "<visual><geometry><mesh filename='a.stl'/></geometry></visual>";
    const RobotModel one = withBothShapes(readOrThrow(robotOf(link("l", mesh))).robot);
    QCOMPARE(one.links[0].collisions.size(), std::size_t{1});
    const RobotModel two = joined(one, one, "b", Pose::Identity());
    QCOMPARE(two.shapes.size(), std::size_t{2});
    QVERIFY(!(two.shapes[0] == two.shapes[1]));
    const std::vector<RobotArm> arms{{"a", "r", 0, 0}, {"b", "r", 1, 1}};
    QVERIFY(!hasPlainShapes(two, arms, 0) && !hasPlainShapes(two, arms, 1));
    const RobotModel rest = withoutArm(two, arms, 0);
    QCOMPARE(rest.shapes.size(), std::size_t{1});
    QVERIFY(rest.shapes[0] == two.shapes[1]);
    QVERIFY(rest.links[rest.root].visuals.empty());
    QCOMPARE(rest.links[linkNamed(rest, "b_l")].visuals.at(0).shape, 0u);
  }

  void names() {
    const RobotModel robot =
        readOrThrow(robotOf(link("left_foot") + link("arm") + joint("left 2_x", "fixed", "left_foot", "arm"))).robot;
    const std::vector<RobotArm> arms{{"hand", "r", 0, 1}};
    QCOMPARE(freeArmName(robot, arms, "right"), std::string("right"));
    QCOMPARE(freeArmName(robot, arms, "hand"), std::string("hand_2"));    // name of a robot
    QCOMPARE(freeArmName(robot, arms, "left"), std::string("left_2"));    // links begin with it
    QCOMPARE(freeArmName(robot, arms, "a,b=c."), std::string("a_b_c_"));  // signs of the command line
    QCOMPARE(freeArmName(robot, arms, ""), std::string("robot"));
    QCOMPARE(wholeArm(handwheel::robotOf(*libraryTable("irb120"))).name, std::string("irb120"));
  }

  // A joint of the other robot has the name of the one that holds it.
  void aJointCalledMount() {
    const RobotModel robot = readOrThrow(robotOf(link("l") + link("m") + joint("mount", "fixed", "l", "m"))).robot;
    const RobotModel two = joined(robot, robot, "b", Pose::Identity());
    QVERIFY(readUrdf(urdfOf(two)).hasValue());
  }
};

HANDWHEEL_TEST(RobotArmsTest)
#include "RobotArmsTest.moc"
