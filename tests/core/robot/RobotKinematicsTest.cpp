// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RobotFiles.h"
#include "TestClass.h"
#include "robot/Kinematics.h"
#include "robot/PointTarget.h"

#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// Denavit and Hartenberg's table, one row a joint: millimetres, degrees. The joint's angle is sign · value + offset.
struct Row {
  double sign, offset, d, a, alpha;
};
struct Table {
  const char* file;
  const char* base;
  const char* tip;
  bool craig;  // the row's a and alpha come before its joint, as in Craig's book, not after it
  std::vector<Row> rows;
};

Pose poseOf(const Table& table, const JointValues& q) {
  Pose pose = Pose::Identity();
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Row& r = table.rows[i];
    const double angle = i < std::size_t(q.size()) ? r.sign * q[Eigen::Index(i)] + r.offset * kDegree : 0.0;
    Pose turn = Pose::Identity(), lean = Pose::Identity();
    turn.rotate(Eigen::AngleAxisd(angle, Vec3::UnitZ())).translate(Vec3(0, 0, r.d));
    lean.translate(Vec3(r.a, 0, 0)).rotate(Eigen::AngleAxisd(r.alpha * kDegree, Vec3::UnitX()));
    pose = table.craig ? pose * lean * turn : pose * turn * lean;
  }
  return pose;
}

const Table kTables[] = {
    {kIrb120,
     "base_link",
     "tool0",
     false,
     {{1, 0, 290, 0, -90},
      {1, -90, 0, 270, 0},
      {1, 0, 0, 70, -90},
      {1, 0, 302, 0, 90},
      {1, 0, 0, 0, -90},
      {1, 180, 72, 0, 0}}},
    {kIrb2400,
     "base_link",
     "tool0",
     false,
     {{1, 0, 615, 100, -90},
      {1, -90, 0, 705, 0},
      {1, 0, 0, 135, -90},
      {1, 0, 755, 0, 90},
      {1, 0, 0, 0, -90},
      {1, 180, 85, 0, 0}}},
    {kAgilus,
     "base_link",
     "tool0",
     false,
     {{-1, 0, 400, 25, -90},
      {1, 0, 0, 455, 0},
      {1, -90, 0, 25, -90},
      {-1, 0, 420, 0, 90},
      {1, 0, 0, 0, -90},
      {-1, 180, 90, 0, 0}}},
    {kLrMate,
     "base_link",
     "tool0",
     false,
     {{1, 0, 330, 50, -90},
      {1, -90, 0, 330, 0},
      {-1, 0, 0, 35, -90},
      {-1, 0, 335, 0, 90},
      {-1, 0, 0, 0, -90},
      {-1, 0, 80, 0, 0}}},
    {kUr5,
     "base",
     "tool0",
     false,
     {{1, 0, 89.159, 0, 90},
      {1, 0, 0, -425, 0},
      {1, 0, 0, -392.25, 0},
      {1, 0, 109.15, 0, 90},
      {1, 0, 94.65, 0, -90},
      {1, 0, 82.3, 0, 0}}},
    {kPanda,
     "panda_link0",
     "panda_link8",
     true,
     {{1, 0, 333, 0, 0},
      {1, 0, 0, 0, -90},
      {1, 0, 316, 0, 90},
      {1, 0, 0, 82.5, 90},
      {1, 0, 384, -82.5, -90},
      {1, 0, 0, 0, 90},
      {1, 0, 0, 88, 90},
      {0, 0, 107, 0, 0}}},
};

}  // namespace

class RobotKinematicsTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void denavitHartenbergTables();
  void reach();
};

void RobotKinematicsTest::initTestCase() {
  if (qEnvironmentVariableIsEmpty("HANDWHEEL_DATA")) QSKIP("HANDWHEEL_DATA is not set: real robots are left out");
}

void RobotKinematicsTest::denavitHartenbergTables() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
  for (const Table& table : kTables) {
    const RobotModel robot = robotIn(table.file);
    QVERIFY(!robot.links.empty());
    const std::uint32_t base = linkNamed(robot, table.base), tip = linkNamed(robot, table.tip);
    QVERIFY(base != kNone && tip != kNone);
    for (int i = 0; i < 200; ++i) {
      JointValues q(Eigen::Index(robot.dofs.size()));
      for (double& v : q) v = angle(random);
      const std::vector<Pose> poses = linkPoses(robot, q);
      const Pose found = poses[base].inverse() * poses[tip], expected = poseOf(table, q);
      // Right angles have ten digits in the files.
      QVERIFY2((found.translation() - expected.translation()).norm() < 1e-6, table.file);
      QVERIFY2((found.linear() - expected.linear()).norm() < 1e-8, table.file);
    }
  }
}

// The reach of the wrist from the first axis, found by pulling it aside: the figure of the makers.
void RobotKinematicsTest::reach() {
  const std::tuple<const char*, const char*, double, double> kReaches[] = {
      {kIrb120, "link_5", 580.0, 0.5},  // mm, and the tolerance
      {kIrb2400, "link_5", 1550.0, 30.0},
      {kLrMate, "link_5", 717.0, 0.5},
      {kAgilus, "link_5", 901.0, 0.5},
  };
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(-1.0, 1.0);
  for (const auto& [file, wrist, expected, tolerance] : kReaches) {
    const RobotModel robot = robotIn(file);
    const PointTarget pull{linkNamed(robot, wrist), Vec3::Zero(), Vec3(1e9, 0, 0)};
    double furthest = 0.0;
    for (int i = 0; i < 20; ++i) {
      JointValues start(Eigen::Index(robot.dofs.size()));
      for (double& v : start) v = angle(random);
      furthest = std::max(furthest, linkPoses(robot, pulled(robot, start, pull, 300))[pull.link].translation().x());
    }
    QVERIFY2(std::abs(furthest - expected) < tolerance, qPrintable(QString("%1: %2 mm").arg(file).arg(furthest)));
  }
}

HANDWHEEL_TEST(RobotKinematicsTest)
#include "RobotKinematicsTest.moc"
