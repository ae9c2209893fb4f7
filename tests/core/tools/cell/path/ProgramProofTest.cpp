// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/PathGaps.h"

#include "../ArmCell.h"
#include "TestClass.h"
#include "document/cell/CellErrors.h"
#include "document/cell/WaypointProperties.h"
#include "robot/arm/NumericalIk.h"
#include "robot/posts/PostErrors.h"
#include "tools/cell/path/PathExport.h"
#include "tools/cell/path/ProgramChoices.h"
#include "tools/cell/path/WaitingTime.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

Waypoint proofWaypoint(std::initializer_list<double> list, ProgramMotion::Kind motion = ProgramMotion::Kind::Joint) {
  Waypoint waypoint{.joints = JointValues(static_cast<Eigen::Index>(list.size())), .motion = motion};
  std::copy(list.begin(), list.end(), waypoint.joints.begin());
  if (motion == ProgramMotion::Kind::Linear) waypoint.speed = 100.0;
  return waypoint;
}

// Joint 1 turns by 1 rad, then joint 2 by 0.7 rad.
RobotPath cornerPath(double corner) {
  RobotPath path{"corner",
                 {proofWaypoint({0.0, 0.0, 0.0, 0.0, 0.5, 0.0}), proofWaypoint({1.0, 0.0, 0.0, 0.0, 0.5, 0.0}),
                  proofWaypoint({1.0, 0.7, 0.0, 0.0, 0.5, 0.0})}};
  path.waypoints[1].corner = corner;
  return path;
}

}  // namespace

// Tests what is proven of paths that programs of controllers describe.
class ProgramProofTest : public QObject {
  Q_OBJECT

  Vec3 flangeAt(const Waypoint& waypoint) {
    return m_cell->scene()->arm.tipPose(m_cell->scene()->planned(waypoint.joints)).translation();
  }
  // Two lines of 120 mm at a right angle, along y and then along z.
  RobotPath linesPath() {
    RobotPath path{"lines", {proofWaypoint({0.0, 0.3, 0.1, 0.0, 0.8, 0.0})}};
    const auto scene = m_cell->scene();
    const Pose start = scene->arm.tipPose(scene->planned(path.waypoints[0].joints));
    for (const Vec3& by : {Vec3(0, 120, 0), Vec3(0, 120, 120)}) {
      Pose tip = start;
      tip.translation() += by;
      const auto found = solvedNumerically(scene->arm, tip, scene->planned(path.waypoints.back().joints), {});
      if (!found.isSolved) qFatal("out of reach");
      path.waypoints.push_back(
          {.joints = scene->whole(found.values), .motion = ProgramMotion::Kind::Linear, .speed = 100.0});
    }
    return path;
  }

 private slots:
  void init() { m_cell = std::make_unique<ArmCell>(); }

  // A box stands where the arm is in the middle between both ends of the path, more than 100 mm from the path itself:
  // the sharp corner is free, the rounded one is not.
  void roundedCorners() {
    QVERIFY(checked(cornerPath(100.0)).isCertified());  // nothing is near
    const auto scene = m_cell->scene();
    const Vec3 within =
        scene->arm.tipPose(scene->planned(proofWaypoint({0.5, 0.35, 0.0, 0.0, 0.5, 0.0}).joints)).translation();
    m_cell->addBox({40, 40, 40}, within);
    QVERIFY(checked(cornerPath(0.0)).isCertified());
    const CheckedPath met = checked(cornerPath(100.0));
    QVERIFY(!met.isCertified() && met.verification.isCertified());
    QCOMPARE(met.gaps, std::vector<ProofGap>{{.waypoint = 1}});
    QVERIFY(errorOf(cornerPath(100.0), "fanuc").code == CellError::CornerNotProven);
    // At the ends of the path there is no corner: a program stops at the first place, and says so.
    RobotPath ends = cornerPath(0.0);
    ends.waypoints[0].corner = ends.waypoints[2].corner = 100.0;
    QVERIFY(checked(ends).isCertified());
    const QByteArray text = writtenText(ends, "fanuc");
    QVERIFY2(text.contains("P[1] 25% FINE") && text.contains("Exact stop at the first"), text);
    QVERIFY(checked(chosen(cornerPath(100.0), {.cornersAsStops = true})).isCertified());
  }

