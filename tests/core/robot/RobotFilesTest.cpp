// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/Kinematics.h"
#include "robot/MeshLocation.h"
#include "robot/PointPull.h"
#include "robot/UrdfReader.h"

#include <urdf_parser/urdf_parser.h>

#include <QDirIterator>
#include <QRegularExpression>
#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

using namespace handwheel;

// Descriptions of real robots. They are not part of the sources: the folder named by HANDWHEEL_DATA holds them under
// "robots". Expectations come from counting tags, from another reader, and from what the makers publish.
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

QString robotsFolder() {
  return qEnvironmentVariable("HANDWHEEL_DATA") + "/robots";
}

QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

RobotModel robotIn(const char* path) {
  Result<ReadRobot> read = readUrdf(bytesOf(robotsFolder() + '/' + path).toStdString());
  return read ? read->robot : RobotModel{};
}

int countOf(const QString& text, const char* pattern) {
  int count = 0;
  for (auto i = QRegularExpression(pattern).globalMatch(text); i.hasNext(); i.next()) ++count;
  return count;
}

JointKind kindOf(const urdf::Joint& joint) {
  switch (joint.type) {
    case urdf::Joint::REVOLUTE:
      return JointKind::Revolute;
    case urdf::Joint::CONTINUOUS:
      return JointKind::Continuous;
    case urdf::Joint::PRISMATIC:
      return JointKind::Prismatic;
    default:
      return JointKind::Fixed;
  }
}

Pose poseOf(const urdf::Pose& pose) {
  Pose result = Pose::Identity();
  result.translation() = 1000.0 * Vec3(pose.position.x, pose.position.y, pose.position.z);
  const auto& q = pose.rotation;
  result.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
  return result;
}

double unknownAsZero(const std::optional<double>& value) {
  return value.value_or(0.0);
}

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

const char* const kIrb120 = "abb_irb120/abb_irb120_support/urdf/irb120_3_58.urdf";
const char* const kIrb2400 = "abb_irb2400/abb_irb2400_support/urdf/irb2400.urdf";
const char* const kLrMate = "fanuc_lrmate200id/fanuc_lrmate200id_support/urdf/lrmate200id.urdf";
const char* const kAgilus = "kuka_kr6r900_2/kuka_kr6_support/urdf/kr6r900_2.urdf";
const char* const kPanda = "panda/panda.urdf";
const char* const kUr5 = "ur5/ur_description/urdf/ur5.urdf";
const char* const kPuma = "puma560/puma560_description/urdf/puma560_robot.urdf";

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

class RobotFilesTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void filesAreAsAnotherReaderSaysThem_data();
  void filesAreAsAnotherReaderSaysThem();
  void meshesAreFound_data() { filesAreAsAnotherReaderSaysThem_data(); }
  void meshesAreFound();
  void denavitHartenbergTables();
  void tools();
  void unknownEffort();
  void reach();
};

void RobotFilesTest::initTestCase() {
  if (qEnvironmentVariableIsEmpty("HANDWHEEL_DATA")) QSKIP("HANDWHEEL_DATA is not set: real robots are left out");
}

void RobotFilesTest::filesAreAsAnotherReaderSaysThem_data() {
  QTest::addColumn<QString>("path");
  QDirIterator files(robotsFolder(), {"*.urdf"}, QDir::Files, QDirIterator::Subdirectories);
  while (files.hasNext()) {
    const QString path = files.next();
    QTest::newRow(qPrintable(files.fileName())) << path;
  }
}

