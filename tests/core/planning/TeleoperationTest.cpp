// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/Teleoperation.h"

#include "TestClass.h"
#include "planning/problems/PlanningSet.h"
#include "robot/Kinematics.h"
#include "robot/dh/DhTable.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>
#include <numeric>

using namespace handwheel;

namespace {

// An IRB 120 before a wall at x = 420 mm.
class HandledRobot {
 public:
  HandledRobot() : m_table(*libraryTable("irb120")), m_model(robotOf(m_table)), m_scene(sceneOf()) {
    m_scene.addObstacle(CollisionBody({CollisionPiece::box(Pose::Identity(), {100.0, 2000.0, 2000.0})}),
                        Pose(Eigen::Translation3d(520.0, 0.0, 600.0)), 1);
  }
  const RobotScene& scene() const { return m_scene; }
  SerialArm arm() const { return armOf(std::vector<DhRow>(m_table.joints.begin(), m_table.joints.end())); }
  static ArmValues start() {
    ArmValues values(6);
    values << 0.2, 0.1, 0.3, 0.1, 0.7, 0.0;
    return values;
  }
  // Returns the end of the robot along an axis at its start, downwards: by a plate that is brought near.
  static double leastOf(const RobotScene& scene, const SerialArm& arm, Eigen::Index axis) {
    const Vec3 tip = arm.tipPose(start()).translation();
    double least = tip[axis] - 300.0, most = tip[axis];
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (least + most);
      Vec3 at(300.0, 0.0, 500.0);
      at[axis] = middle - 2.0;
      const CollisionBody plate({CollisionPiece::box(Pose::Identity(), {400.0, 4.0, 1200.0})});
      (scene.nearestTo(plate, Pose(Eigen::Translation3d(at)), start(), 1e3).distance > 0.0 ? least : most) = middle;
    }
    return least;
  }
  Teleoperation teleoperation() const { return {m_scene, arm(), Pose::Identity(), start(), {}}; }

 private:
  RobotScene sceneOf() const {
    std::vector<std::uint32_t> dofs(6);
    std::iota(dofs.begin(), dofs.end(), 0u);
    std::set<LinkPair> allowed = neighbours(m_model);
    allowed.merge(overlappingLinks(m_table));
    RobotScene scene(m_model, Pose::Identity(), collisionBodies(m_model), dofs, restValues(m_model), allowed);
    scene.allowPairs(scene.alwaysMeeting());
    return scene;
  }

  const DhTable& m_table;
  RobotModel m_model;
  RobotScene m_scene;
};

}  // namespace

// A robot that follows a hand.
class TeleoperationTest : public QObject {
  Q_OBJECT

 private slots:
  // Slowly, in the open: the tool is at the wanted pose, and no force is felt.
  void followsInTheOpen() {
    const HandledRobot robot;
    Teleoperation following = robot.teleoperation();
    Pose wanted = following.tool();
    for (int i = 0; i < 100; ++i) {
      wanted.translation() += Vec3(0.0, 0.5, 0.2);
      const Teleoperation::Step step = following.follow(wanted, 0.02);
      QVERIFY(step.behind < 0.05 && step.force.norm() < 0.05);
      QVERIFY(!step.isBlocked);
    }
  }

  // Into the wall and along it: never through, and the hand is pulled back.
  void stopsAtAWall() {
    const HandledRobot robot;
    Teleoperation following = robot.teleoperation();
    Pose wanted = following.tool();
    Teleoperation::Step step;
    for (int i = 0; i < 300; ++i) {
      wanted.translation() += Vec3(1.0, 0.3, 0.0);
      step = following.follow(wanted, 0.02);
      QVERIFY(robot.scene().nearest(following.values(), 1.0).distance > 0.0);
    }
    QVERIFY(step.isBlocked);
    QVERIFY(step.behind > 50.0);
    QVERIFY(step.force.x() < -1.0);
    QVERIFY(step.tool.translation().y() > robot.teleoperation().tool().translation().y());  // it slid along
    // It comes back out.
    for (int i = 0; i < 400; ++i) {
      wanted.translation() += Vec3(-1.0, 0.0, 0.0);
      step = following.follow(wanted, 0.02);
    }
    QVERIFY(!step.isBlocked);
    QVERIFY(step.behind < 1.0);
  }

