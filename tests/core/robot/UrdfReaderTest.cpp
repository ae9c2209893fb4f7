// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/UrdfReader.h"

#include "Robots.h"
#include "TestClass.h"

#include <QTest>
#include <clocale>
#include <cmath>
#include <numbers>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const std::string kAB = link("a") + link("b");

std::string jointAB(const std::string& type, const std::string& inside = {}) {
  return robotOf(kAB + joint("j", type, "a", "b", inside));
}

const Joint& onlyJoint(const ImportedRobot& read) {
  return read.robot.joints.front();
}

}  // namespace

class UrdfReaderTest : public QObject {
  Q_OBJECT

 private slots:
  void wholeRobot();
  void originsTurnAboutFixedAxes();
  void limitsInTheirUnits();
  void zeroIsUnknown_data();
  void zeroIsUnknown();
  void freeOfLimits();
  void followers();
  void heldStill();
  void toolAmongFingers();
  void longChain();
  void recognised();
  void numbersDoNotFollowTheLocale();
};

void UrdfReaderTest::wholeRobot() {
  // Children before parents, joints before links: the order in the file does not matter.
  const ImportedRobot read = readOrThrow(robotOf(
      joint("j2", "revolute", "b", "c", limit(-1, 1)) + link("c") + link("b") + joint("j1", "continuous", "a", "b") +
      link("a") + link("d") + joint("j3", "fixed", "a", "d") + "<gazebo/><transmission name='t'/>"));
  QVERIFY(read.damage.empty());
  const RobotModel& robot = read.robot;
  QCOMPARE(robot.name, std::string("r"));
  QCOMPARE(robot.links.size(), std::size_t{4});
  QCOMPARE(robot.links[robot.root].name, std::string("a"));
  std::vector<std::string> order, dofs;
  for (std::uint32_t j : robot.order) order.push_back(robot.joints[j].name);
  for (std::uint32_t j : robot.dofs) dofs.push_back(robot.joints[j].name);
  QCOMPARE(order, (std::vector<std::string>{"j1", "j2", "j3"}));
  QCOMPARE(dofs, (std::vector<std::string>{"j1", "j2"}));
  QCOMPARE(linkNamed(robot, "d"), std::uint32_t{3});
  QCOMPARE(linkNamed(robot, "none"), kNone);
  QCOMPARE(dofMoving(robot, linkNamed(robot, "c")), std::uint32_t{1});
  QCOMPARE(dofMoving(robot, linkNamed(robot, "b")), std::uint32_t{0});
  QCOMPARE(dofMoving(robot, linkNamed(robot, "d")), kNone);
  QCOMPARE(robot.links[toolLink(robot)].name, std::string("c"));
}

void UrdfReaderTest::originsTurnAboutFixedAxes() {
  constexpr double kRoll = 0.3, kPitch = -0.8, kYaw = 1.9;
  const ImportedRobot read = readOrThrow(jointAB("fixed", "<origin xyz='1 -2 0.5' rpy='0.3 -0.8 1.9'/>"));
  const Pose& origin = onlyJoint(read).origin;
  QCOMPARE(origin.translation(), Vec3(1000, -2000, 500));
  // The closed form of Rz(yaw) Ry(pitch) Rx(roll).
  const double cr = std::cos(kRoll), sr = std::sin(kRoll), cp = std::cos(kPitch), sp = std::sin(kPitch);
  const double cy = std::cos(kYaw), sy = std::sin(kYaw);
  Eigen::Matrix3d expected;
  expected << cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,  //
      sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,          //
      -sp, cp * sr, cp * cr;
  QVERIFY(origin.linear().isApprox(expected, 1e-14));
}

void UrdfReaderTest::limitsInTheirUnits() {
  const std::string text = "<limit lower='-0.5' upper='0.25' velocity='2' effort='30'/>";
  const JointLimits turning = onlyJoint(readOrThrow(jointAB("revolute", text))).limits;
  QVERIFY(turning.lower == -0.5 && turning.upper == 0.25 && turning.velocity == 2.0 && turning.effort == 30.0);
  const JointLimits sliding = onlyJoint(readOrThrow(jointAB("prismatic", text))).limits;
  QVERIFY(sliding.lower == -500 && sliding.upper == 250 && sliding.velocity == 2000.0 && sliding.effort == 30.0);
}

