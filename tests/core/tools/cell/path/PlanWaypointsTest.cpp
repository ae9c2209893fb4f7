// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../ArmCell.h"
#include "TestClass.h"
#include "document/cell/CellErrors.h"
#include "document/cell/RobotChanges.h"
#include "planning/PlanningFidelity.h"
#include "planning/planners/Planners.h"
#include "tools/cell/path/PlanOperation.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

OperationValues planValues(const std::vector<std::pair<const char*, std::string>>& words) {
  OperationValues values(planOperation());
  for (const auto& [id, word] : words) values.setValid(id, word);
  return values;
}

JointValues jointsAt(std::initializer_list<double> list) {
  JointValues joints(static_cast<Eigen::Index>(list.size()));
  std::copy(list.begin(), list.end(), joints.begin());
  return joints;
}

const JointValues kLeft = jointsAt({-0.5, 0.5, 0.25, 0.0, 0.75, 0.0}),
                  kRight = jointsAt({0.5, 0.5, 0.25, 0.0, 0.75, 0.0});

}  // namespace

// Waypoints, options and errors of planning a path.
class PlanWaypointsTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    m_cell = std::make_unique<ArmCell>();
    m_cell->stand({0.0, 0.5, 0.25, 0.0, 0.75, 0.0});
    CellPlans plans;
    plans.configurations = {{"left", kLeft, ""}, {"right", kRight, ""}, {"a, b", kLeft, ""}};
    m_cell->plan(plans);
  }

  // By names, where the robot stands, and as joint values with spaces or commas between them.
  void waypointsInWords() {
    const auto ends = waypoints({{"from", "left"}, {"to", "here"}});
    QCOMPARE(ends.size(), std::size_t{2});
    QVERIFY(ends[0].joints == kLeft && ends[0].name == "left" && ends[0].configuration == "left");
    QVERIFY(ends[1].joints == m_cell->document().joints() && ends[1].name.empty());
    for (const char* const text : {"0.5 0.5 0.25 0 0.75 0", "0.5,0.5,0.25,0,0.75,0", " 0.5, 0.5,\t0.25 0 0.75  0"})
      QCOMPARE(waypoints({{"from", "left"}, {"to", text}})[1].joints, kRight);
  }

  // Several in between: between commas, or between semicolons if they are numbers; one whose name has a comma is one.
  void waypointsInBetween() {
    const auto joints = [&](const std::string& via) {
      std::vector<JointValues> all;
      for (const Waypoint& each : waypoints({{"from", "here"}, {"to", "here"}, {"via", via}}))
        all.push_back(each.joints);
      all.erase(all.begin());
      all.pop_back();
      return all;
    };
    QVERIFY(joints("left,right") == (std::vector{kLeft, kRight}));
    QVERIFY(joints("0.5 0.5 0.25 0 0.75 0;left") == (std::vector{kRight, kLeft}));
    QVERIFY(joints("0.5,0.5,0.25,0,0.75,0") == std::vector{kRight});
    QVERIFY(joints("a, b") == std::vector{kLeft});
    QVERIFY(joints("left,,right,") == (std::vector{kLeft, kRight}));
  }

  // A target is reached from the waypoint before, by the nearest solution.
  void targets() {
    const Pose tool = m_cell->tool();
    CellPlans plans = *m_cell->document().plans();
    plans.targets = {{"T", tool}};
    m_cell->plan(plans);
    const auto ends = waypoints({{"from", "left"}, {"to", "T"}});
    QVERIFY(m_cell->scene()->arm.tipPose(m_cell->scene()->planned(ends[1].joints)).isApprox(tool, 1e-6));
    QCOMPARE(ends[1].name, std::string("T"));
    QVERIFY(ends[1].target && ends[1].target->name == "T" && ends[1].target->inTool.isApprox(Pose::Identity(), 1e-6));
    plans.targets[0].pose.translation().x() = 5e3;
    m_cell->plan(plans);
    QVERIFY(refusal({{"from", "left"}, {"to", "T"}}).code == CellError::ToolOutOfReach);
  }

  void waypointsThatAreMissing() {
    for (const char* const text : {"middle", "0 0 0 0 0", "0 0 0 0 0 far", "0 0 0 0 0 0 0", ""}) {
      const Error error = refusal({{"from", "left"}, {"to", "right"}, {"via", std::string("left;") + text + " x"}});
      QVERIFY2(error.code == CellError::WaypointMissing, text);
      QCOMPARE(error.arguments, std::vector<std::string>{std::string(text) + " x"});
    }
    QVERIFY(refusal({{"from", "left"}, {"to", "0 3 0 0 0 0"}}).code == ErrorCode::ValueOutOfRange);
    // The name of another robot's configuration is refused.
    auto two =
        withRobotAdded(m_cell->content(), {cellOf(*libraryTable("ur5")), "second", poseOf({0, 3000, 0}, Vec3::Zero())});
    QVERIFY(two.hasValue());
    CellPlans plans = *two->plans;
    plans.configurations.push_back({"other", two->joints, "second"});
    two->plans = std::make_shared<const CellPlans>(plans);
    CollisionMeshes meshes;
    const auto other = waypointCalled(*sceneOf(*two, meshes), *two, "other", two->joints);
    QVERIFY(!other && other.error().code == CellError::OfOtherArm);
    QCOMPARE(other.error().arguments, (std::vector<std::string>{"other", "second"}));
  }

  void settings() {
    CellPlans plans;
    plans.clearance = 3.0;
    OperationValues values = planValues({});
    const RouteSettings standard = routeSettingsOf(values, plans);
    QCOMPARE(standard.planner, planners().front().id);
    QCOMPARE(standard.plan.check.clearance, 3.0);
    QCOMPARE(standard.plan.seconds, 10.0);
    const RobotPath own{.name = "own", .waypoints = {}, .clearance = 8.0};
    QCOMPARE(checkSettingsOf(values, plans, own).clearance, 8.0);
    values.setValid("planner", 1.0);
    const std::pair<const char*, double> given[] = {
        {"clearance", 0.0}, {"resolution", 0.25}, {"time", 2.5}, {"seed", 7.0}, {"shortcuts", 12.0}};
    for (const auto& [id, value] : given) values.setValid(id, value);
    const RouteSettings chosen = routeSettingsOf(values, plans);
    QCOMPARE(chosen.planner, planners()[1].id);
    QCOMPARE(chosen.plan.check.clearance, 0.0);
    QCOMPARE(chosen.plan.check.resolution, 0.25);
    QCOMPARE(chosen.plan.seconds, 2.5);
    QVERIFY(chosen.plan.seed == 7 && chosen.shortcuts == 12);
    QCOMPARE(checkSettingsOf(values, plans, own).clearance, 0.0);
  }

  // A proof is never coarser than verification's own.
  void resolutionOfTheProof() {
    OperationValues values = planValues({});
    const double own = PathCheckSettings().resolution;
    for (const double wanted : {0.5 * own, 2.0 * own}) {
      values.setValid("resolution", wanted);
      QCOMPARE(checkSettingsOf(values, {}, {}).resolution, std::min(own, wanted));
    }
    FidelityValues chosen;
    QVERIFY(chosen.set(planResolutionSetting(), planResolutionSetting().largest).hasValue());
    QVERIFY(chosen.set(planShortcutsSetting(), 5.0).hasValue());
    setFidelity(values, chosen);
    QCOMPARE(values.number("resolution"), planResolutionSetting().largest);
    QCOMPARE(values.whole("shortcuts"), std::size_t{5});
  }

  void tooFewWaypoints() {
    const std::vector<Waypoint> one{{.joints = kLeft}};
    QVERIFY(planned(one).error().code == CellError::PathTooShort);
  }

  // The invalid waypoint, with the joint or the obstacle there; a waypoint without a name by its number.
  void waypointsThatCannotBe() {
    JointValues beyond = kRight;
    beyond[2] = 2.0;  // joint 3 ends at 70 degrees
    std::vector<Waypoint> waypoints{{.joints = kLeft, .name = "start"}, {.joints = beyond}};
    const auto limits = planned(waypoints);
    QVERIFY(!limits && limits.error().code == CellError::WaypointBeyondLimits);
    QCOMPARE(limits.error().arguments, (std::vector<std::string>{"place 2", "joint_3"}));
    std::swap(waypoints[0].joints, waypoints[1].joints);
    QCOMPARE(planned(waypoints).error().arguments, (std::vector<std::string>{"start", "joint_3"}));
    waypoints[0].joints = kRight;
    waypoints[1] = {.joints = kLeft, .name = "goal"};
    m_cell->addBox({60, 60, 60}, toolAt(kLeft));
    const auto met = planned(waypoints);
    QVERIFY(!met && met.error().code == CellError::WaypointCollides);
    QCOMPARE(met.error().arguments.front(), std::string("goal"));
    QCOMPARE(met.error().arguments.back(), std::string("box1"));
  }

  // A line that the arm cannot follow, one that meets something, and one that only passes too near.
  void linesThatCannotBe() {
    JointValues behind = kRight;
    behind[0] = 2.6;
    std::vector<Waypoint> waypoints{{.joints = kLeft, .name = "start"},
                                    {.joints = behind, .name = "end", .motion = ProgramMotion::Kind::Linear}};
    const auto broken = planned(waypoints);
    QVERIFY(!broken && broken.error().code == CellError::LineUnreachable);
    QCOMPARE(broken.error().arguments[0], std::string("end"));
    waypoints[1].joints = kRight;
    QVERIFY(planned(waypoints).hasValue());
    const Vec3 middle = 0.5 * (toolAt(kLeft) + toolAt(kRight));
    m_cell->addBox({20, 20, 20}, middle);
    const auto met = planned(waypoints);
    QVERIFY(!met && met.error().code == CellError::LineCollides);
    QCOMPARE(met.error().arguments.front(), std::string("end"));
    QCOMPARE(met.error().arguments.back(), std::string("box1"));
    ArmCell aside;
    aside.addBox({20, 20, 20}, middle - Vec3(0.0, 0.0, 200.0));
    RouteSettings settings;
    settings.plan.check.clearance = 195.0;
    const auto near = plannedThrough(*aside.scene(), {}, waypoints, settings);
    QVERIFY(!near && near.error().code == CellError::LineTooNear);
    QCOMPARE(near.error().arguments.size(), std::size_t{4});
    const double distance = std::stod(near.error().arguments[3]);
    QVERIFY(distance > 0.0 && distance < 195.0);
  }

  // Behind walls there is no path, and the planner gives up in time; cancelled it ends at once.
  void noRoute() {
    for (const double side : {1.0, -1.0}) m_cell->addBox({1000, 20, 3000}, {side * 650.0, 0, 0});
    m_cell->addBox({310, 310, 20}, {0, 0, 760});  // else it could fold upright between the walls
    const std::vector<Waypoint> waypoints{{.joints = kLeft, .name = "start"}, {.joints = kRight, .name = "goal"}};
    RouteSettings settings;
    settings.plan.seconds = 0.05;
    const auto none = plannedThrough(*m_cell->scene(), {}, waypoints, settings);
    QVERIFY2(
        !none && none.error().code == CellError::RouteNotFound,
        none ? "found" : (none.error().arguments[0] + none.error().arguments[1] + none.error().arguments[2]).c_str());
    QCOMPARE(none.error().arguments, (std::vector<std::string>{"start", "goal", "0.05"}));
    JobState state;
    state.cancelled = true;
    const auto cancelled = plannedThrough(*m_cell->scene(), {}, waypoints, {}, Progress(state));
    QVERIFY(!cancelled && cancelled.error().code == ErrorCode::Cancelled);
  }

 private:
  using Words = std::vector<std::pair<const char*, std::string>>;
  std::vector<Waypoint> waypoints(const Words& words) {
    auto made = waypointsOf(planValues(words), *m_cell->scene(), m_cell->content());
    if (!made) qFatal("no places: %s", made.error().code->id);
    return std::move(made).value();
  }
  Error refusal(const Words& words) {
    const auto made = waypointsOf(planValues(words), *m_cell->scene(), m_cell->content());
    return made ? Error{} : made.error();
  }
  Result<PlannedPath> planned(const std::vector<Waypoint>& waypoints) {
    return plannedThrough(*m_cell->scene(), *m_cell->content().plans, waypoints, {});
  }
  Vec3 toolAt(const JointValues& joints) {
    return m_cell->scene()->arm.tipPose(m_cell->scene()->planned(joints)).translation();
  }

  std::unique_ptr<ArmCell> m_cell;
};

HANDWHEEL_TEST(PlanWaypointsTest)
#include "PlanWaypointsTest.moc"