  // A hand that leaps and rests: the robot is there at once if there is no obstacle, and never in the wall.
  void isLedByLeaps() {
    const HandledRobot robot;
    Teleoperation following = robot.teleoperation();
    Pose wanted = following.tool();
    wanted.translation() += Vec3(-30.0, 150.0, 60.0);
    wanted.rotate(Eigen::AngleAxisd(0.6, Vec3::UnitY()));
    QVERIFY(following.lead(wanted).behind < 0.05);
    QVERIFY((following.tool().linear() - wanted.linear()).norm() < 1e-3);
    wanted.translation() += Vec3(400.0, 0.0, 0.0);
    const Teleoperation::Step step = following.lead(wanted);
    QVERIFY(step.isBlocked && step.behind > 50.0);
    QVERIFY(robot.scene().nearest(following.values(), 1.0).distance > 0.0);
    wanted.translation().x() = std::nan("");
    QVERIFY(following.lead(wanted).tool.matrix().allFinite());
  }

  // A SCARA whose hand tilts, which it cannot: its tool is at the position of the hand, and turns about its axis as the
  // hand does.
  void followsWithFourJoints() {
    const DhTable table{.name = "scara",
                        .joints = {{{.a = 300.0, .d = 400.0, .lower = -2.5, .upper = 2.5}, "a"},
                                   {{.a = 200.0, .lower = -2.5, .upper = 2.5}, "b"},
                                   {{.isPrismatic = true, .lower = -150.0, .upper = 0.0}, "c"},
                                   {{.lower = -3.0, .upper = 3.0}, "d"}}};
    RobotModel model = robotOf(table);
    for (Link& link : model.links) link.collisions.clear();
    const RobotScene scene(model, Pose::Identity(), collisionBodies(model), {0, 1, 2, 3}, restValues(model), {});
    const SerialArm arm = armOf(std::vector<DhRow>(table.joints.begin(), table.joints.end()));
    const Pose tool(Eigen::Translation3d(20.0, 0.0, 50.0));  // beside the axis: the tilt must not move it
    ArmValues start(4);
    start << 0.2, 0.8, -50.0, 0.1;
    Teleoperation following(scene, arm, tool, start, {});
    const Pose begin = following.tool();
    Pose wanted;
    for (int i = 1; i <= 100; ++i) {
      const double share = i / 100.0;
      wanted = begin;
      wanted.translation() += share * Vec3(-60.0, 80.0, 30.0);
      wanted.linear() = Eigen::AngleAxisd(0.3 * share, Vec3::UnitX()) * Eigen::AngleAxisd(0.5 * share, Vec3::UnitZ()) *
                        begin.linear();
      QVERIFY(following.follow(wanted, 0.05).behind < 0.05);
    }
    // The rotation about z by 0.5 is the nearest of all: the tilt alone is left.
    const Eigen::AngleAxisd off(following.tool().linear().transpose() * wanted.linear());
    QVERIFY(std::abs(off.angle() - 0.3) < 0.01);
  }

  // Joint by joint: at the wanted value, or at the limit.
  void isLedByJoints() {
    const HandledRobot robot;
    Teleoperation following = robot.teleoperation();
    ArmValues wanted = HandledRobot::start();
    wanted[0] += 0.8;
    wanted[5] = -2.0;
    QVERIFY(following.lead(wanted).behind < 1e-9);
    QVERIFY((following.values() - wanted).norm() < 1e-12);
    wanted[5] = 100.0;
    const Teleoperation::Step step = following.lead(wanted);
    QVERIFY(step.isAtLimit);
    QCOMPARE(following.values()[5], robot.scene().joint(5).upper);
  }