void UrdfReaderTest::zeroIsUnknown_data() {
  QTest::addColumn<QString>("velocity");
  for (const char* text : {"velocity='0'", "velocity='0.0'", "velocity='-1'", "", "velocity='inf'", "velocity='nan'"})
    QTest::newRow(text) << QString(text);
}

void UrdfReaderTest::zeroIsUnknown() {
  QFETCH(QString, velocity);
  QString effort = velocity;
  effort.replace("velocity", "effort");
  const ImportedRobot read =
      readOrThrow(jointAB("revolute", ("<limit lower='-1' upper='1' " + velocity + " " + effort + "/>").toStdString()));
  QVERIFY(!onlyJoint(read).limits.velocity.has_value());
  QVERIFY(!onlyJoint(read).limits.effort.has_value());
  QVERIFY(read.damage.empty());
}

void UrdfReaderTest::freeOfLimits() {
  const ImportedRobot turning = readOrThrow(jointAB("continuous", limit(-1, 1)));
  QVERIFY(std::isinf(onlyJoint(turning).limits.lower) && std::isinf(onlyJoint(turning).limits.upper));
  QVERIFY(turning.damage.empty());
  // Turns stay, as a path may have wound it up; far out they are removed.
  const double wound = 3.0 + 4.0 * std::numbers::pi;
  QCOMPARE(withinLimits(turning.robot, JointValues::Constant(1, wound))[0], wound);
  QCOMPARE(withinLimits(turning.robot, JointValues::Constant(1, -kMostTurn))[0], -kMostTurn);
  const JointValues three = withinLimits(turning.robot, JointValues::Constant(1, 3.0 + 400.0 * std::numbers::pi));
  QVERIFY(std::abs(three[0] - 3.0) < 1e-9);

  const ImportedRobot without = readOrThrow(jointAB("revolute"));
  QVERIFY(std::isinf(onlyJoint(without).limits.lower));
  QCOMPARE(without.damage.size(), std::size_t{1});
  const ImportedRobot sliding = readOrThrow(jointAB("prismatic", "<limit lower='-inf' upper='1e300'/>"));
  QCOMPARE(onlyJoint(sliding).limits.lower, -kFarthestTravel);
  QCOMPARE(onlyJoint(sliding).limits.upper, kFarthestTravel);
  // 0 lies outside.
  QCOMPARE(restValues(readOrThrow(jointAB("revolute", limit(0.5, 2))).robot)[0], 0.5);
}

void UrdfReaderTest::followers() {
  const auto robot = [](const std::string& mimicC, const std::string& mimicD) {
    return robotOf(kAB + link("c") + link("d") + joint("j", "revolute", "a", "b", limit(-1, 1)) +
                   joint("k", "prismatic", "a", "c", limit(-1, 1) + mimicC) +
                   joint("l", "revolute", "a", "d", limit(-1, 1) + mimicD));
  };
  const RobotModel chain = readOrThrow(robot("<mimic joint='j' multiplier='2' offset='0.25'/>",
                                             "<mimic joint='k' multiplier='-3' offset='1'/>"))
                               .robot;
  QCOMPARE(chain.dofs.size(), std::size_t{1});
  // k = 2 j + 0.25 metres; l = -3 k + 1 = -6 j + 0.25 radians.
  QVERIFY(chain.joints[1].dof == 0 && chain.joints[1].factor == 2000.0 && chain.joints[1].offset == 250.0);
  QVERIFY(chain.joints[2].dof == 0 && chain.joints[2].factor == -6.0 && chain.joints[2].offset == 0.25);

  for (const auto& [c, d] : {std::pair{"<mimic joint='l'/>", "<mimic joint='k'/>"}, {"<mimic joint='k'/>", ""}}) {
    const auto ring = readUrdf(robot(c, d));
    QVERIFY(!ring);
    QCOMPARE(ring.error().code, ErrorCode::ElementMalformed);
  }
  QCOMPARE(readUrdf(robot("<mimic joint='x'/>", "")).error().code, ErrorCode::ReferenceMissing);
  // A follower with factor 0 stands still.
  const RobotModel none = readOrThrow(robot("<mimic joint='j' multiplier='0' offset='0.25'/>", "")).robot;
  QCOMPARE(none.dofs.size(), std::size_t{2});
  QVERIFY(none.joints[1].dof == kNone && none.joints[1].offset == 250.0);
  // A fixed joint follows no other, and a follower of a fixed joint stands still.
  const RobotModel still =
      readOrThrow(robotOf(kAB + link("c") + joint("j", "fixed", "a", "b", "<mimic joint='x'/>") +
                          joint("k", "revolute", "a", "c", limit(-1, 1) + "<mimic joint='j' offset='0.5'/>")))
          .robot;
  QVERIFY(still.dofs.empty());
  QCOMPARE(still.joints[1].offset, 0.5);
}