void RobotFilesTest::filesAreAsAnotherReaderSaysThem() {
  QFETCH(QString, path);
  const QByteArray bytes = bytesOf(path);
  const auto read = readUrdf(bytes.toStdString());
  QVERIFY(read.hasValue());
  QVERIFY(read->damage.empty());
  const RobotModel& robot = read->robot;

  const QString tags =
      QString(bytes).remove(QRegularExpression("<!--.*?-->", QRegularExpression::DotMatchesEverythingOption));
  QCOMPARE(int(robot.links.size()), countOf(tags, "<link\\s"));
  QCOMPARE(int(robot.joints.size()), countOf(tags, "<joint\\s[^>]*\\btype="));
  QCOMPARE(int(robot.dofs.size()), countOf(tags, "<joint\\s[^>]*\\btype=\"(revolute|continuous|prismatic)\""));

  const auto other = urdf::parseURDF(bytes.toStdString());
  QVERIFY(other != nullptr);
  QCOMPARE(robot.links[robot.root].name, other->getRoot()->name);
  QCOMPARE(robot.links.size(), other->links_.size());
  for (const Link& link : robot.links) {
    QCOMPARE(link.visuals.size(), other->getLink(link.name)->visual_array.size());
    QCOMPARE(link.collisions.size(), other->getLink(link.name)->collision_array.size());
  }
  for (const Joint& joint : robot.joints) {
    const auto expected = other->getJoint(joint.name);
    QVERIFY(expected != nullptr);
    QCOMPARE(joint.kind, kindOf(*expected));
    QCOMPARE(robot.links[joint.parent].name, expected->parent_link_name);
    QCOMPARE(robot.links[joint.child].name, expected->child_link_name);
    QVERIFY(joint.origin.isApprox(poseOf(expected->parent_to_joint_origin_transform), 1e-12));
    if (joint.kind == JointKind::Fixed) continue;
    QVERIFY(joint.axis.isApprox(Vec3(expected->axis.x, expected->axis.y, expected->axis.z).normalized(), 1e-15));
    QCOMPARE(joint.limits.lower, expected->limits->lower);
    QCOMPARE(joint.limits.upper, expected->limits->upper);
    QCOMPARE(unknownAsZero(joint.limits.velocity), expected->limits->velocity);
    QCOMPARE(unknownAsZero(joint.limits.effort), expected->limits->effort);
  }
}

void RobotFilesTest::meshesAreFound() {
  QFETCH(QString, path);
  const auto read = readUrdf(bytesOf(path).toStdString());
  QVERIFY(read.hasValue());
  int meshes = 0;
  for (const Shape& shape : read->robot.shapes) {
    if (!std::holds_alternative<MeshShape>(shape)) continue;
    ++meshes;
    const auto found = locateMesh(std::get<MeshShape>(shape).file, QFileInfo(path).path().toStdString());
    QVERIFY2(found.hasValue(), std::get<MeshShape>(shape).file.c_str());
  }
  QVERIFY(meshes > 0);
}

void RobotFilesTest::denavitHartenbergTables() {
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
      // Right angles stand in the files with ten digits.
      QVERIFY2((found.translation() - expected.translation()).norm() < 1e-6, table.file);
      QVERIFY2((found.linear() - expected.linear()).norm() < 1e-8, table.file);
    }
  }
}

void RobotFilesTest::tools() {
  for (const auto& [file, tool] : {std::pair{kIrb120, "tool0"},
                                   {kIrb2400, "tool0"},
                                   {kLrMate, "tool0"},
                                   {kAgilus, "tool0"},
                                   {kUr5, "tool0"},
                                   {kPuma, "link7"},
                                   {kPanda, "panda_grasptarget"}}) {
    const RobotModel robot = robotIn(file);
    QCOMPARE(robot.links[toolLink(robot)].name, std::string(tool));
  }
}

void RobotFilesTest::unknownEffort() {
  for (const char* file : {kIrb120, kIrb2400, kLrMate, kAgilus}) {
    const RobotModel robot = robotIn(file);
    for (std::size_t i = 0; i < robot.dofs.size(); ++i) {
      QVERIFY(!robot.jointOfDof(i).limits.effort);
      QVERIFY(robot.jointOfDof(i).limits.velocity > 1.0);
    }
  }
  QCOMPARE(robotIn(kUr5).jointOfDof(0).limits.effort, std::optional(150.0));
  QVERIFY(!robotIn(kPuma).jointOfDof(0).limits.velocity);
}

// How far the wrist gets from the first axis, found by pulling it aside: what the makers print.
void RobotFilesTest::reach() {
  const std::tuple<const char*, const char*, double, double> kReaches[] = {
      {kIrb120, "link_5", 580.0, 0.5},  // mm, and how far it may differ
      {kIrb2400, "link_5", 1550.0, 30.0},
      {kLrMate, "link_5", 717.0, 0.5},
      {kAgilus, "link_5", 901.0, 0.5},
  };
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(-1.0, 1.0);
  for (const auto& [file, wrist, expected, tolerance] : kReaches) {
    const RobotModel robot = robotIn(file);
    const PointPull pull{linkNamed(robot, wrist), Vec3::Zero(), Vec3(1e9, 0, 0)};
    double furthest = 0.0;
    for (int i = 0; i < 20; ++i) {
      JointValues start(Eigen::Index(robot.dofs.size()));
      for (double& v : start) v = angle(random);
      furthest = std::max(furthest, linkPoses(robot, pulled(robot, start, pull, 300))[pull.link].translation().x());
    }
    QVERIFY2(std::abs(furthest - expected) < tolerance, qPrintable(QString("%1: %2 mm").arg(file).arg(furthest)));
  }
}

QTEST_GUILESS_MAIN(RobotFilesTest)
#include "RobotFilesTest.moc"
