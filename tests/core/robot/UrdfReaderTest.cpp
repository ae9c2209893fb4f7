// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/UrdfReader.h"

#include "Robots.h"

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

const Joint& onlyJoint(const ReadRobot& read) {
  return read.robot.joints.front();
}

}  // namespace

Q_DECLARE_METATYPE(handwheel::ErrorCode)

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
  void shapes();
  void colours();
  void damagedShapesAreLeftOut_data();
  void damagedShapesAreLeftOut();
  void refused_data();
  void refused();
  void linesOfErrors();
  void toolAmongFingers();
  void longChain();
  void recognised();
  void numbersDoNotFollowTheLocale();
};

void UrdfReaderTest::wholeRobot() {
  // Children before parents, joints before links: the order in the file does not matter.
  const ReadRobot read = readOrThrow(robotOf(joint("j2", "revolute", "b", "c", limit(-1, 1)) + link("c") + link("b") +
                                             joint("j1", "continuous", "a", "b") + link("a") + link("d") +
                                             joint("j3", "fixed", "a", "d") + "<gazebo/><transmission name='t'/>"));
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
  const ReadRobot read = readOrThrow(jointAB("fixed", "<origin xyz='1 -2 0.5' rpy='0.3 -0.8 1.9'/>"));
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
  const ReadRobot read =
      readOrThrow(jointAB("revolute", ("<limit lower='-1' upper='1' " + velocity + " " + effort + "/>").toStdString()));
  QVERIFY(!onlyJoint(read).limits.velocity.has_value());
  QVERIFY(!onlyJoint(read).limits.effort.has_value());
  QVERIFY(read.damage.empty());
}

void UrdfReaderTest::freeOfLimits() {
  const ReadRobot turning = readOrThrow(jointAB("continuous", limit(-1, 1)));
  QVERIFY(std::isinf(onlyJoint(turning).limits.lower) && std::isinf(onlyJoint(turning).limits.upper));
  QVERIFY(turning.damage.empty());
  // Whole turns make no difference.
  const JointValues three = withinLimits(turning.robot, JointValues::Constant(1, 3.0 + 4.0 * std::numbers::pi));
  QVERIFY(std::abs(three[0] - 3.0) < 1e-12);

  const ReadRobot without = readOrThrow(jointAB("revolute"));
  QVERIFY(std::isinf(onlyJoint(without).limits.lower));
  QCOMPARE(without.damage.size(), std::size_t{1});
  const ReadRobot sliding = readOrThrow(jointAB("prismatic", "<limit lower='-inf' upper='1e300'/>"));
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
  // A fixed joint follows nobody, and who follows a fixed joint stands still.
  const RobotModel still =
      readOrThrow(robotOf(kAB + link("c") + joint("j", "fixed", "a", "b", "<mimic joint='x'/>") +
                          joint("k", "revolute", "a", "c", limit(-1, 1) + "<mimic joint='j' offset='0.5'/>")))
          .robot;
  QVERIFY(still.dofs.empty());
  QCOMPARE(still.joints[1].offset, 0.5);
}

void UrdfReaderTest::heldStill() {
  for (const char* type : {"floating", "planar"}) {
    const ReadRobot read = readOrThrow(jointAB(type));
    QCOMPARE(onlyJoint(read).kind, JointKind::Fixed);
    QCOMPARE(read.damage.size(), std::size_t{1});
    QCOMPARE(read.damage[0].code, ErrorCode::Unsupported);
  }
}

void UrdfReaderTest::shapes() {
  const std::string finger = "<geometry><mesh filename='f.stl' scale='1 2 -3'/></geometry>";
  const RobotModel robot =
      readOrThrow(robotOf(link("a",
                               "<visual><origin xyz='0 0 1'/><geometry><box size='1 2 3'/></geometry></visual>"
                               "<visual><geometry><cylinder radius='0.5' length='2'/></geometry></visual>"
                               "<collision><geometry><sphere radius='0.25'/></geometry></collision>"
                               "<visual>" +
                                   finger + "</visual><collision>" + finger + "</collision>")))
          .robot;
  const Link& a = robot.links[0];
  QCOMPARE(a.visuals.size(), std::size_t{3});
  QCOMPARE(a.collisions.size(), std::size_t{2});
  QCOMPARE(robot.shapes.size(), std::size_t{4});  // the mesh once
  QVERIFY(robot.shapes[a.visuals[0].shape] == Shape(BoxShape{{1000, 2000, 3000}}));
  QVERIFY(a.visuals[0].origin.translation() == Vec3(0, 0, 1000));
  QVERIFY(robot.shapes[a.visuals[1].shape] == Shape(CylinderShape{500, 2000}));
  QVERIFY(robot.shapes[a.collisions[0].shape] == Shape(SphereShape{250}));
  QVERIFY(robot.shapes[a.visuals[2].shape] == Shape(MeshShape{"f.stl", {1, 2, -3}}));
  QCOMPARE(a.visuals[2].shape, a.collisions[1].shape);
}