  // Configurations with axes 4 and 6 in line, and with the wrist above axis 1: the hand continues straight, the tool
  // with it.
  void throughSingularities_data() {
    QTest::addColumn<QList<double>>("from");
    QTest::addColumn<QList<double>>("to");
    const QList<double> bent{2.5, 0.1, 0.1, 0.0, 0.5, 0.0};
    QTest::newRow("straight wrist") << bent << QList<double>{2.5, 0.2, 0.0, 0.0, -0.5, 0.0};
    QTest::newRow("beside it") << QList<double>{2.5, 0.1, 0.1, 0.05, 0.5, 0.0}
                               << QList<double>{2.5, 0.2, 0.0, 0.05, -0.5, 0.0};
    QTest::newRow("wrist above the first axis")
        << QList<double>{2.5, -0.3, -0.3, 0.0, 0.6, 0.0} << QList<double>{2.5, -0.8, -0.3, 0.0, 0.6, 0.0};
  }
  void throughSingularities() {
    QFETCH(const QList<double>, from);
    QFETCH(const QList<double>, to);
    const HandledRobot robot;
    const SerialArm arm = robot.arm();
    const ArmValues start = Eigen::Map<const ArmValues>(from.data(), 6),
                    end = Eigen::Map<const ArmValues>(to.data(), 6);
    Teleoperation following(robot.scene(), arm, Pose::Identity(), start, {});
    const Pose first = following.tool(), last = arm.tipPose(end);
    const Eigen::Quaterniond before(first.linear()), after(last.linear());
    const Vec3 displacement = last.translation() - first.translation();
    constexpr int kSteps = 200;
    Pose wanted = first;
    for (int i = 1; i <= kSteps; ++i) {
      const double share = static_cast<double>(i) / kSteps;
      wanted = Eigen::Translation3d(first.translation() + share * displacement) * before.slerp(share, after);
      const Pose was = following.tool();
      const Teleoperation::Step step = following.follow(wanted, 0.02);
      QVERIFY(!step.isBlocked && step.behind < 5.0);
      QVERIFY((following.tool().translation() - was.translation()).norm() > 0.05 * displacement.norm() / kSteps);
    }
    for (int i = 0; i < 20; ++i) following.follow(last, 0.02);  // the joints may have been too slow
    QVERIFY((following.tool().translation() - last.translation()).norm() < 0.1);
    QVERIFY((following.tool().linear() - last.linear()).norm() < 1e-3);
  }

  // A robot beyond a limit returns to it, by its joints or by its tool, and goes no further out.
  void backFromBeyondALimit() {
    const HandledRobot robot;
    const SerialArm arm = robot.arm();
    const double limit = robot.scene().joint(0).upper;
    ArmValues beyond = HandledRobot::start(), within = beyond;
    beyond[0] = limit + 0.2;
    within[0] = limit - 0.3;
    ArmValues further = beyond;
    further[0] = limit + 0.5;
    Teleoperation joints(robot.scene(), arm, Pose::Identity(), beyond, {});
    QVERIFY(joints.lead(further).isAtLimit);
    QVERIFY(joints.values()[0] <= beyond[0]);
    joints.lead(within);
    QVERIFY((joints.values() - within).norm() < 1e-9);

    Teleoperation tool(robot.scene(), arm, Pose::Identity(), beyond, {});
    double last = beyond[0];
    for (int i = 0; i < 10; ++i) {
      tool.follow(arm.tipPose(further), 0.01);
      QVERIFY(tool.values()[0] <= last + 1e-12);
      last = std::max(limit, tool.values()[0]);
    }
    for (int i = 0; i < 100; ++i) tool.follow(arm.tipPose(within), 0.02);
    QVERIFY(robot.scene().isWithinLimits(tool.values()));
    QVERIFY((tool.tool().translation() - arm.tipPose(within).translation()).norm() < 0.1);
  }

  // A robot that begins inside something comes out, and does not go in further.
  void isLedOut() {
    const HandledRobot robot;
    RobotScene scene = robot.scene();
    const SerialArm arm = robot.arm();
    const Vec3 at = arm.tipPose(HandledRobot::start()).translation();
    const double radius = 60.0;
    const Vec3 centre = at + Vec3(0.0, 0.0, -radius - 5.0);
    scene.addObstacle(CollisionBody({CollisionPiece::sphere(centre, radius)}), Pose::Identity(), 2);
    const double begin = scene.nearest(HandledRobot::start(), 1.0).distance;
    QVERIFY(begin <= 0.0);
    Teleoperation following(scene, arm, Pose::Identity(), HandledRobot::start(), {});
    Pose wanted = following.tool();
    for (int i = 0; i < 20; ++i) {
      wanted.translation().z() -= 1.0;
      following.lead(wanted);
      QVERIFY(scene.nearest(following.values(), 1.0).distance >= begin - 1e-9);
    }
    for (int i = 0; i < 150; ++i) {
      wanted.translation().z() += 1.0;
      following.lead(wanted);
    }
    QVERIFY(scene.nearest(following.values(), 1.0).distance > 0.0);
  }