  // Two lines at a right angle of 120 mm each: a ball of 10 mm in the middle of their triangle, 40 mm from both.
  void roundedCornersOfLines() {
    RobotPath path = linesPath();
    for (Waypoint& waypoint : path.waypoints) waypoint.corner = 50.0;
    QVERIFY(checked(path).isCertified());
    // Beyond the flange, so that only the tool's side of the arm comes near.
    m_cell->addBox({4, 4, 4}, flangeAt(path.waypoints[0]) + Vec3(0, 60, 60));
    CheckedPath met = checked(path);
    QVERIFY(!met.gaps.empty());
    QVERIFY(met.gaps.front().kind == ProofGap::Kind::Corner);
  }

  // Fanuc's writer keeps the rounding that is proven; other languages refuse it.
  void writtenRounding() {
    QVERIFY(errorOf(cornerPath(100.0), "rapid").code == PostError::NoCorners);
    QVERIFY(writtenText(cornerPath(100.0), "fanuc").contains("CNT100"));
    QVERIFY(writtenText(chosen(cornerPath(100.0), {.cornersAsStops = true}), "rapid").contains("fine"));
  }

  // The proof ends at the first line that may grip, unless a person says that the robot carries the same.
  void gripping() {
    RobotPath path = cornerPath(0.0);
    path.language = "rapid";
    path.waypoints[0].lines = {{.text = "WaitDI di1,1", .line = 8}};
    QVERIFY(checked(path).isCertified());
    path.waypoints[1].lines = {{.text = "Set doGrip", .line = 9, .mayGrip = true}};
    QCOMPARE(checked(path).gaps, (std::vector<ProofGap>{{ProofGap::Kind::Carried, 1, "Set doGrip", 9}}));
    const Error error = errorOf(path, "rapid");
    QVERIFY(error.code == CellError::CarriedUnknown);
    QCOMPARE(error.arguments, (std::vector<std::string>{"corner", "2", "Set doGrip"}));
    const RobotPath same = chosen(path, {.keepsCarried = true});
    QVERIFY(checked(same).isCertified());
    QVERIFY(writtenText(same, "rapid").contains("Set doGrip;\n"));
    const Error refused = errorOf(same, "krl");
    QVERIFY(refused.code == PostError::LinesOfOther);
    QCOMPARE(refused.arguments[3], std::string("8, 9"));
    QVERIFY(!writtenText(chosen(path, {.withoutLines = true}), "krl").contains("doGrip"));
    // Behind the last motion it changes nothing that is proven.
    std::swap(path.waypoints[1].lines, path.waypoints[2].lines);
    QVERIFY(checked(path).isCertified());
  }

  // The zone of a program that was read counts as the controller runs it. It reaches to the middle of both motions. A
  // box stands near the line between these middles in joint space, where only the path itself is free. Written programs
  // have a smaller zone.
  void zonesOfPrograms() {
    RobotPath path = cornerPath(0.0);
    path.waypoints[1].blend = 5000.0;
    const double whole = checked(path).blends[1];
    QVERIFY(whole > 50.0 && checked(path).isCertified());
    bool isFound = false;
    for (double share = 0.25; share < 0.5 && !isFound; share += 0.01) {
      m_cell = std::make_unique<ArmCell>();
      m_cell->addBox({4, 4, 4}, flangeAt(proofWaypoint({1.0 - share, 0.7 * share, 0.0, 0.0, 0.5, 0.0})));
      const CheckedPath found = checked(path);
      isFound = found.verification.isCertified() && found.blends[1] < 0.99 * whole;
    }
    QVERIFY(isFound);
    for (const char* const language : {"", "rapid"}) {
      path.language = language;
      const CheckedPath found = checked(path);
      QVERIFY(found.isProvenAsWritten());
      QCOMPARE(found.isCertified(), path.language.empty());
      QCOMPARE(found.gaps.size(), path.language.empty() ? std::size_t{0} : std::size_t{1});
      if (!found.gaps.empty())
        QVERIFY(found.gaps[0].kind == ProofGap::Kind::Zone && found.gaps[0].waypoint == 1 &&
                found.gaps[0].kept == found.blends[1]);
      QVERIFY(!writtenText(path, "rapid").isEmpty());
    }
  }