void UrdfReaderTest::heldStill() {
  for (const char* type : {"floating", "planar"}) {
    const ImportedRobot read = readOrThrow(jointAB(type));
    QCOMPARE(onlyJoint(read).kind, JointKind::Fixed);
    QCOMPARE(read.damage.size(), std::size_t{1});
    QCOMPARE(read.damage[0].code, ErrorCode::Unsupported);
  }
}

// A frame between two fingers that move; a frame at the foot is none.
void UrdfReaderTest::toolAmongFingers() {
  const std::string body = "<visual><geometry><sphere radius='0.1'/></geometry></visual>";
  const std::string arm =
      link("a", body) + link("foot") + link("b", body) + link("c", body) + link("f", body) + link("g", body) +
      joint("s", "fixed", "a", "foot") + joint("j", "revolute", "a", "b", limit(-1, 1)) +
      joint("k", "revolute", "b", "c", limit(-1, 1)) + joint("l", "prismatic", "c", "f", limit(0, 1)) +
      joint("m", "prismatic", "c", "g", limit(0, 1) + "<mimic joint='l'/>");
  const RobotModel bare = readOrThrow(robotOf(arm)).robot;
  QCOMPARE(bare.links[toolLink(bare)].name, std::string("f"));
  const RobotModel framed = readOrThrow(robotOf(arm + link("tcp") + joint("t", "fixed", "c", "tcp"))).robot;
  QCOMPARE(framed.links[toolLink(framed)].name, std::string("tcp"));
}

// A chain as deep as the size allows; nothing recurses over the links.
void UrdfReaderTest::longChain() {
  std::string text = link("l0");
  constexpr int kCount = 15'000;
  for (int i = 1; i < kCount; ++i) {
    const std::string here = std::to_string(i), before = std::to_string(i - 1);
    text += link("l" + here) +
            joint("j" + here, "continuous", "l" + before, "l" + here, i == 1 ? "" : "<mimic joint='j" + before + "'/>");
  }
  const RobotModel robot = readOrThrow(robotOf(text)).robot;
  QCOMPARE(robot.order.size(), std::size_t{kCount - 1});
  QCOMPARE(robot.dofs.size(), std::size_t{1});
}

void UrdfReaderTest::recognised() {
  QVERIFY(looksLikeUrdf("<?xml version='1.0'?>\n<!-- c --><robot name='r'>"));
  QVERIFY(looksLikeUrdf("\xEF\xBB\xBF<robot>"));
  for (const char* text : {"", "<", "solid <robot ", "<robots>", "<robot", "<?xml version='1.0'?><COLLADA>"})
    QVERIFY(!looksLikeUrdf(text));
}

void UrdfReaderTest::numbersDoNotFollowTheLocale() {
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) QSKIP("the locale de_DE.UTF-8 is not installed");
  const ImportedRobot read = readOrThrow(jointAB("fixed", "<origin xyz='1.5 0 0'/>"));
  std::setlocale(LC_ALL, "C");
  QCOMPARE(onlyJoint(read).origin.translation().x(), 1500.0);
}

HANDWHEEL_TEST(UrdfReaderTest)
#include "UrdfReaderTest.moc"
