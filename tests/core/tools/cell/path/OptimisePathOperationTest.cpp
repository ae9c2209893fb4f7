// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/OptimisePathOperation.h"

#include "TestClass.h"
#include "document/cell/CellErrors.h"
#include "document/cell/CellImport.h"
#include "document/scene/BodyChanges.h"
#include "robot/dh/DhTable.h"
#include "scene/PrimitiveGeometry.h"
#include "tools/cell/path/PlanComparison.h"

#include <QtTest>

using namespace handwheel;

namespace {

// An IRB 120 in a cell, with a box before it if requested.
class PlannedRobot {
 public:
  explicit PlannedRobot(bool hasBox = false) : m_cell(*cellOf(*libraryTable("irb120"))) {
    if (hasBox) {
      auto body = std::make_shared<Body>();
      body->id = 1;
      body->name = "box";
      body->geometry = *PrimitiveGeometry::make(Primitive::Cuboid, {100.0, 200.0, 800.0});
      body->pose = Pose(Eigen::Translation3d(450.0, 0.0, 400.0));
      m_cell.bodies = m_cell.bodies.with(body);
    }
    scene = *sceneOf(m_cell, m_meshes);
  }

  Waypoint waypoint(const std::array<double, 6>& q, ProgramMotion::Kind motion = ProgramMotion::Kind::Joint) const {
    ArmValues values(6);
    std::copy(q.begin(), q.end(), values.data());
    Waypoint made{.joints = scene->whole(values), .motion = motion};
    if (motion == ProgramMotion::Kind::Linear) made.speed = 100.0;
    return made;
  }
  Pose toolAt(const Waypoint& waypoint) const { return scene->arm.tipPose(scene->planned(waypoint.joints)); }
  Result<OptimisedPath> optimised(const RobotPath& path, OptimisationSettings settings = {},
                                  Progress progress = {}) const {
    return optimisedPath(*scene, plans, path, settings, progress);
  }

  std::optional<CellScene> scene;
  CellPlans plans;

 private:
  CollisionMeshes m_meshes;
  RobotCellSnapshot m_cell;
};

// A motion of the first joint alone, of at least 0.2 rad, at a quarter of its 250° a second, as PathTimingSettings has
// it: it ends in its ramps' time beside that at full speed.
double secondsFor(double angle) {
  const double fastest = 250.0 * M_PI / 180.0, acceleration = fastest / 0.25, jerk = acceleration / 0.1;
  const double speed = 0.25 * fastest, ramp = 2.0 * std::sqrt(speed / jerk);
  return angle / speed + ramp;
}

std::vector<Waypoint> criticalOf(const RobotPath& path) {
  std::vector<Waypoint> waypoints;
  for (const Waypoint& each : path.waypoints) {
    if (each.isCritical) waypoints.push_back(each);
  }
  return waypoints;
}

}  // namespace

class OptimisePathOperationTest : public QObject {
  Q_OBJECT

 private slots:
  // Places on one turn of the first joint: the quickest is to take them as they come, in the time of each gap.
  void order() {
    const PlannedRobot robot;
    RobotPath path{"p", {}};
    for (const double turn : {1.2, -0.8, 0.6, 1.0, -0.4, -1.2})
      path.waypoints.push_back(robot.waypoint({turn, 0.3, 0, 0, 0.5, 0}));
    path.process = PathProcess{{{"lead", 10.0}}};
    const Result<OptimisedPath> found = robot.optimised(path, {.route = {}, .mayReconfigure = false});
    QVERIFY(found);
    QVERIFY(!found->planned.path.process);  // no longer along its curve
    QVERIFY(found->order == (std::vector<std::size_t>{0, 3, 2, 4, 1, 5}));
    QVERIFY(found->isChanged && found->reconfigured == 0);
    double before = 0.0, after = 0.0;
    for (const double gap : {2.0, 1.4, 0.4, 1.4, 0.8}) before += secondsFor(gap);
    for (const double gap : {0.2, 0.4, 1.0, 0.4, 0.4}) after += secondsFor(gap);
    QVERIFY(std::abs(found->before - before) < 1e-6);
    QVERIFY(std::abs(found->after - after) < 1e-6);
    // Once more there is nothing to gain, and the path is the very same.
    const Result<OptimisedPath> again = robot.optimised(found->planned.path, {.route = {}, .mayReconfigure = false});
    QVERIFY(again && !again->isChanged && again->planned.path == found->planned.path);
    const Result<OptimisedPath> kept =
        robot.optimised(path, {.route = {}, .mayReorder = false, .mayReconfigure = false});
    QVERIFY(kept && !kept->isChanged && kept->planned.path == path);
  }

