// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/PlanOperation.h"

#include "../ArmCell.h"
#include "TestClass.h"
#include "document/cell/CellErrors.h"
#include "robot/program/PathFile.h"
#include "tools/cell/path/DefaultClearance.h"
#include "tools/cell/path/PathCheck.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

using namespace handwheel;
using namespace handwheel::test;

namespace {

JointValues turnedTo(double first, double second) {
  JointValues joints = JointValues::Zero(6);
  joints[0] = first;
  joints[1] = second;
  joints[4] = 0.6;  // no straight wrist
  return joints;
}

}  // namespace

// Plans a path through several waypoints, once and again.
class PlanOperationTest : public QObject {
  Q_OBJECT

 private slots:
  // Three legs; a box stands in the first and one in the last of them.
  void init() {
    m_cell = std::make_unique<ArmCell>();
    m_cell->addBox({100, 200, 800}, {450, 0, 400});
    m_cell->addBox({200, 100, 800}, {0, 450, 400});
    const std::vector<Waypoint> waypoints{{.joints = turnedTo(-1.2, 0.5)},
                                          {.joints = turnedTo(0.7, 0.5)},
                                          {.joints = turnedTo(0.75, 0.3)},
                                          {.joints = turnedTo(2.3, 0.5)}};
    m_path = planned(waypoints).path;
    QVERIFY(m_path.waypoints.size() > waypoints.size());
    QCOMPARE(criticals(m_path), waypoints.size());
  }

  // Nothing has changed: all is proven and kept, and no planner looks at anything else.
  void nothingToPlan() {
    const PlannedPath again = planned(m_path.waypoints);
    QCOMPARE(again.keptLegs, std::size_t{3});
    QVERIFY(again.path.waypoints == m_path.waypoints);
  }

  // Only the legs beside a changed waypoint are planned; the others stay bit for bit.
  void besideAChangedWaypoint() {
    std::vector<Waypoint> waypoints = m_path.waypoints;
    const std::size_t third = indexOf(m_path, 2);
    waypoints[third].joints = turnedTo(0.72, 0.2);
    const PlannedPath again = planned(waypoints);
    QCOMPARE(again.keptLegs, std::size_t{1});
    const std::size_t second = indexOf(m_path, 1);
    for (std::size_t i = 0; i <= second; ++i) QVERIFY(again.path.waypoints[i] == m_path.waypoints[i]);
    QVERIFY(isFree(again.path));
    QCOMPARE(planned(again.path.waypoints).keptLegs, std::size_t{3});  // from now on
  }

  // An inserted or removed waypoint makes other legs.
  void insertedAndRemoved() {
    std::vector<Waypoint> waypoints = m_path.waypoints;
    waypoints.insert(waypoints.begin() + static_cast<std::ptrdiff_t>(indexOf(m_path, 1)) + 1,
                     {.joints = turnedTo(0.8, 0.1)});
    const PlannedPath more = planned(waypoints);
    QCOMPARE(more.keptLegs, std::size_t{2});
    QCOMPARE(criticals(more.path), std::size_t{5});
    waypoints = m_path.waypoints;
    waypoints.erase(waypoints.begin() + static_cast<std::ptrdiff_t>(indexOf(m_path, 1)));
    const PlannedPath less = planned(waypoints);
    QCOMPARE(less.keptLegs, std::size_t{1});
    QCOMPARE(criticals(less.path), std::size_t{3});
    QVERIFY(isFree(less.path));
  }

  // A leg with an obstacle is planned anew; the clearance counts, too.
  void notProvenAnyMore() {
    m_cell->addBox({60, 60, 60}, toolAt(m_path.waypoints[1].joints));
    QVERIFY(m_path.waypoints.size() > 2 && !m_path.waypoints[1].isCritical);
    const PlannedPath again = planned(m_path.waypoints);
    QCOMPARE(again.keptLegs, std::size_t{2});
    QVERIFY(isFree(again.path));
  }

  // A straight line of the tool is looked at again always; made a joint motion, it is planned.
  void anotherMotion() {
    std::vector<Waypoint> waypoints = m_path.waypoints;
    waypoints[indexOf(m_path, 2)].motion = ProgramMotion::Kind::Linear;
    waypoints[indexOf(m_path, 2)].speed = 100.0;
    const PlannedPath straight = planned(waypoints);
    QCOMPARE(straight.keptLegs, std::size_t{2});
    QCOMPARE(planned(straight.path.waypoints).keptLegs, std::size_t{2});
  }

  // A path keeps the clearance that it was planned with, where that is not the cell's.
  void clearanceIsKept() {
    QVERIFY(!m_path.clearance);
    const PlannedPath further = planned(m_path.waypoints, 12.0);
    QVERIFY(further.path.clearance == 12.0);
    const CellPlans plans = *m_cell->content().plans;
    const auto checked =
        checkPath(*m_cell->scene(), plans, further.path, {.clearance = plans.clearanceOf(further.path)});
    QVERIFY(checked && checked->isCertified() && checked->metrics.leastClearance >= 12.0);
    const RobotModel& robot = m_cell->document().robot().model;
    const auto read = pathFrom(toJson(robot, further.path), robot, m_cell->document().joints());
    QVERIFY(read && read->clearance == 12.0);
    CellPlans asFar = plans;
    asFar.clearance = 12.0;
    m_cell->plan(asFar);
    QVERIFY(!planned(m_path.waypoints, 12.0).path.clearance);
  }

