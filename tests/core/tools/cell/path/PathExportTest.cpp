// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/PathExport.h"

#include "../ArmCell.h"
#include "TestClass.h"
#include "document/DocumentErrors.h"
#include "document/cell/CellErrors.h"
#include "robot/posts/PostErrors.h"
#include "robot/program/PathFile.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// The language of a controller that reads these motions, whatever was written.
class ForgetfulPost : public PostProcessor {
 public:
  explicit ForgetfulPost(std::vector<ParsedMotion> motions) : m_motions(std::move(motions)) {}
  const char* id() const override { return "forgetful"; }
  const char* title() const override { return "Forgetful"; }
  const char* ending() const override { return ".forgetful"; }
  std::string write(const RobotProgram&) const override { return "anything"; }
  Result<std::vector<ParsedMotion>> read(std::string_view, const RobotProgram&) const override { return m_motions; }

 private:
  std::vector<ParsedMotion> m_motions;
};

Waypoint exportedWaypoint(std::initializer_list<double> list, ProgramMotion::Kind motion = ProgramMotion::Kind::Joint) {
  Waypoint waypoint{.joints = JointValues(static_cast<Eigen::Index>(list.size())), .motion = motion};
  std::copy(list.begin(), list.end(), waypoint.joints.begin());
  if (motion == ProgramMotion::Kind::Linear) waypoint.speed = 100.0;
  return waypoint;
}

// A joint motion, and a line of 15 mm.
RobotPath seam() {
  return {"seam",
          {exportedWaypoint({0.0, 0.3, 0.1, 0.0, 0.8, 0.0}), exportedWaypoint({0.4, 0.3, 0.1, 0.0, 0.8, 0.0}),
           exportedWaypoint({0.43, 0.3, 0.1, 0.0, 0.8, 0.0}, ProgramMotion::Kind::Linear)}};
}

}  // namespace