  // A waypoint that the wrist was turned over for is reached without that; the tool's pose stays.
  void configurations() {
    const PlannedRobot robot;
    const std::array<double, 6> begin{0.5, 0.2, 0.1, 0.2, 0.5, 0.3}, end{-0.5, 0.2, 0.1, 0.2, 0.5, 0.3};
    const RobotPath path{"p",
                         {robot.waypoint(begin), robot.waypoint({0.0, 0.2, 0.1, 0.2 - M_PI + 0.6, -0.5, 0.3 + M_PI}),
                          robot.waypoint(end)}};
    const Result<OptimisedPath> found = robot.optimised(path);
    QVERIFY(found && found->isChanged);
    QCOMPARE(found->reconfigured, std::size_t{1});
    QVERIFY(found->after < 0.6 * found->before);
    const std::vector<Waypoint> waypoints = criticalOf(found->planned.path);
    QCOMPARE(waypoints.size(), std::size_t{3});
    QVERIFY(waypoints.front() == path.waypoints.front() && waypoints.back() == path.waypoints.back());
    QVERIFY(robot.toolAt(waypoints[1]).isApprox(robot.toolAt(path.waypoints[1]), 1e-9));
    QVERIFY(robot.scene->planned(waypoints[1].joints)[4] > 0.0);
    QVERIFY(!robot.optimised(path, {.route = {}, .mayReconfigure = false})->isChanged);
  }

  // A line that is followed with the wrist turned over is followed without that, from its begin to its end.
  void configurationsOfLines() {
    const PlannedRobot robot;
    const auto over = [](std::array<double, 6> q) {  // the same pose of the tool
      return std::array<double, 6>{q[0], q[1], q[2], q[3] - M_PI, -q[4], q[5] + M_PI};
    };
    const std::array<double, 6> first{0.1, 0.2, 0.1, 0.8, 0.5, 0.3}, second{0.0, 0.2, 0.1, 0.8, 0.5, 0.3};
    const RobotPath path{
        "p",
        {robot.waypoint({0.5, 0.2, 0.1, 0.2, 0.5, 0.3}), robot.waypoint(over(first)),
         robot.waypoint(over(second), ProgramMotion::Kind::Linear), robot.waypoint({-0.5, 0.2, 0.1, 0.2, 0.5, 0.3})}};
    const Result<OptimisedPath> found = robot.optimised(path);
    QVERIFY(found && found->isChanged);
    QCOMPARE(found->reconfigured, std::size_t{2});
    QVERIFY(found->after < found->before);
    const std::vector<Waypoint> waypoints = criticalOf(found->planned.path);
    QCOMPARE(waypoints.size(), std::size_t{4});
    QVERIFY(waypoints[2].motion == ProgramMotion::Kind::Linear);
    for (const std::size_t i : {1, 2}) {
      QVERIFY(robot.toolAt(waypoints[i]).isApprox(robot.toolAt(path.waypoints[i]), 1e-9));
      QVERIFY(robot.scene->planned(waypoints[i].joints)[4] > 0.0);
    }
    const Result<CheckedPath> checked = checkPath(*robot.scene, robot.plans, found->planned.path, {});
    QVERIFY(checked && checked->isCertified());
  }

  // Given values have precedence; by default the clearance is that of the path, or of the cell.
  void settings() {
    OperationValues values(optimisePathOperation());
    CellPlans plans;
    plans.clearance = 2.0;
    RobotPath path{"p", {}};
    const OptimisationSettings standard = optimisationSettingsOf(values, plans, path);
    QVERIFY(standard.mayReorder && standard.mayReconfigure);
    QCOMPARE(standard.seconds, 30.0);
    QCOMPARE(standard.route.plan.check.clearance, 2.0);
    path.clearance = 6.0;
    QCOMPARE(optimisationSettingsOf(values, plans, path).route.plan.check.clearance, 6.0);
    for (const char* const flag : {"keep-order", "keep-configurations"}) values.setValid(flag, true);
    values.setValid("search", 0.5);
    values.setValid("clearance", 1.0);
    values.setValid("shortcuts", 3.0);
    const OptimisationSettings given = optimisationSettingsOf(values, plans, path);
    QVERIFY(!given.mayReorder && !given.mayReconfigure);
    QCOMPARE(given.seconds, 0.5);
    QCOMPARE(given.route.plan.check.clearance, 1.0);
    QCOMPARE(given.route.shortcuts, 3);
  }

  // A path of another robot is none of this one's.
  void anotherRobot() {
    const PlannedRobot robot;
    const RobotPath path{"p", {robot.waypoint({}), robot.waypoint({0.5})}, "other"};
    const Result<OptimisedPath> found = robot.optimised(path);
    QVERIFY(!found && found.error().code == CellError::OfOtherArm);
  }

