// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RobotFiles.h"
#include "TestClass.h"
#include "robot/MeshLocation.h"

#include <urdf_parser/urdf_parser.h>

#include <QDirIterator>
#include <QRegularExpression>
#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

// Expectations come from counting tags and from another reader.
namespace {

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

}  // namespace

class RobotFilesTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void filesAreAsAnotherReaderSaysThem_data();
  void filesAreAsAnotherReaderSaysThem();
  void meshesAreFound_data() { filesAreAsAnotherReaderSaysThem_data(); }
  void meshesAreFound();
  void tools();
  void unknownEffort();
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

HANDWHEEL_TEST(RobotFilesTest)
#include "RobotFilesTest.moc"
