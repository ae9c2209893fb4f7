// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/program/PathFile.h"

#include "../Robots.h"
#include "TestClass.h"

#include <QTest>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const RobotModel& arm() {
  static const RobotModel kArm = readOrThrow(planarArm({0.5, 0.5}, limit(-3, 3))).robot;
  return kArm;
}

JointValues pair(double a, double b) {
  JointValues values(2);
  values << a, b;
  return values;
}

}  // namespace

// Tests paths as JSON: a written path is read as the same, and errors are named.
class PathFileTest : public QObject {
  Q_OBJECT

 private slots:
  void writtenAndRead() {
    QVERIFY(rc::check("the same path", [] {
      RobotPath path{"from a to b", {}};
      const int count = *rc::gen::inRange(0, 6);
      for (int i = 0; i < count; ++i) {
        Waypoint waypoint{.joints = pair(anyNumber(-3, 3), anyNumber(-3, 3)), .name = std::string(1, char('a' + i))};
        waypoint.isCritical = *rc::gen::arbitrary<bool>();
        if (*rc::gen::arbitrary<bool>()) {
          waypoint.motion = ProgramMotion::Kind::Linear;
          waypoint.speed = anyNumber(1, 1000);
        }
        waypoint.blend = anyNumber(0, 50);
        path.waypoints.push_back(waypoint);
      }
      if (*rc::gen::arbitrary<bool>()) path.bases["left"] = Pose(Eigen::Translation3d(anyNumber(-900, 900), 0.1, -3.0));
      if (*rc::gen::arbitrary<bool>()) {
        path.process = PathProcess{{{"along", anyNumber(0, 4)}, {"free", true}, {"part", "a \"block\""}}};
        path.process->part =
            Pose(Eigen::Translation3d(1.5, -2.0, 1e3) * Eigen::AngleAxisd(anyNumber(-3, 3), Vec3(1, 2, 2) / 3.0));
        if (*rc::gen::arbitrary<bool>()) path.process->tool = Pose(Eigen::Translation3d(0.5, 0.0, anyNumber(0, 90)));
        if (*rc::gen::arbitrary<bool>())
          path.process->base = Pose(Eigen::Translation3d(anyNumber(-900, 900), 7.0, 0.0));
      }
      const auto again = readPath(toJson(arm(), path).dump(), arm(), pair(0, 0));
      RC_ASSERT(again.hasValue());
      RC_ASSERT(*again == path);
    }));
  }

  // Former data of a path are compared with it after a robot was added or removed: other numbers of joints are not
  // equal.
  void ofAnotherNumberOfJoints() {
    Waypoint one{.joints = JointValues::Zero(6)}, two{.joints = JointValues::Zero(12)};
    QVERIFY(!(one == two) && !(two == one) && one == one);
    QVERIFY(!(RobotPath{"a", {one}} == RobotPath{"a", {two}}));
    QVERIFY(!(NamedConfiguration{"a", one.joints} == NamedConfiguration{"a", two.joints}));
    QVERIFY((NamedConfiguration{"a", one.joints} == NamedConfiguration{"a", JointValues::Zero(6)}));
  }

  void waypointsAlone() {
    const auto path = readPath(R"({"waypoints": [[0.1, 0.2], [1, -1]]})", arm(), pair(0, 0));
    QVERIFY(path.hasValue());
    QCOMPARE(path->waypoints.size(), std::size_t{2});
    QVERIFY(path->waypoints[1].joints == pair(1, -1));
    // In another order, and of one joint only: the other keeps its value.
    const auto other = readPath(R"({"joints": ["j2"], "waypoints": [[0.5]]})", arm(), pair(0.25, 0));
    QVERIFY(other.hasValue());
    QVERIFY(other->waypoints[0].joints == pair(0.25, 0.5));
  }

  // An invalid process is ignored: the path is as good without it.
  void brokenProcess() {
    for (const char* process :
         {"7", "{}", R"({"values": {}})", R"({"values": {}, "part": [1, 2]})", R"({"values": 1, "part": [1]})",
          R"({"values": {}, "part": [2,0,0,0, 0,1,0,0, 0,0,1,0]})",
          R"({"values": {}, "part": [-1,0,0,0, 0,1,0,0, 0,0,1,0]})"}) {
      const auto path =
          readPath(R"({"waypoints": [[0, 1]], "process": )" + std::string(process) + "}", arm(), pair(0, 0));
      QVERIFY2(path.hasValue() && !path->process && path->waypoints.size() == 1, process);
    }
    const auto path =
        readPath(R"({"waypoints": [], "process": {"values": {"a": [1], "b": 2}, "part": [1,0,0,0, 0,1,0,0, 0,0,1,7]}})",
                 arm(), pair(0, 0));
    QVERIFY(path.hasValue() && path->process && path->process->values.size() == 1);
    QVERIFY(path->process->part.translation() == Vec3(0, 0, 7));
  }

