// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/arm/SerialArm.h"

#include "../RobotFiles.h"
#include "../Robots.h"
#include "Arms.h"
#include "TestClass.h"
#include "robot/Kinematics.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

// The product of the matrices of the textbook, written out (Craig 2005; He 2008, equation 6-2 in the standard form).
Pose byTextbook(const std::vector<DhRow>& table, const ArmValues& values) {
  Eigen::Matrix4d all = Eigen::Matrix4d::Identity();
  for (std::size_t i = 0; i < table.size(); ++i) {
    const DhRow& row = table[i];
    const double q = row.sign * values[static_cast<Eigen::Index>(i)];
    const double theta = row.isPrismatic ? row.theta : row.theta + q, d = row.isPrismatic ? row.d + q : row.d;
    const double ct = std::cos(theta), st = std::sin(theta), ca = std::cos(row.alpha), sa = std::sin(row.alpha);
    Eigen::Matrix4d step;
    step << ct, -st * ca, st * sa, row.a * ct,  //
        st, ct * ca, -ct * sa, row.a * st,      //
        0, sa, ca, d,                           //
        0, 0, 0, 1;
    all = all * step;
  }
  return Pose(all);
}

std::uint32_t flangeOf(const RobotModel& robot) {
  return toolLink(robot);
}

}  // namespace

class SerialArmTest : public QObject {
  Q_OBJECT

 private slots:
  void tableByTheTextbook() {
    for (const LibraryRobot& each : robotLibrary()) {
      const DhTable& table = *libraryTable(each.id);
      const std::vector<DhRow> rows(table.joints.begin(), table.joints.end());
      const SerialArm arm = armOf(rows);
      QVERIFY(rc::check([&] {
        const ArmValues values = anyValuesOf(arm);
        RC_ASSERT(difference(arm.tipPose(values), byTextbook(rows, values), arm.reach()) < 1e-13);
      }));
    }
  }

  // The tree of links that the window shows has its flange at the same position, and so has the arm between its links.
  void treeAndChainAgree() {
    QVERIFY(rc::check([] {
      const LibraryRobot& any = *rc::gen::elementOf(robotLibrary());
      const DhTable& table = *libraryTable(any.id);
      const RobotModel robot = robotOf(table);
      const SerialArm arm = libraryArm(any.id);
      const ArmValues values = anyValuesOf(arm);
      const std::uint32_t flange = linkNamed(robot, "flange");
      RC_ASSERT(flangeOf(robot) == flange);
      const Pose pose = linkPoses(robot, JointValues(values))[flange];
      RC_ASSERT(difference(arm.tipPose(values), pose, arm.reach()) < 1e-13);
      const auto between = SerialArm::of(robot, robot.root, flange);
      RC_ASSERT(between.hasValue());
      RC_ASSERT(difference(between->arm.tipPose(values), pose, arm.reach()) < 1e-13);
    }));
  }

  // Robots of any form, whose joints have any axes.
  void chainsOfTrees() {
    QVERIFY(rc::check([] {
      const RobotModel robot = readOrThrow(anyRobot()).robot;
      const std::uint32_t tip = *rc::gen::inRange<std::uint32_t>(0, std::uint32_t(robot.links.size()));
      const auto made = SerialArm::of(robot, robot.root, tip);
      if (!made) return;  // geared
      const JointValues all = anyValues(robot);
      ArmValues values(made->arm.size());
      for (Eigen::Index i = 0; i < values.size(); ++i) values[i] = all[made->dofs[static_cast<std::size_t>(i)]];
      RC_ASSERT(difference(made->arm.tipPose(values), linkPoses(robot, all)[tip], 1e3) < 1e-12);
    }));
  }

  void jacobianIsTheDerivative() {
    QVERIFY(rc::check([] {
      const SerialArm arm = anyArm(*rc::gen::inRange(1, 9));
      const ArmValues values = anyValuesOf(arm);
      ArmJacobian jacobian;
      const Pose tip = arm.tipPose(values, jacobian);
      RC_ASSERT(difference(tip, arm.tipPose(values), 1.0) == 0.0);
      for (Eigen::Index i = 0; i < arm.size(); ++i) {
        constexpr double kStep = 1e-5;
        ArmValues more = values, less = values;
        more[i] += kStep;
        less[i] -= kStep;
        const Pose a = arm.tipPose(less), b = arm.tipPose(more);
        const Vec3 displacement = (b.translation() - a.translation()) / (2 * kStep);
        const Eigen::AngleAxisd turn(Eigen::Matrix3d(b.linear() * a.linear().transpose()));
        RC_ASSERT((displacement - jacobian.col(i).head<3>()).norm() < 1e-5 * arm.reach());
        RC_ASSERT((turn.angle() * turn.axis() / (2 * kStep) - jacobian.col(i).tail<3>()).norm() < 1e-5);
      }
    }));
  }

  // The tables are those of the robots whose descriptions their users publish.
  void tablesAreThoseOfTheDescriptions_data() {
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("tip");
    QTest::newRow("IRB 120") << "irb120" << kIrb120 << "tool0";
    QTest::newRow("IRB 2400") << "irb2400" << kIrb2400 << "tool0";
    QTest::newRow("LR Mate") << "lrmate200id" << kLrMate << "tool0";
  }

  void tablesAreThoseOfTheDescriptions() {
    if (qEnvironmentVariable("HANDWHEEL_DATA").isEmpty()) QSKIP("HANDWHEEL_DATA is not set");
    QFETCH(QString, id);
    QFETCH(QString, file);
    QFETCH(QString, tip);
    const RobotModel robot = robotIn(file.toUtf8().constData());
    const std::uint32_t link = linkNamed(robot, tip.toStdString()), base = linkNamed(robot, "base_link");
    QVERIFY(link != kNone && base != kNone);
    const auto described = SerialArm::of(robot, base, link);
    QVERIFY(described.hasValue());
    const SerialArm arm = libraryArm(id.toStdString());
    QCOMPARE(described->arm.size(), arm.size());
    QVERIFY(rc::check([&] {
      const ArmValues values = anyValuesOf(arm);
      RC_ASSERT(difference(described->arm.tipPose(values), arm.tipPose(values), arm.reach()) < 1e-9);
    }));
  }

  void noArm() {
    const RobotModel robot = readOrThrow(planarArm({1.0, 1.0})).robot;
    QVERIFY(!SerialArm::of(robot, linkNamed(robot, "tool"), robot.root));
    std::vector<double> lengths(30, 1.0);
    const RobotModel snake = readOrThrow(planarArm(lengths)).robot;
    QVERIFY(!SerialArm::of(snake, snake.root, linkNamed(snake, "tool")));
    const auto nothing = SerialArm::of(robot, robot.root, robot.root);
    QVERIFY(nothing.hasValue());
    QCOMPARE(nothing->arm.size(), Eigen::Index{0});
  }
};

HANDWHEEL_TEST(SerialArmTest)
#include "SerialArmTest.moc"