  // A bar of 4 mm that the flange almost touches: no leap of the hand, however long, brings the robot behind it.
  void neverThroughAThinBar() {
    const HandledRobot robot;
    const SerialArm arm = robot.arm();
    for (const double gap : {0.5, 0.02}) {
      RobotScene scene = robot.scene();
      const double edge = robot.leastOf(scene, arm, 1);
      scene.addObstacle(CollisionBody({CollisionPiece::box(Pose::Identity(), {400.0, 4.0, 1200.0})}),
                        Pose(Eigen::Translation3d(300.0, edge - gap - 2.0, 500.0)), 2);
      QVERIFY(scene.nearest(HandledRobot::start(), 1e3).distance > 0.0);
      for (const double leap : {10.0, 60.0, 80.0, 300.0}) {
        Teleoperation following(scene, arm, Pose::Identity(), HandledRobot::start(), {});
        Pose wanted = following.tool();
        wanted.translation().y() -= leap;
        for (int i = 0; i < 10; ++i) {
          following.follow(wanted, 0.05);
          QVERIFY2(following.tool().translation().y() > edge - gap, qPrintable(QString::number(leap)));
          QVERIFY(scene.nearest(following.values(), 1.0).distance > 0.0);
        }
      }
    }
  }

  // Nearer to the wall than it may be: it can go along and away, and not nearer.
  void withinTheClearance() {
    const HandledRobot robot;
    const SerialArm arm = robot.arm();
    TeleoperationSettings settings;
    const double begin = robot.scene().nearestObstacle(HandledRobot::start(), 1e3).distance;
    settings.check.clearance = begin + 5.0;
    Teleoperation following(robot.scene(), arm, Pose::Identity(), HandledRobot::start(), settings);
    Pose wanted = following.tool();
    wanted.translation().x() += 30.0;
    for (int i = 0; i < 10; ++i) following.follow(wanted, 0.05);
    QVERIFY(robot.scene().nearestObstacle(following.values(), 1e3).distance >= begin - 1e-6);
    wanted.translation().x() -= 130.0;
    for (int i = 0; i < 40; ++i) following.follow(wanted, 0.05);
    QVERIFY(robot.scene().nearestObstacle(following.values(), 1e3).distance > begin + 5.0);
  }

  // From a start inside a box, the robot is not led through it, and comes out where it went in.
  void neverDeeperInABox() {
    const HandledRobot robot;
    const SerialArm arm = robot.arm();
    RobotScene scene = robot.scene();
    const Vec3 at = arm.tipPose(HandledRobot::start()).translation();
    // Its top is 5 mm above the flange's centre.
    scene.addObstacle(CollisionBody({CollisionPiece::box(Pose::Identity(), {300.0, 300.0, 200.0})}),
                      Pose(Eigen::Translation3d(at + Vec3(0.0, 0.0, -95.0))), 2);
    QVERIFY(scene.nearest(HandledRobot::start(), 1.0).distance <= 0.0);
    Teleoperation following(scene, arm, Pose::Identity(), HandledRobot::start(), {});
    Pose wanted = following.tool();
    wanted.translation().z() -= 100.0;
    for (int i = 0; i < 30; ++i) following.follow(wanted, 0.05);
    QVERIFY((following.tool().translation() - at).norm() < 5.0);
  }

  // For any motion of the hand: within the limits, no faster than the joints, free, finite.
  void anyHand() {
    const HandledRobot robot;
    QVERIFY(rc::check("limits, speed and freedom", [&] {
      Teleoperation following = robot.teleoperation();
      Pose wanted = following.tool();
      for (int i = 0; i < 30; ++i) {
        const ArmValues before = following.values();
        const double seconds = *rc::gen::inRange(1, 50) / 1000.0;
        wanted.translation() +=
            Vec3(*rc::gen::inRange(-300, 301), *rc::gen::inRange(-300, 301), *rc::gen::inRange(-300, 301));
        if (*rc::gen::inRange(0, 10) == 0) wanted.translation().x() = std::nan("");
        const Teleoperation::Step step = following.follow(wanted, seconds);
        if (!wanted.translation().allFinite()) wanted = following.tool();
        RC_ASSERT(step.force.allFinite() && step.force.norm() <= 5.0 + 1e-9);
        RC_ASSERT(robot.scene().isWithinLimits(following.values()));
        RC_ASSERT(robot.scene().nearest(following.values(), 1.0).distance > 0.0);
        for (Eigen::Index k = 0; k < 6; ++k) {
          const double most = seconds * *robot.scene().joint(k).velocity;
          // Each joint may have moved with all others, and once more alone.
          RC_ASSERT(std::abs(following.values()[k] - before[k]) <= 2.0 * most + 1e-9);
        }
      }
    }));
  }
};

HANDWHEEL_TEST(TeleoperationTest)
#include "TeleoperationTest.moc"