  void refusals_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("code");
    QTest::newRow("no JSON") << "{"
                             << "ElementMalformed";
    QTest::newRow("a list") << "[]"
                            << "ElementMalformed";
    QTest::newRow("nothing") << "{}"
                             << "ElementMalformed";
    QTest::newRow("too few numbers") << R"({"waypoints": [[1]]})"
                                     << "ElementMalformed";
    QTest::newRow("a text") << R"({"waypoints": [[1, "2"]]})"
                            << "ElementMalformed";
    QTest::newRow("beyond a limit") << R"({"waypoints": [[1, 3.1]]})"
                                    << "ValueOutOfRange";
    QTest::newRow("no number at all") << R"({"waypoints": [[1, 1e999]]})"
                                      << "ElementMalformed";
    QTest::newRow("a joint that is not there") << R"({"joints": ["j1", "j9"], "waypoints": []})"
                                               << "ReferenceMissing";
    QTest::newRow("a place without joints") << R"({"places": [{"name": "x"}]})"
                                            << "ElementMalformed";
    QTest::newRow("a motion") << R"({"places": [{"joints": {}, "motion": "leap"}]})"
                              << "ElementMalformed";
  }
  void refusals() {
    QFETCH(const QString, text);
    QFETCH(const QString, code);
    const auto path = readPath(text.toStdString(), arm(), pair(0, 0));
    QVERIFY(!path.hasValue());
    QCOMPARE(QString::fromLatin1(path.error().code->id), code);
  }

  // Control characters in lines, as older files have them, become blanks.
  void linesWithControls() {
    const auto path =
        readPath(R"({"places": [{"joints": {}, "lines": [{"text": "a\r\nb\u0001"}]}]})", arm(), pair(0, 0));
    QVERIFY(path.hasValue());
    QCOMPARE(path->waypoints[0].lines.front().text, std::string("a  b "));
  }

  // Rounded values of a file may be slightly beyond a limit: the path is within, for planner and verifier alike.
  void printedDigitsBeyondALimit() {
    QVERIFY(rc::check("within, and no further away than the digits", [] {
      const double over = anyNumber(-0.9e-6, 0.9e-6), under = anyNumber(-0.9e-6, 0.9e-6);
      const auto within = valuesWithinLimits(arm(), pair(3.0 + over, -3.0 + under));
      RC_ASSERT(within.hasValue());
      RC_ASSERT((*within)[0] == std::min(3.0, 3.0 + over) && (*within)[1] == std::max(-3.0, -3.0 + under));
    }));
    QVERIFY(!valuesWithinLimits(arm(), pair(3.0 + 2e-6, 0)).hasValue());
    const auto path = readPath(R"({"waypoints": [[3.0000005, -3.0000005]]})", arm(), pair(0, 0));
    QVERIFY(path.hasValue() && path->waypoints[0].joints == pair(3, -3));
  }

  // Checking a motion of a million turns could take days.
  void tooManyTurns() {
    const RobotModel wide = readOrThrow(planarArm({0.5, 0.5}, limit(-1e6, 1e6))).robot;
    QVERIFY(readPath(R"({"waypoints": [[1000, -1000]]})", wide, pair(0, 0)).hasValue());
    for (const char* text : {R"({"waypoints": [[1001, 0]]})", R"({"places": [{"joints": {"j2": -1001}}]})"}) {
      const auto path = readPath(text, wide, pair(0, 0));
      QVERIFY(!path.hasValue() && path.error().code == ErrorCode::ValueOutOfRange);
    }
    // Slides may go further than 1000 mm.
    const RobotModel slide =
        readOrThrow(robotOf(link("a") + link("b") + joint("j", "prismatic", "a", "b", limit(0, 9)))).robot;
    QVERIFY(valuesWithinLimits(slide, JointValues::Constant(1, 8e3)).hasValue());
  }

  // A path accepts any joint values that a cell accepts: a row holds those of all robots.
  void whatJointsMayStandAt() {
    const std::string follower = joint("k", "revolute", "a", "c", limit(-1e6, 1e6) + "<mimic joint='j'/>");
    const std::string three = link("a") + link("b") + link("c");
    const RobotModel robots[] = {
        readOrThrow(planarArm({0.5}, limit(-1e6, 1e6))).robot, readOrThrow(planarArm({0.5}, limit(900, 1e6))).robot,
        readOrThrow(robotOf(three + joint("j", "continuous", "a", "b") + follower)).robot,
        readOrThrow(robotOf(link("a") + link("b") + joint("j", "continuous", "a", "b"))).robot,
        readOrThrow(robotOf(link("a") + link("b") + joint("j", "prismatic", "a", "b", limit(-1e9, 1e9)))).robot};
    QVERIFY(rc::check("taken as it is", [&] {
      const RobotModel& robot = robots[*rc::gen::inRange(0, 5)];
      const JointValues stands = withinLimits(robot, JointValues::Constant(1, anyNumber(-3e6, 3e6)));
      const auto read = jointsFrom(toJson(robot, stands), robot, JointValues::Zero(1));
      RC_ASSERT(read.hasValue() && *read == stands);
    }));
    QCOMPARE(withinLimits(robots[0], JointValues::Constant(1, -1e5))[0], -kMostTurn);
    QCOMPARE(withinLimits(robots[1], JointValues::Constant(1, 0))[0], 900.0);
    QVERIFY(!readUrdf(planarArm({0.5}, limit(1001, 1e6))));
  }

  // The same as one by one, and many equal names.
  void manyNamesAlike() {
    FreeNames names;
    names.add("way 3");
    std::vector<std::string> taken;
    for (int i = 0; i < 20'000; ++i) taken.push_back(names.take("way"));
    QCOMPARE(taken[0], std::string("way"));
    QCOMPARE(taken[1], std::string("way 2"));
    QCOMPARE(taken[2], std::string("way 4"));
    QCOMPARE(taken.back(), std::string("way 20001"));
    QCOMPARE(names.take("way 7"), std::string("way 7 2"));
  }

  void names() {
    CellPlans plans;
    plans.paths = {{"way", {}}, {"way 2", {}}};
    QCOMPARE(plans.freePathName("way"), std::string("way 3"));
    QCOMPARE(plans.freePathName("other"), std::string("other"));
    QVERIFY(plans.path("way 2") && !plans.path("way 9"));
  }
};

HANDWHEEL_TEST(PathFileTest)
#include "PathFileTest.moc"
