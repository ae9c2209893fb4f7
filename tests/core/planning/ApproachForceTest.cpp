// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/ApproachForce.h"

#include "Scenes.h"
#include "TestClass.h"
#include "robot/Kinematics.h"
#include "robot/arm/ClosedFormIk.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// An IRB 120 whose only shapes are a ball at its flange and one at its elbow.
struct TwoBalls {
  static constexpr double kRadius = 30.0;

  TwoBalls() : table(*libraryTable("irb120")), model(robotOf(table)) {
    model.shapes = {SphereShape{kRadius}};
    for (Link& link : model.links) {
      link.visuals.clear();
      link.collisions.clear();
    }
    model.links.back().collisions.push_back({0, Pose::Identity(), {}});
    model.links[3].collisions.push_back({0, Pose::Identity(), {}});
  }
  RobotScene scene() const { return sceneOf(model); }
  SerialArm arm() const { return armOf(std::vector<DhRow>(table.joints.begin(), table.joints.end())); }
  static ArmValues start() {
    ArmValues values(6);
    values << 0.2, 0.1, 0.3, 0.4, 0.9, 0.2;
    return values;
  }

  const DhTable& table;
  RobotModel model;
};

}  // namespace

// The force on a hand that leads a robot.
class ApproachForceTest : public QObject {
  Q_OBJECT

 private slots:
  // A ball at the flange before a large wall: the stiffness times the distance below the reach, at right angles to the
  // wall, by the formula of a ball and a plane.
  void ofABallBeforeAWall() {
    const TwoBalls robot;
    const SerialArm arm = robot.arm();
    const Vec3 flange = arm.tipPose(TwoBalls::start()).translation();
    for (const double distance : {20.0, 9.0, 5.0, 0.5, -3.0}) {
      RobotScene scene = robot.scene();
      const double wall = flange.x() + TwoBalls::kRadius + distance;
      scene.addObstacle(CollisionBody({CollisionPiece::box(Pose::Identity(), {100.0, 4000.0, 4000.0})}),
                        Pose(Eigen::Translation3d(wall + 50.0, 0.0, 0.0)), 1);
      const DistanceForceSettings settings{.reach = 10.0, .stiffness = 0.5, .largestForce = 50.0};
      ApproachForce force(scene, arm, Pose::Identity(), settings);
      const ApproachForce::Felt felt = force.at(TwoBalls::start());
      const Vec3 expected(-0.5 * std::max(0.0, 10.0 - distance), 0.0, 0.0);
      QVERIFY2((felt.force - expected).norm() < 0.01 * std::max(0.1, expected.norm()),
               qPrintable(QString::number(distance)));
      QVERIFY(distance > 10.0 ? std::isinf(felt.distance) : std::abs(felt.distance - distance) < 1e-6);
    }
  }

  // The same force at the end of a tool: the force at the ball turns the hand by its lever.
  void turnsTheHandByItsLever() {
    const TwoBalls robot;
    const SerialArm arm = robot.arm();
    const Pose flange = arm.tipPose(TwoBalls::start()), tool(Eigen::Translation3d(40.0, -30.0, 150.0));
    RobotScene scene = robot.scene();
    constexpr double kDistance = 4.0;
    const Vec3 nearest = flange.translation() + Vec3(TwoBalls::kRadius, 0.0, 0.0);
    scene.addObstacle(CollisionBody({CollisionPiece::box(Pose::Identity(), {100.0, 4000.0, 4000.0})}),
                      Pose(Eigen::Translation3d(nearest.x() + kDistance + 50.0, 0.0, 0.0)), 1);
    ApproachForce force(scene, arm, tool, {.reach = 10.0, .stiffness = 0.5, .largestForce = 50.0});
    const ApproachForce::Felt felt = force.at(TwoBalls::start());
    const Vec3 expected(-0.5 * (10.0 - kDistance), 0.0, 0.0);
    const Vec3 torque = (nearest - (flange * tool).translation()).cross(expected);
    QVERIFY((felt.force - expected).norm() < 0.02 * expected.norm());
    QVERIFY((felt.torque - torque).norm() < 0.02 * std::max(torque.norm(), 100.0 * expected.norm()));
    // A smaller torque share: less of its torque.
    ApproachForce weak(scene, arm, tool, {.reach = 10.0, .stiffness = 0.5, .largestForce = 1.0});
    const ApproachForce::Felt less = weak.at(TwoBalls::start());
    const double share = less.force.norm() / felt.force.norm();
    QVERIFY(share < 0.4 && less.force.norm() <= 1.0 + 1e-9);
    QVERIFY((less.torque - share * felt.torque).norm() < 1e-6 * felt.torque.norm());
  }