  // A line before the first motion may grip, too.
  void grippedAtTheBegin() {
    RobotPath path = cornerPath(0.0);
    path.language = "rapid";
    path.head = {{.text = "Set doGrip", .line = 4, .mayGrip = true}};
    QCOMPARE(checked(path).gaps, (std::vector<ProofGap>{{ProofGap::Kind::Carried, 0, "Set doGrip", 4}}));
    QVERIFY(checked(chosen(path, {.keepsCarried = true})).isCertified());
    const std::vector<Property> fields = waypointProperties(path, 0);
    QVERIFY(fields.size() == 1 && fields[0].id == "path.corner.1.carried");
    CellPlans plans;
    plans.paths = {path};
    const auto field = waypointOfProperty(plans, "path.corner.1.carried");
    QVERIFY(field && !waypointOfProperty(plans, "path.corner.1.speed"));
    QVERIFY(checked(changedWaypoint(plans, *field, true)->paths[0]).isCertified());
  }

  // Lines of a place that is removed stay in the program.
  void linesOfRemovedWaypoints() {
    RobotPath path = cornerPath(0.0);
    path.head = {{.text = "a"}};
    path.waypoints[0].lines = {{.text = "b"}};
    path.waypoints[1].lines = {{.text = "c"}};
    removeWaypoint(path, 1);
    QCOMPARE(path.waypoints[0].lines, (std::vector<ProgramLine>{{.text = "b"}, {.text = "c"}}));
    removeWaypoint(path, 0);
    QCOMPARE(path.head, (std::vector<ProgramLine>{{.text = "a"}, {.text = "b"}, {.text = "c"}}));
    QCOMPARE(path.waypoints.size(), std::size_t{1});
  }

  // The time that the program demands, if the robot is as fast; other motions are not changed.
  void durations() {
    RobotPath path = cornerPath(0.0);
    const double first = checked(path).seconds;
    path.waypoints[2].seconds = 10.0;
    const double usual = first - beginOfLast(path);
    QVERIFY(usual > 0.1 && usual < 5.0);
    QVERIFY(std::abs(checked(path).seconds - (first - usual + 10.0)) < 0.05);
    path.waypoints[2].seconds = 0.01;
    QVERIFY(checked(path).seconds > first - usual + 0.1);
  }

  // Lines of a robot that does not come with the program are places in the frame, so that they move with it.
  void workObjectOfAnyRobot() {
    DhTable table = *libraryTable("irb120");
    table.name = "an arm of our own";
    m_cell = std::make_unique<ArmCell>(table);
    CellPlans plans;
    plans.frames = {{"jig", Pose(Eigen::Translation3d(300, 100, 0))}};
    plans.workFrame = "jig";
    m_cell->plan(plans);
    RobotPath path{"seam",
                   {proofWaypoint({0.4, 0.3, 0.1, 0.0, 0.8, 0.0}),
                    proofWaypoint({0.43, 0.3, 0.1, 0.0, 0.8, 0.0}, ProgramMotion::Kind::Linear)}};
    QByteArray text = writtenText(path, "rapid");
    QVERIFY2(!text.contains("CalcRobT"), text);
    const auto endOf = [&](const QByteArray& program) {
      const auto read =
          pathFromProgram(*m_cell->scene(), m_cell->content(), *postCalled("rapid"), program.toStdString());
      if (!read) qFatal("not read: %s", read.error().code->id);
      return Vec3(
          m_cell->scene()->arm.tipPose(m_cell->scene()->planned(read->path.waypoints.back().joints)).translation());
    };
    const Vec3 before = endOf(text);
    QVERIFY(text.contains("[[300.00000,100.00000,0.00000]"));
    text.replace("[[300.00000,100.00000,0.00000]", "[[300.00000,100.00000,5.00000]");
    QVERIFY((endOf(text) - before - Vec3(0, 0, 5)).norm() < 1e-3);
  }