void UrdfReaderTest::colours() {
  const auto visual = [](const std::string& material) {
    return "<visual><geometry><sphere radius='1'/></geometry>" + material + "</visual>";
  };
  const RobotModel robot =
      readOrThrow(robotOf("<material name='red'><color rgba='1 0 0 1'/></material>" +
                          link("a", visual("<material name='red'/>") + visual("<material name='later'/>") + visual("") +
                                        visual("<material name='none'/>") +
                                        visual("<material name=''><color rgba='2 .5 -1 1'/></material>")) +
                          link("b", visual("<material name='later'><color rgba='0 0 1 1'/></material>")) +
                          joint("j", "fixed", "a", "b")))
          .robot;
  const auto& visuals = robot.links[0].visuals;
  QVERIFY(visuals[0].colour == (ShapeColour{1, 0, 0}));
  QVERIFY(visuals[1].colour == (ShapeColour{0, 0, 1}));
  QVERIFY(!visuals[2].colour && !visuals[3].colour);
  QVERIFY(visuals[4].colour == (ShapeColour{1, 0.5f, 0}));
}

void UrdfReaderTest::damagedShapesAreLeftOut_data() {
  QTest::addColumn<QString>("visual");
  for (const char* text :
       {"", "<geometry/>", "<geometry><mesh/></geometry>", "<geometry><mesh filename=''/></geometry>",
        "<geometry><box size='1 1'/></geometry>", "<geometry><box size='1 0 1'/></geometry>",
        "<geometry><box/></geometry>", "<geometry><sphere radius='-1'/></geometry>",
        "<geometry><sphere radius='nan'/></geometry>", "<geometry><cylinder radius='1'/></geometry>",
        "<geometry><capsule radius='1' length='1'/></geometry>",
        "<geometry><mesh filename='a.stl' scale='0 1 1'/></geometry>",
        "<geometry><mesh filename='a.stl' scale='1e300 1 1'/></geometry>",
        "<origin xyz='nan 0 0'/><geometry><sphere radius='1'/></geometry>"})
    QTest::newRow(text) << QString(text);
}

void UrdfReaderTest::damagedShapesAreLeftOut() {
  QFETCH(QString, visual);
  const std::string good = "<visual><geometry><sphere radius='1'/></geometry></visual>";
  const ReadRobot read = readOrThrow(robotOf(link("a", "<visual>" + visual.toStdString() + "</visual>" + good)));
  QCOMPARE(read.robot.links[0].visuals.size(), std::size_t{1});
  QCOMPARE(read.damage.size(), std::size_t{1});
  QVERIFY(read.damage[0].place.kind == Place::Kind::Line);
}