// Paths are written as programs of controllers only where they are proven free, and come back from these.
class PathExportTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { m_cell = std::make_unique<ArmCell>(); }

  void writtenAndOpened_data() {
    QTest::addColumn<QByteArray>("post");
    for (const char* post : {"rapid", "krl", "fanuc", "urscript", "csv", "json"})
      QTest::newRow(post) << QByteArray(post);
  }
  void writtenAndOpened() {
    QFETCH(const QByteArray, post);
    const PostProcessor& language = *postCalled(post.constData());
    const QString name = file(QString("seam") + language.ending());
    const auto written = writtenBy(language, seam(), name);
    QVERIFY2(written.hasValue(), written ? "" : written.error().code->id);
    QCOMPARE(written->check.motions, std::size_t{3});
    QVERIFY(written->check.distance <= 1e-3 && written->check.angle <= 1e-3);
    // Among the controllers for robots of one maker only ABB's are for this robot.
    const bool isForOthers = *language.maker() && post != "rapid";
    QCOMPARE(QString::fromStdString(written->otherRobot), isForOthers ? "ABB IRB 120-3/0.6" : "");
    QCOMPARE(textIn(name).contains("Warning: this is"), isForOthers);
    const auto read = pathFromFile(*m_cell->scene(), m_cell->content(), name.toStdString());
    QVERIFY2(read.hasValue(), read ? "" : read.error().code->id);
    QCOMPARE(read->path.waypoints.size(), std::size_t{3});
    for (std::size_t i = 0; i < 3; ++i) {
      QVERIFY((read->path.waypoints[i].joints - seam().waypoints[i].joints).cwiseAbs().maxCoeff() < 1e-4);
      QVERIFY(read->path.waypoints[i].motion == seam().waypoints[i].motion);
    }
  }

  // A collision is named: of how many, and between what. Nothing is written.
  void collides() {
    m_cell->addBox({100, 100, 800}, {400, 80, 400});
    const CheckedPath met = checked(seam());
    QVERIFY(!met.isCertified() && !met.verification.collisions.empty());
    const Error error = refusal(seam(), met);
    QVERIFY(error.code == CellError::PathCollides);
    QCOMPARE(error.arguments.size(), std::size_t{4});
    QCOMPARE(error.arguments[0], std::string("seam"));
    QCOMPARE(error.arguments[1], std::to_string(met.verification.collisions.size()));
    QCOMPARE(error.arguments[3], std::string("box1"));
  }

  // A line right through the robot's first axis ends somewhere along its length.
  void cannotBeFollowed() {
    RobotPath path = seam();
    path.waypoints.back() = exportedWaypoint({0.4 - M_PI, 0.3, 0.1, 0.0, 0.8, 0.0}, ProgramMotion::Kind::Linear);
    const CheckedPath stopped = checked(path);
    QVERIFY(stopped.resolved.stopsAt && *stopped.resolved.stopsAt == 2);
    const Error error = refusal(path, stopped);
    QVERIFY(error.code == CellError::LineUnreachable);
    QCOMPARE(error.arguments[0], std::string("3"));
    const double percent = std::stod(error.arguments[1]);
    QVERIFY(percent > 0.0 && percent < 100.0);
  }

  // An outdated path is refused, or written with a remark on request.
  void outdated() {
    const struct {
      OutdatedReasons outdated;
      const ErrorDescription& code;
      std::vector<std::string> arguments;
      const char* remark;
    } all[] = {
        {{.part = "block"}, CellError::PathOutdated, {"seam", "block"}, "# Outdated: the part block has moved"},
        {{.isBaseOther = true}, CellError::PathBaseMoved, {"seam"}, "# Outdated: the base of the robot has moved"},
        {{.isToolOther = true}, CellError::PathToolChanged, {"seam"}, "# Outdated: the tool centre point was changed"},
        {{.targets = {"b", "c"}}, CellError::PathTargetMoved, {"seam", "b"}, "# Outdated: the tool does not come to"},
        {{.frames = {"jig"}},
         CellError::PathFrameMoved,
         {"seam", "jig"},
         "# Outdated: the frame jig, or the tool, has"},
        {{.configurations = {"home"}},
         CellError::PathWaypointChanged,
         {"seam", "home"},
         "# Outdated: home was changed"}};
    for (const auto& each : all) {
      CheckedPath known = checked(seam());
      known.outdated = each.outdated;
      const Error error = refusal(seam(), known);
      QVERIFY(error.code == each.code);
      QCOMPARE(error.arguments, each.arguments);
      const QString name = file("seam.csv");
      QVERIFY(writtenBy(*postCalled("csv"), seam(), name, known, OutdatedPath::Write).hasValue());
      QVERIFY2(textIn(name).contains(each.remark), each.remark);
    }
  }

  // Motions that the controller cannot do, and a program that does not read back as the path.
  void programsThatDoNotFit() {
    RobotPath fast = seam();
    fast.waypoints.back().speed = 9e3;
    QVERIFY(refusal(fast, checked(fast), postCalled("rapid")).code == PostError::TooFast);
    std::vector<ParsedMotion> motions;
    for (const Waypoint& waypoint : seam().waypoints)
      motions.push_back({.kind = waypoint.motion, .joints = waypoint.joints});
    const ForgetfulPost right(motions);
    QVERIFY(writtenBy(right, seam(), file("right")).hasValue());
    motions[1].joints = *motions[1].joints + ArmValues::Constant(6, 1e-4);  // some hundredths of a millimetre
    const ForgetfulPost wrong(motions);
    QVERIFY(refusal(seam(), checked(seam()), &wrong).code == DocumentError::CheckFailed);
    const ForgetfulPost shorter({motions.front()});
    const Error lost = refusal(seam(), checked(seam()), &shorter);
    QVERIFY(lost.code == ErrorCode::CountMismatch);
    QCOMPARE(lost.arguments, (std::vector<std::string>{"motions", "3", "1"}));
    QVERIFY(writtenBy(right, seam(), file("no folder/seam")).error().code == ErrorCode::WriteFailed);
  }

  // Lines are relative to the chosen frame; joint motions are not, but tables have the pose of each waypoint.
  void frames() {
    CellPlans plans;
    plans.frames = {{"jig", poseOf({300, 100, 0}, {0.0, 0.0, 0.5})}, {"other", Pose::Identity()}};
    plans.workFrame = "jig";
    plans.paths = {seam(), {.name = "other", .waypoints = {}}};
    m_cell->plan(plans);
    RobotPath plain = seam();
    plain.waypoints.pop_back();
    const auto frameOf = [&](const char* post, const RobotPath& path) {
      const auto written = writtenBy(*postCalled(post), path, file("frames"));
      return written ? written->frame : std::string("not written");
    };
    QCOMPARE(frameOf("rapid", seam()), std::string("jig"));
    QCOMPARE(frameOf("rapid", plain), std::string());
    QCOMPARE(frameOf("csv", plain), std::string("jig"));
    plans.workFrame = "gone";
    m_cell->plan(plans);
    QVERIFY(refusal(seam(), checked(seam())).code == CellError::FrameMissing);
  }

  // Motions that no program of this robot can have, with the line they are in.
  void motionsThatCannotBe() {
    const ParsedMotion start{.joints = seam().waypoints[0].joints, .line = 3};
    ParsedMotion bad{.joints = ArmValues::Zero(5), .line = 7};
    const auto errorOf = [&](const ParsedMotion& motion) {
      const auto read = opened({start, motion});
      return read ? Error{} : read.error();
    };
    QVERIFY(errorOf(bad).code == ErrorCode::ElementMalformed);
    QCOMPARE(errorOf(bad).position.value, std::uint64_t{7});
    bad.joints = ArmValues::Constant(6, std::nan(""));
    QVERIFY(errorOf(bad).code == ErrorCode::ElementMalformed);
    bad.joints = ArmValues::Constant(6, 2.5);  // joint 2 ends at 110 degrees
    QVERIFY(errorOf(bad).code == ErrorCode::ValueOutOfRange);
    bad.joints.reset();
    QVERIFY(errorOf(bad).code == ErrorCode::ElementMalformed);
    bad.pose = poseOf({5000.0, 0.0, 300.0}, Vec3::Zero());
    QVERIFY(errorOf(bad).code == CellError::PoseUnreachable);
    QCOMPARE(errorOf(bad).arguments, std::vector<std::string>{"2"});
    QCOMPARE(errorOf(bad).position.value, std::uint64_t{7});
    JobState state;
    state.cancelled = true;
    QVERIFY(opened({start}, Progress(state)).error().code == ErrorCode::Cancelled);
  }

  // A program is of this robot, whatever was known of it; its first motion is none of a line.
  void whatIsMadeOfMotions() {
    ParsedMotion line{
        .kind = ProgramMotion::Kind::Linear, .joints = seam().waypoints[0].joints, .blend = -3.0, .line = 1};
    line.name = "first\nplace";  // no name that a cell can have
    const auto read = opened({line, line});
    QVERIFY(read && read->path.waypoints.size() == 2);
    QVERIFY(read->path.waypoints[0].motion == ProgramMotion::Kind::Joint);
    QVERIFY(read->path.waypoints[1].motion == ProgramMotion::Kind::Linear);
    QCOMPARE(read->path.waypoints[1].speed, 250.0);
    QCOMPARE(read->path.waypoints[1].blend, 0.0);
    QVERIFY(read->path.waypoints[0].name.empty());
  }

  // A path file, for a robot of another name; errors tell the file.
  void pathFiles() {
    RobotPath path = seam();
    path.arm = "somebody else's";
    const QString name = file("seam.path");
    QFile output(name);
    QVERIFY(output.open(QIODevice::WriteOnly));
    output.write(QByteArray::fromStdString(toJson(m_cell->document().robot().model, path).dump()));
    output.close();
    const auto read = pathFromFile(*m_cell->scene(), m_cell->content(), name.toStdString());
    QVERIFY2(read.hasValue(), read ? "" : read.error().code->id);
    QVERIFY(read->path.waypoints == path.waypoints && read->path.arm == m_cell->content().plans->arm);
    for (const char* const missing : {"none.path", "none.mod"}) {
      const auto none = pathFromFile(*m_cell->scene(), m_cell->content(), file(missing).toStdString());
      QVERIFY(!none && none.error().code == ErrorCode::FileMissing);
      QCOMPARE(none.error().subject, file(missing).toStdString());
    }
    QVERIFY(output.open(QIODevice::WriteOnly | QIODevice::Truncate));
    output.write("no path");
    output.close();
    const auto broken = pathFromFile(*m_cell->scene(), m_cell->content(), name.toStdString());
    QVERIFY(!broken && broken.error().subject == name.toStdString());
  }

 private:
  QString file(const QString& name) const { return m_folder.filePath(name); }
  static QByteArray textIn(const QString& name) {
    QFile input(name);
    return input.open(QIODevice::ReadOnly) ? input.readAll() : QByteArray();
  }
  CheckedPath checked(const RobotPath& path) {
    auto known = checkPath(*m_cell->scene(), *m_cell->content().plans, path, {});
    if (!known) qFatal("not checked: %s", known.error().code->id);
    return std::move(known).value();
  }
  Result<WrittenProgram> writtenBy(const PostProcessor& post, const RobotPath& path, const QString& name) {
    return writtenBy(post, path, name, checked(path), OutdatedPath::Refuse);
  }
  Result<WrittenProgram> writtenBy(const PostProcessor& post, const RobotPath& path, const QString& name,
                                   const CheckedPath& known, OutdatedPath outdated) {
    return writeProgram(*m_cell->scene(), *m_cell->content().plans, path, known, post, name.toStdString(),
                        {.outdated = outdated});
  }
  // Returns the reason why a path is not written; then there is no file.
  Error refusal(const RobotPath& path, const CheckedPath& known, const PostProcessor* post = postCalled("csv")) {
    const auto written = writtenBy(*post, path, file("refused"), known, OutdatedPath::Refuse);
    return written || QFile::exists(file("refused")) ? Error{} : written.error();
  }
  Result<ProgramPath> opened(const std::vector<ParsedMotion>& motions, Progress progress = {}) {
    return pathFromProgram(*m_cell->scene(), m_cell->content(), ForgetfulPost(motions), "", progress);
  }

  QTemporaryDir m_folder;
  std::unique_ptr<ArmCell> m_cell;
};

HANDWHEEL_TEST(PathExportTest)
#include "PathExportTest.moc"