  // The controller counts axis 3 from the level: joint 2 + joint 3 = 0.4 rad = 22.918°.
  void linkageReadBack() {
    m_cell = std::make_unique<ArmCell>("irb2400");
    RobotPath path{"bow",
                   {proofWaypoint({0.4, 0.3, 0.1, 0.0, 0.8, 0.0}), proofWaypoint({0.5, 0.3, 0.1, 0.0, 0.8, 0.0})}};
    const QByteArray text = writtenText(path, "rapid");
    QVERIFY2(text.contains("17.1887") && text.contains("22.9183"), text);
    const auto read = pathFromProgram(*m_cell->scene(), m_cell->content(), *postCalled("rapid"), text.toStdString());
    QVERIFY2(read.hasValue(), read ? "" : read.error().code->id);
    for (std::size_t i = 0; i < path.waypoints.size(); ++i)
      QVERIFY((read->path.waypoints[i].joints - path.waypoints[i].joints).norm() < 1e-6);
  }

  // KRL has no blends for joint motions and Fanuc programs no lengths of blends at all, while the others have them:
  // both the message and the head say so, and the time is that of the program as it is written, with its stops.
  void blendsOfLanguages() {
    m_cell = std::make_unique<ArmCell>();
    RobotPath path{"bow",
                   {proofWaypoint({-0.3, 0.3, 0.1, 0.0, 0.8, 0.0}), proofWaypoint({0.0, 0.3, 0.1, 0.0, 0.8, 0.0}),
                    proofWaypoint({0.3, 0.3, 0.1, 0.0, 0.8, 0.0})}};
    path.waypoints[1].blend = 20.0;
    const CheckedPath known = checked(path);
    QVERIFY(known.blends[1] > 0.0);
    CheckedPath stopping = known;
    stopping.blends.assign(3, 0.0);
    const auto lasting = [&](const CheckedPath& each) {
      return timed(*m_cell->scene(), *m_cell->content().plans, path, each.resolved, each.blends).duration();
    };
    QVERIFY(lasting(stopping) > lasting(known) + 0.05);
    for (const char* post : {"rapid", "krl", "fanuc", "json"}) {
      const auto done = written(path, post);
      QVERIFY2(done.hasValue(), post);
      const QByteArray text = writtenText(path, post);
      const bool stops = QByteArray(post) == "krl" || QByteArray(post) == "fanuc";
      QCOMPARE(done->stopsOfLanguage, std::size_t{stops ? 1u : 0u});
      QCOMPARE(done->exactStops, std::size_t{0});
      QVERIFY(!stops || done->smaller.empty());
      QVERIFY2(std::abs(done->seconds - lasting(stops ? stopping : known)) < 0.02, post);
      QByteArray plain = text.simplified();
      plain.replace(" ;", "").replace("!", "");
      QCOMPARE(plain.contains("Exact stops"), stops);
      QVERIFY2(!stops || !plain.contains("Smaller"), post);
    }
  }