  // An object nearer than the clearance that does not collide is too close, by its distance in mm; inside a box it
  // collides.
  void tooNearIsNoCollision() {
    const auto scene = m_cell->scene();
    const JointValues begin = turnedTo(-1.2, 0.5);
    const double distance = scene->scene.nearestObstacle(scene->planned(begin), 2000.0).distance;
    QVERIFY(distance > 1.0 && distance < 1000.0);
    const std::vector<Waypoint> waypoints{{.joints = begin}, {.joints = turnedTo(0.7, 0.5)}};
    RouteSettings settings;
    settings.plan.check.clearance = distance + 1.0;
    const auto near = plannedThrough(*scene, *m_cell->content().plans, waypoints, settings);
    QVERIFY(!near && near.error().code == CellError::WaypointTooNear);
    QCOMPARE(near.error().arguments.size(), std::size_t{4});
    QVERIFY(std::abs(std::stod(near.error().arguments[3]) - distance) <= 5e-3 * distance);  // three digits
    const std::vector<Waypoint> inside{{.joints = begin}, {.joints = turnedTo(0.0, 0.6)}};
    settings.plan.check.clearance = 0.0;
    const auto met = plannedThrough(*scene, *m_cell->content().plans, inside, settings);
    QVERIFY(!met && met.error().code == CellError::WaypointCollides);
  }

  // A robot of the library has simplified shapes: a new path of it keeps a clearance, unless the cell has one; along a
  // curve half of the distance of the tool at most. Of other robots it is that of the cell.
  void theClearanceThatIsOffered() {
    const CellRobot& robot = m_cell->document().robot();
    CellPlans plans;
    QCOMPARE(defaultClearance(robot, plans), 5.0);
    QCOMPARE(defaultClearance(robot, plans, 1.0), 0.5);
    QCOMPARE(defaultClearance(robot, plans, 100.0), 5.0);
    QCOMPARE(defaultClearance(robot, plans, -2.0), 0.0);
    plans.clearance = 2.0;
    QCOMPARE(defaultClearance(robot, plans), 2.0);
    QCOMPARE(defaultClearance(robot, plans, 1.0), 2.0);
    const DhTable table{
        .name = "my arm",
        .joints = {{{.a = 300.0, .lower = -2.0, .upper = 2.0}, "a"}, {{.a = 250.0, .lower = -2.0, .upper = 2.0}, "b"}}};
    ArmCell own(table);
    QCOMPARE(defaultClearance(own.document().robot(), CellPlans()), 0.0);
  }

  // The file also marks the legs that were planned.
  void writtenAndRead() {
    const RobotModel& robot = m_cell->document().robot().model;
    const auto read = pathFrom(toJson(robot, m_path), robot, m_cell->document().joints());
    QVERIFY(read.hasValue());
    QCOMPARE(planned(read->waypoints).keptLegs, std::size_t{3});
    nlohmann::json without = toJson(robot, m_path);
    for (nlohmann::json& waypoint : without["places"]) waypoint.erase("planned");
    QCOMPARE(planned(pathFrom(without, robot, m_cell->document().joints())->waypoints).keptLegs, std::size_t{0});
  }

 private:
  PlannedPath planned(const std::vector<Waypoint>& waypoints, double clearance = 0.0) {
    const auto scene = m_cell->scene();
    RouteSettings settings;
    settings.plan.seconds = 60.0;
    settings.plan.check.clearance = clearance;
    Result<PlannedPath> made = plannedThrough(*scene, *m_cell->content().plans, waypoints, settings);
    if (!made) qFatal("not planned: %s", made.error().code->id);
    return std::move(made).value();
  }
  bool isFree(const RobotPath& path) {
    const auto checked = checkPath(*m_cell->scene(), *m_cell->content().plans, path, {});
    return checked && checked->isCertified();
  }
  Vec3 toolAt(const JointValues& joints) {
    const auto scene = m_cell->scene();
    return scene->arm.tipPose(scene->planned(joints)).translation();
  }
  static std::size_t criticals(const RobotPath& path) {
    return static_cast<std::size_t>(std::count_if(path.waypoints.begin(), path.waypoints.end(),
                                                  [](const Waypoint& each) { return each.isCritical; }));
  }
  // Returns the index of the critical waypoint with this number among all.
  static std::size_t indexOf(const RobotPath& path, std::size_t critical) {
    std::size_t at = 0;
    for (std::size_t found = 0; at < path.waypoints.size(); ++at) {
      if (path.waypoints[at].isCritical && found++ == critical) break;
    }
    return at;
  }

  std::unique_ptr<ArmCell> m_cell;
  RobotPath m_path;
};

HANDWHEEL_TEST(PlanOperationTest)
#include "PlanOperationTest.moc"