  // Two balls on the flange, each pushed to the other side: no force, and the torque of the couple.
  void aCoupleOnlyTurns() {
    constexpr double kSide = 100.0, kBall = 10.0, kDistance = 5.0;
    TwoBalls robot;
    robot.model.shapes = {SphereShape{kBall}};
    for (Link& link : robot.model.links) link.collisions.clear();
    for (const double side : {kSide, -kSide})
      robot.model.links.back().collisions.push_back({0, Pose(Eigen::Translation3d(side, 0.0, 0.0)), {}});
    const SerialArm arm = robot.arm();
    const Pose last = linkPoses(robot.model, JointValues(TwoBalls::start())).back();
    const Vec3 u = last.linear().col(1);
    RobotScene scene = robot.scene();
    for (const double side : {1.0, -1.0}) {
      const Vec3 ball = last * Vec3(side * kSide, 0.0, 0.0);
      addBall(scene, ball + side * (2.0 * kBall + kDistance) * u, kBall, side > 0.0 ? 1 : 2);
    }
    const Pose tip = arm.tipPose(TwoBalls::start());
    for (const Vec3& at : {Vec3(0, 0, 0), Vec3(30, 50, 100)}) {  // for any tool
      ApproachForce force(scene, arm, Pose(Eigen::Translation3d(at)),
                          {.reach = 10.0, .stiffness = 0.5, .largestForce = 50.0});
      const ApproachForce::Felt felt = force.at(TwoBalls::start());
      const double push = 0.5 * (10.0 - kDistance);
      const Vec3 torque = -2.0 * kSide * push * Vec3(last.linear().col(2));
      QVERIFY(felt.force.norm() < 0.02 * push);
      QVERIFY((felt.torque - torque).norm() < 0.02 * torque.norm());
    }
    QVERIFY((tip.translation() - last.translation()).norm() < 1e-6);
  }

  // An obstacle near the elbow alone is felt at the tool, too: the work of the hand over a small displacement, with a
  // fixed orientation of the tool, equals the change of the energy.
  void ofAnElbow() {
    const TwoBalls robot;
    const SerialArm arm = robot.arm();
    const ArmValues start = TwoBalls::start();
    RobotScene scene = robot.scene();
    const Pose tip = arm.tipPose(start);
    // The ball of the elbow is where the third link is.
    const Vec3 ball = linkPoses(robot.model, JointValues(start))[3].translation();
    addBall(scene, ball + Vec3(20.0, 15.0, 55.0), 20.0, 1);
    ApproachForce force(scene, arm, Pose::Identity(), {.reach = 15.0, .stiffness = 0.8, .largestForce = 1e3});
    const ApproachForce::Felt felt = force.at(start);
    QVERIFY(felt.distance < 14.0 && felt.energy > 0.0);
    const auto ik = ClosedFormIk::of(arm);
    QVERIFY(ik.has_value());
    const auto energyAt = [&](const Vec3& away) {
      IkSolutions solutions;
      ik->solve(Pose(Eigen::Translation3d(away) * tip), start, solutions);
      double least = 1e9, energy = 0.0;
      for (const IkSolutions::Solution& each : solutions) {
        ArmValues values(6);
        double off = 0.0;
        for (Eigen::Index i = 0; i < 6; ++i) {
          values[i] = start[i] + std::remainder(each.values[static_cast<std::size_t>(i)] - start[i], 2.0 * M_PI);
          off += std::abs(values[i] - start[i]);
        }
        if (off < least) {
          least = off;
          energy = force.at(values).energy;
        }
      }
      return energy;
    };
    constexpr double kStep = 0.01;  // mm
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 away = kStep * Vec3::Unit(axis);
      const double expected = -(energyAt(away) - energyAt(-away)) / (2.0 * kStep);
      QVERIFY2(std::abs(felt.force[axis] - expected) < 1e-3 * std::max(1.0, felt.force.norm()),
               qPrintable(QString("%1: %2, not %3").arg(axis).arg(felt.force[axis]).arg(expected)));
    }
  }

  // Stretched out and deep inside, the force is within its bound, and finite.
  void isBounded() {
    const TwoBalls robot;
    const SerialArm arm = robot.arm();
    RobotScene scene = robot.scene();
    addBall(scene, Vec3(0.0, 0.0, 500.0), 600.0, 1);
    ApproachForce force(scene, arm, Pose::Identity(), {.largestForce = 7.0});
    for (const double value : {0.0, 1e-9, 0.5, M_PI / 2.0}) {
      const Vec3 felt = force.at(ArmValues::Constant(6, value)).force;
      QVERIFY(felt.allFinite() && felt.norm() <= 7.0 + 1e-9);
    }
  }
};

HANDWHEEL_TEST(ApproachForceTest)
#include "ApproachForceTest.moc"