  // 0.5 s in each language; a wait for an input, and a variable, have no known length.
  void waits() {
    const auto waiting = [](const char* text) {
      RobotPath path{"p", {Waypoint(), Waypoint()}};
      path.waypoints[0].lines = {{ProgramLine::Kind::Statement, text}};
      return waitingTimeOf(path);
    };
    for (const char* text : {"WaitTime 0.5", "WaitTime\\InPos,0.5", "WAIT SEC 0.5", "WAIT   .50(sec)", "sleep(0.5)",
                             "waittime .5", "sleep( 0.5 )"})
      QVERIFY2((waiting(text) == WaitingTime{0.5, 0}), text);
    for (const char* text : {"WaitDI di1,1", "WAIT FOR $IN[1]", "WAIT DI[1]=ON", "WaitTime nPause", "WAIT SEC 0.5*2",
                             "sleep(t)", "HALT", "WAIT R[1](sec)"})
      QVERIFY2((waiting(text) == WaitingTime{0.0, 1}), text);
    for (const char* text : {"Set doGrip", "DO[1]=ON", "waiting:=TRUE"}) QVERIFY2(waiting(text).seconds == 0.0, text);
    RobotPath path{"p", {proofWaypoint({0.0, 0.3, 0.1, 0.0, 0.8, 0.0}), proofWaypoint({0.1, 0.3, 0.1, 0.0, 0.8, 0.0})}};
    m_cell = std::make_unique<ArmCell>();
    const double moving = checked(path).seconds;
    path.waypoints[0].lines = {{ProgramLine::Kind::Statement, "WaitTime 0.5"}};
    path.language = "rapid";
    QVERIFY(std::abs(checked(path).seconds - moving - 0.5) < 1e-9);
    QVERIFY(std::abs(written(path, "rapid")->seconds - moving - 0.5) < 0.02);
  }

  // Lines that were left out on request are named by the head.
  void linesLeftOutAreNamed() {
    RobotPath path{"p", {proofWaypoint({0.0, 0.3, 0.1, 0.0, 0.8, 0.0}), proofWaypoint({0.1, 0.3, 0.1, 0.0, 0.8, 0.0})}};
    m_cell = std::make_unique<ArmCell>();
    path.language = "rapid";
    path.waypoints[0].lines = {{ProgramLine::Kind::Statement, "Set doGrip", 10},
                               {ProgramLine::Kind::Comment, "grips", 11},
                               {ProgramLine::Kind::Statement, "WaitTime 0.5", 12}};
    const ProgramChoices choices{.withoutLines = true};
    const std::vector<std::size_t> leftOut = linesLeftOut(path, choices);
    QCOMPARE(leftOut, (std::vector<std::size_t>{10, 12}));
    QVERIFY(linesLeftOut(path, {}).empty());
    const RobotPath bare = chosen(path, choices);
    for (const char* post : {"krl", "rapid"}) {
      QVERIFY(writeProgram(*m_cell->scene(), *m_cell->content().plans, bare, checked(bare), *postCalled(post),
                           file("program").toStdString(), {.leftOut = leftOut})
                  .hasValue());
      QFile input(file("program"));
      QVERIFY(input.open(QIODevice::ReadOnly) &&
              input.readAll().contains("left out here, as outputs and waiting: 10, 12."));
    }
  }

  // A program in JSON is read whatever its name, and is called by its file.
  void jsonByAnyName() {
    m_cell = std::make_unique<ArmCell>();
    const RobotPath path{
        "bow", {proofWaypoint({0.0, 0.3, 0.1, 0.0, 0.8, 0.0}), proofWaypoint({0.1, 0.3, 0.1, 0.0, 0.8, 0.0})}};
    const QByteArray text = writtenText(path, "json");
    for (const char* name : {"carry.pj.json", "carry.program.json", "carry.json"}) {
      put(name, text);
      const auto read = pathFromFile(*m_cell->scene(), m_cell->content(), file(name).toStdString());
      QVERIFY2(read.hasValue(), name);
      QCOMPARE(read->path.waypoints.size(), std::size_t{2});
      QVERIFY((read->path.waypoints[1].joints - path.waypoints[1].joints).norm() < 1e-9);
      QCOMPARE(QByteArray::fromStdString(read->path.name).left(5), QByteArray("carry"));
    }
    put("seam.mod", writtenText(path, "rapid"));
    QCOMPARE(pathFromFile(*m_cell->scene(), m_cell->content(), file("seam.mod").toStdString())->path.name,
             std::string("seam"));
  }