  // A waypoint at the end of a straight line stays behind the one that the line begins at.
  void linesStay() {
    const PlannedRobot robot;
    using enum ProgramMotion::Kind;
    RobotPath path{"p", {robot.waypoint({1.2, 0.2, 0.2, 0, 0.6, 0})}};
    for (const double turn : {-0.9, 0.7, -0.2}) {
      path.waypoints.push_back(robot.waypoint({turn, 0.2, 0.2, 0, 0.6, 0}));
      path.waypoints.push_back(robot.waypoint({turn, 0.3, 0.2, 0, 0.5, 0}, Linear));
    }
    path.waypoints.push_back(robot.waypoint({-1.2, 0.2, 0.2, 0, 0.6, 0}));
    const Result<OptimisedPath> found = robot.optimised(path);
    QVERIFY(found && found->isChanged);
    QVERIFY(found->order == (std::vector<std::size_t>{0, 3, 4, 5, 6, 1, 2, 7}));
    const std::vector<Waypoint> waypoints = criticalOf(found->planned.path);
    for (const std::size_t line : {2, 4, 6})
      QVERIFY(waypoints[line].motion == Linear && waypoints[line - 1].motion == Joint);
    const Result<CheckedPath> checked = checkPath(*robot.scene, robot.plans, found->planned.path, {});
    QVERIFY(checked && checked->isCertified());
  }

  // Around a box: the result is proven free, and a path that collides is replaced even by a slower one.
  void amongObstacles() {
    const PlannedRobot robot(true);
    RobotPath path{"p", {}};
    for (const double turn : {1.2, -1.0, 0.9, -1.2}) path.waypoints.push_back(robot.waypoint({turn, 0.5, 0, 0, 0, 0}));
    const Result<CheckedPath> before = checkPath(*robot.scene, robot.plans, path, {});
    QVERIFY(before && !before->isCertified());
    const Result<OptimisedPath> found = robot.optimised(path);
    QVERIFY(found && found->isChanged);
    QVERIFY(found->order == (std::vector<std::size_t>{0, 2, 1, 3}));
    const Result<CheckedPath> after = checkPath(*robot.scene, robot.plans, found->planned.path, {});
    QVERIFY(after && after->isCertified());
    QVERIFY(std::abs(after->seconds - found->after) < 1e-9);
    // Only the motions between the waypoints change: it follows its curve as before.
    path.process = PathProcess{{{"lead", 10.0}}};
    const Result<OptimisedPath> kept =
        robot.optimised(path, {.route = {}, .mayReorder = false, .mayReconfigure = false});
    QVERIFY(kept && kept->isChanged && kept->planned.path.process == path.process);
    path.waypoints[1] = robot.waypoint({0.0, 0.6, 0, 0, 0, 0});  // in the box
    QVERIFY(robot.optimised(path).error().code == CellError::WaypointCollides);
    JobState state;
    state.cancelled = true;
    QVERIFY(robot.optimised(path, {}, Progress(state)).error().code == ErrorCode::Cancelled);
  }

  // Without critical configurations, with one and with two, each before and after it was made shorter.
  void comparison() {
    const PlannedRobot robot(true);
    const std::vector<Waypoint> waypoints{
        robot.waypoint({1.2, 0.5, 0, 0, 0, 0}), robot.waypoint({0.6, -0.6, -0.6, 0, 0, 0}),
        robot.waypoint({-0.6, -0.6, -0.6, 0, 0, 0}), robot.waypoint({-1.2, 0.5, 0, 0, 0, 0})};
    const std::vector<ComparedPath> all = comparedPaths(*robot.scene, robot.plans, waypoints, {});
    QCOMPARE(all.size(), std::size_t{6});
    for (std::size_t i = 0; i < all.size(); ++i) {
      const ComparedPath& each = all[i];
      QCOMPARE(each.critical, i / 2);
      QCOMPARE(each.isOptimised, i % 2 == 1);
      QVERIFY(each.checked && each.checked->isCertified());
      const std::vector<Waypoint> critical = criticalOf(each.planned->path);
      QCOMPARE(critical.size(), each.critical + 2);
      for (std::size_t k = 0; k < each.critical; ++k) QVERIFY(critical[k + 1] == waypoints[k + 1]);
      if (each.isOptimised) QVERIFY(each.checked->metrics.length <= all[i - 1].checked->metrics.length + 1e-9);
    }
  }
};

HANDWHEEL_TEST(OptimisePathOperationTest)
#include "OptimisePathOperationTest.moc"