void UrdfReaderTest::refused_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<ErrorCode>("code");
  const auto row = [](const char* name, const std::string& text, ErrorCode code) {
    QTest::newRow(name) << QString::fromStdString(text) << code;
  };
  const auto kMalformed = ErrorCode::ElementMalformed;
  row("no XML", "solid part", kMalformed);
  row("something else", "<html/>", kMalformed);
  row("empty", robotOf(""), kMalformed);
  row("link without name", robotOf("<link/>"), kMalformed);
  row("two links of a name", robotOf(link("a") + link("a")), kMalformed);
  row("two joints of a name", robotOf(kAB + link("c") + joint("j", "fixed", "a", "b") + joint("j", "fixed", "b", "c")),
      kMalformed);
  row("joint without name", robotOf(kAB + "<joint type='fixed'/>"), kMalformed);
  row("joint without type", robotOf(kAB + "<joint name='j'/>"), kMalformed);
  row("unknown type", jointAB("hinge"), kMalformed);
  row("no parent", robotOf(kAB + "<joint name='j' type='fixed'><child link='b'/></joint>"), kMalformed);
  row("missing parent", robotOf(link("b") + joint("j", "fixed", "a", "b")), ErrorCode::ReferenceMissing);
  row("missing child", robotOf(link("a") + joint("j", "fixed", "a", "b")), ErrorCode::ReferenceMissing);
  row("two roots", robotOf(kAB), kMalformed);
  row("no root", robotOf(kAB + joint("j", "fixed", "a", "b") + joint("k", "fixed", "b", "a")), kMalformed);
  row("own parent", robotOf(link("a") + joint("j", "fixed", "a", "a")), kMalformed);
  row("two parents",
      robotOf(kAB + link("c") + joint("j", "fixed", "a", "b") + joint("k", "fixed", "a", "c") +
              joint("l", "fixed", "c", "b")),
      kMalformed);
  row("ring apart",
      robotOf(kAB + link("c") + link("d") + joint("j", "fixed", "a", "b") + joint("k", "fixed", "c", "d") +
              joint("l", "fixed", "d", "c")),
      kMalformed);
  row("no axis", jointAB("revolute", "<axis xyz='0 0 0'/>" + limit(-1, 1)), kMalformed);
  row("axis of two numbers", jointAB("revolute", "<axis xyz='0 1'/>" + limit(-1, 1)), ErrorCode::CountMismatch);
  row("axis not finite", jointAB("revolute", "<axis xyz='0 nan 0'/>" + limit(-1, 1)), ErrorCode::NumberNotFinite);
  row("origin not finite", jointAB("fixed", "<origin xyz='inf 0 0'/>"), ErrorCode::NumberNotFinite);
  row("turn not finite", jointAB("fixed", "<origin rpy='0 0 1e999'/>"), ErrorCode::NumberNotFinite);
  row("origin no number", jointAB("fixed", "<origin xyz='${x} 0 0'/>"), ErrorCode::NumberMalformed);
  row("origin too far", jointAB("fixed", "<origin xyz='1e7 0 0'/>"), ErrorCode::ValueOutOfRange);
  row("limits turned round", jointAB("revolute", limit(1, -1)), kMalformed);
  row("limit not a number", jointAB("revolute", "<limit lower='nan' upper='1'/>"), ErrorCode::NumberNotFinite);
  row("limit malformed", jointAB("revolute", "<limit lower='a' upper='1'/>"), ErrorCode::NumberMalformed);
  row("limit of two numbers", jointAB("revolute", "<limit lower='0 1' upper='1'/>"), ErrorCode::NumberMalformed);
  row("follows nobody", jointAB("revolute", limit(-1, 1) + "<mimic/>"), kMalformed);
  row("follows too far",
      robotOf(kAB + link("c") + joint("j", "revolute", "a", "b", limit(-1, 1)) +
              joint("k", "revolute", "b", "c", limit(-1, 1) + "<mimic joint='j' multiplier='1e300'/>")),
      kMalformed);
  row("xacro", robotOf(link("a") + "<xacro:include filename='x'/>"), ErrorCode::Unsupported);
}

void UrdfReaderTest::refused() {
  QFETCH(QString, text);
  QFETCH(ErrorCode, code);
  const auto read = readUrdf(text.toStdString());
  QVERIFY(!read);
  QCOMPARE(read.error().code, code);
}

void UrdfReaderTest::linesOfErrors() {
  const auto read = readUrdf("<robot>\n<link name='a'/>\n<link name='b'/>\n\n" +
                             joint("j", "revolute", "a", "b", "\n<axis xyz='0 0 oops'/>") + "</robot>");
  QVERIFY(!read);
  QCOMPARE(read.error().place.value, std::uint64_t{6});
  QCOMPARE(read.error().arguments, std::vector<std::string>{"oops"});
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

// As deep as the size allows; nothing recurses over the links.
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
  const ReadRobot read = readOrThrow(jointAB("fixed", "<origin xyz='1.5 0 0'/>"));
  std::setlocale(LC_ALL, "C");
  QCOMPARE(onlyJoint(read).origin.translation().x(), 1500.0);
}

QTEST_GUILESS_MAIN(UrdfReaderTest)
#include "UrdfReaderTest.moc"