  // The controller counts J3 of the LR Mate from the level, J3 - J2, from -140.43° to 280°: J2 = 80° and J3 = -145° of
  // the program are beyond that, and are refused with their line.
  void coupledLimits() {
    m_cell = std::make_unique<ArmCell>("lrmate200id");
    const char* const text =
        "/PROG  J3\n/MN\n   1:J P[1] 100% FINE ;\n   2:J P[2] 100% FINE ;\n/POS\n"
        "P[1]{\n   GP1:\n\tUF : 0, UT : 1,\n\tJ1= 0.0 deg, J2= 0.0 deg, J3= 0.0 deg,\n"
        "\tJ4= 0.0 deg, J5= -90.0 deg, J6= 0.0 deg\n};\n"
        "P[2]{\n   GP1:\n\tUF : 0, UT : 1,\n\tJ1= 0.0 deg, J2= 80.0 deg, J3= -145.0 deg,\n"
        "\tJ4= 0.0 deg, J5= -10.0 deg, J6= 0.0 deg\n};\n/END\n";
    put("j3.ls", text);
    const auto read = pathFromFile(*m_cell->scene(), m_cell->content(), file("j3.ls").toStdString());
    QVERIFY(!read.hasValue() && read.error().code == CellError::CoupledBeyondLimits);
    QVERIFY(read.error().subject.ends_with("j3.ls"));
    QCOMPARE(read.error().position.value, std::uint64_t{4});
    QCOMPARE(read.error().arguments[3], std::string("-145"));
    QCOMPARE(read.error().arguments[4], std::string("-140.43"));
  }

  // The file of data beside a program, whatever the case of its name.
  void dataBesideProgram() {
    m_cell = std::make_unique<ArmCell>("kr6r900");
    put("weld.src", "DEF weld()\nPTP XHOME\nPTP XP1\nEND\n");
    put("$config.dat", "DEFDAT $CONFIG PUBLIC\nE6AXIS XHOME={A1 5,A2 -90,A3 90,A4 0,A5 0,A6 0}\nENDDAT\n");
    QVERIFY(!pathFromFile(*m_cell->scene(), m_cell->content(), file("weld.src").toStdString()).hasValue());
    put("WELD.DAT", "DEFDAT weld\nDECL E6AXIS XP1={A1 10,A2 -90,A3 90,A4 0,A5 20,A6 0}\nENDDAT\n");
    const auto read = pathFromFile(*m_cell->scene(), m_cell->content(), file("weld.src").toStdString());
    QVERIFY2(read.hasValue(), read ? "" : read.error().code->id);
    QVERIFY(std::abs(read->path.waypoints[0].joints[0] - 5.0 * M_PI / 180.0) < 1e-9);
    QVERIFY(std::abs(read->path.waypoints[1].joints[0] - 10.0 * M_PI / 180.0) < 1e-9);
  }

 private:
  QString file(const QString& name) const { return m_folder.filePath(name); }
  void put(const QString& name, const QByteArray& text) const {
    QFile output(file(name));
    QVERIFY(output.open(QIODevice::WriteOnly));
    output.write(text);
  }
  CheckedPath checked(const RobotPath& path) {
    auto known = checkPath(*m_cell->scene(), *m_cell->content().plans, path, {});
    if (!known) qFatal("not checked: %s", known.error().code->id);
    return std::move(known).value();
  }
  double beginOfLast(const RobotPath& path) {
    const CheckedPath known = checked(path);
    return timed(*m_cell->scene(), *m_cell->content().plans, path, known.resolved, known.blends).beginOf(1);
  }
  Result<WrittenProgram> written(const RobotPath& path, const char* post) {
    return writeProgram(*m_cell->scene(), *m_cell->content().plans, path, checked(path), *postCalled(post),
                        file("program").toStdString());
  }
  Error errorOf(const RobotPath& path, const char* post) {
    const auto done = written(path, post);
    return done ? Error{} : done.error();
  }
  QByteArray writtenText(const RobotPath& path, const char* post) {
    const auto done = written(path, post);
    if (!done) qFatal("not written: %s", done.error().code->id);
    QFile input(file("program"));
    return input.open(QIODevice::ReadOnly) ? input.readAll() : QByteArray();
  }

  QTemporaryDir m_folder;
  std::unique_ptr<ArmCell> m_cell;
};

HANDWHEEL_TEST(ProgramProofTest)
#include "ProgramProofTest.moc"
