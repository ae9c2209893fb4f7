// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ArmCell.h"
#include "TestClass.h"
#include "document/cell/BodyCarriers.h"
#include "document/cell/CellErrors.h"
#include "document/cell/CellFrames.h"
#include "document/cell/path/OutdatedReasons.h"
#include "robot/program/PathFile.h"
#include "tools/cell/ConfigurationOperation.h"
#include "tools/cell/path/PlanOperation.h"

#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// The cell after the operation "configuration" with these values.
RobotCellSnapshot changedBy(const OperationValues& values, const RobotCellSnapshot& cell) {
  Result<ChangedCell> changed = changedCell(values, cell);
  if (!changed) qFatal("refused: %s", changed.error().code->id);
  RobotCellSnapshot after = cell;
  after.plans = std::make_shared<const CellPlans>(std::move(changed->plans));
  after.joints = changed->joints;
  return after;
}

OperationValues operationValues(std::initializer_list<std::pair<const char*, PropertyValue>> list) {
  OperationValues values(configurationOperation());
  for (const auto& [id, value] : list) values.setValid(id, value);
  return values;
}

}  // namespace

// Frames that the tool is brought to, kept in a cell.
class TargetsTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    m_cell = std::make_unique<ArmCell>();
    m_cell->stand({0.3, 0.4, 0.2, 0.5, 0.8, -0.3});
  }

  // Stored where the tool is, gone away from and come back to.
  void storeAndComeBack() {
    const Pose there = m_cell->tool();
    RobotCellSnapshot cell = changedBy(operationValues({{"add-target", std::string("T")}}), m_cell->content());
    QVERIFY(cell.plans->target("T")->pose.isApprox(there, 1e-12));
    const JointValues stored = cell.joints;
    cell.joints[0] += 0.5;
    cell = changedBy(operationValues({{"go", std::string("T")}}), cell);
    QVERIFY((cell.joints - stored).cwiseAbs().maxCoeff() < 1e-6);  // The nearest solution
    cell = changedBy(operationValues({{"remove-target", std::string("T")}}), cell);
    QVERIFY(cell.plans->targets.empty());
  }

  // On a body it moves with that.
  void onABody() {
    const BodyId box = m_cell->addBox({20, 20, 20}, {200, 300, 0}, {0, 0, 0.7});
    OperationValues values = operationValues({{"add-target", std::string("T")}, {"on", std::string("box1")}});
    values.setValid("at", std::vector<double>{350.0, 40.0, 300.0});
    RobotCellSnapshot cell = changedBy(values, m_cell->content());
    const NamedTarget target = *cell.plans->target("T");
    QCOMPARE(target.body, box);
    const RobotModel& robot = cell.robot->model;
    const Pose before = *poseOfTarget(target, {*cell.plans, cell.bodies, robot, cell.joints});
    QVERIFY((before.translation() - Vec3(350.0, 40.0, 300.0)).norm() < 1e-9);
    Body moved = *cell.bodies.withId(box);
    const Pose displacement = poseOf({10.0, -5.0, 3.0}, {0.1, 0.2, 0.3});
    moved.pose = displacement * moved.pose;
    cell.bodies = cell.bodies.with(std::make_shared<const Body>(moved));
    QVERIFY(
        poseOfTarget(target, {*cell.plans, cell.bodies, robot, cell.joints})->isApprox(displacement * before, 1e-12));
    const BodyId gone[] = {box};
    m_cell->document().commit("Remove", removeBodiesEdit(m_cell->document().bodies(), gone));
    const auto stray = poseOfTarget(target, {*cell.plans, m_cell->document().bodies(), robot, cell.joints});
    QVERIFY(!stray && stray.error().code == CellError::TargetStray);
  }

  // A box blocks the nearest solution: another one is taken, and it is free.
  void theNearestFreeSolution() {
    const auto scene = m_cell->scene();
    const Pose pose = m_cell->tool();
    const ArmValues stood = scene->planned(m_cell->document().joints());
    CellPlans plans;
    QVERIFY((*nearestFree(*scene, plans, pose, stood) - stood).cwiseAbs().maxCoeff() < 1e-6);
    // The elbow: position of the third joint.
    std::array<Pose, 6> joints;
    scene->arm.jointPoses(stood, joints);
    m_cell->addBox({60, 60, 60}, joints[2].translation());
    const auto blocked = m_cell->scene();
    const Result<ArmValues> other = nearestFree(*blocked, plans, pose, stood);
    if (!other) {  // In either case it names the obstacle
      QVERIFY(other.error().code == CellError::ToolBlocked);
      QCOMPARE(other.error().arguments.back(), std::string("box1"));
    } else {
      QVERIFY((*other - stood).cwiseAbs().maxCoeff() > 0.1);
      QVERIFY(blocked->scene.isFree(*other, 0.0, 0.0));
      QVERIFY((blocked->arm.tipPose(*other) * plans.tool).isApprox(pose, 1e-6));
    }
    Pose far = pose;
    far.translation().x() = 1e4;
    QVERIFY(nearestFree(*scene, plans, far, stood).error().code == CellError::ToolOutOfReach);
  }

  // An arm of three joints brings its tool to the position of a target, turned as near to it as possible; a target out
  // of its reach stays unreachable.
  void anArmOfThreeJoints() {
    const DhTable table{.name = "short",
                        .joints = {{{.alpha = M_PI / 2, .d = 200.0, .lower = -3.0, .upper = 3.0}, "a"},
                                   {{.a = 300.0, .lower = -2.0, .upper = 2.0}, "b"},
                                   {{.a = 250.0, .lower = -2.5, .upper = 2.5}, "c"}}};
    ArmCell arm(table);
    arm.stand({0.3, 0.4, 1.1});
    CellPlans plans;
    plans.tool = Pose(Eigen::Translation3d(30.0, 40.0, 20.0));
    plans.targets = {{"T", poseOf(arm.tool().translation() + Vec3(-40.0, 50.0, 60.0), {0.1, 0.9, -2.0})}};
    arm.plan(plans);
    const RobotCellSnapshot cell = changedBy(operationValues({{"go", std::string("T")}}), arm.content());
    const Pose reached = toolPose(*cell.robot, *cell.plans, cell.joints), wanted = plans.targets[0].pose;
    QVERIFY((reached.translation() - wanted.translation()).norm() < 1e-3);
    const auto scene = arm.scene();
    const auto solutions = ikSolutionsTo(*scene, plans, wanted, scene->planned(arm.document().joints()));
    QVERIFY(!solutions.empty());
    const double off = Eigen::AngleAxisd(reached.linear().transpose() * wanted.linear()).angle();
    QVERIFY(off > 0.1);
    QVERIFY(std::any_of(solutions.begin(), solutions.end(),
                        [&](const CellIkSolution& solution) { return std::abs(solution.arm.turnedOff - off) < 1e-6; }));
    Pose far = wanted;
    far.translation() *= 10.0;
    QVERIFY(nearestFree(*scene, plans, far, ArmValues::Zero(3)).error().code == CellError::ToolOutOfReach);
  }

  // Targets as waypoints of a path; each as near as possible to the one before.
  void waypointsOfAPath() {
    CellPlans plans;
    plans.targets = {{"A", m_cell->tool()}};
    Pose other = m_cell->tool();
    other.translation() += Vec3(-30.0, 20.0, 10.0);
    plans.targets.push_back({"B", other});
    m_cell->plan(plans);
    OperationValues values(planOperation());
    values.setValid("from", std::string("A"));
    values.setValid("to", std::string("B"));
    const auto scene = m_cell->scene();
    const auto waypoints = waypointsOf(values, *scene, m_cell->content());
    QVERIFY(waypoints.hasValue());
    QCOMPARE(waypoints->size(), std::size_t{2});
    QCOMPARE(waypoints->back().name, std::string("B"));
    const ArmValues at = scene->planned(waypoints->back().joints);
    QVERIFY(scene->arm.tipPose(at).isApprox(other, 1e-6));
    QVERIFY((at - scene->planned(waypoints->front().joints)).cwiseAbs().maxCoeff() < 0.5);
    values.setValid("to", std::string("C"));
    QVERIFY(waypointsOf(values, *scene, m_cell->content()).error().code == CellError::WaypointMissing);
  }

  // A path that was planned to a target is outdated once the tool does not come to that any more: the numbers of the
  // target, its frame or its body have changed, or the tool has. Planned again it comes there, and begins where it did.
  void aPathWhoseTargetHasMoved_data() {
    QTest::addColumn<int>("what");
    QTest::newRow("target") << 0;
    QTest::newRow("frame") << 1;
    QTest::newRow("body") << 2;
    QTest::newRow("tool") << 3;
  }
  void aPathWhoseTargetHasMoved() {
    QFETCH(const int, what);
    const BodyId box = m_cell->addBox({20, 20, 20}, {-300, -300, -300});
    const Pose frame = poseOf({100, 50, 20}, {0, 0, 0.3}), body = poseOf({-300, -300, -300}, Vec3::Zero());
    Pose there = m_cell->tool();
    there.translation() += Vec3(-30.0, 20.0, 10.0);
    CellPlans plans;
    plans.frames = {{"F", frame}};
    plans.targets = {what == 2 ? NamedTarget{"T", body.inverse(Eigen::Isometry) * there, box}
                               : NamedTarget{"T", frame.inverse(Eigen::Isometry) * there, 0, "F"}};
    m_cell->plan(plans);
    const RobotPath path = plannedTo({{.joints = m_cell->document().joints()}, called("T")});
    QVERIFY(path.waypoints.back().target && isSamePose(path.waypoints.back().target->inTool, Pose::Identity()));
    QVERIFY(!outdated(path).isAny());
    const Vec3 by(10.0, -5.0, 3.0);
    if (what == 0) plans.targets[0].pose.pretranslate(frame.linear().transpose() * by);
    if (what == 1) plans.frames[0].pose.pretranslate(by);
    if (what == 2) {
      Body moved = *m_cell->document().bodies().withId(box);
      moved.pose.pretranslate(by);
      m_cell->document().commit("Move", std::move(changeBodyEdit(m_cell->document().bodies(), moved)).value());
    }
    if (what == 3) plans.tool.translation().z() = 8.0;
    m_cell->plan(plans);
    QVERIFY((outdated(path) == OutdatedReasons{.targets = {"T"}}));
    const RobotPath again = plannedTo(path.waypoints);
    QVERIFY(!outdated(again).isAny());
    const Pose reached = toolPose(m_cell->document().robot(), plans, again.waypoints.back().joints);
    if (what < 3) there.pretranslate(by);
    QVERIFY(reached.isApprox(there, 1e-6));
    QVERIFY(again.waypoints.front().joints == path.waypoints.front().joints);
    // In files, and by another name of the target.
    const RobotModel& robot = m_cell->document().robot().model;
    const auto read = pathFrom(toJson(robot, path), robot, m_cell->document().joints());
    QVERIFY(read && *read == path);
    plans.paths = {path};
    const CellPlans renamed = withTargetRenamed(plans, "T", "U");
    m_cell->plan(renamed);
    QCOMPARE(renamed.paths[0].waypoints.back().name, std::string("U"));
    QVERIFY((outdated(renamed.paths[0]) == OutdatedReasons{.targets = {"U"}}));
    m_cell->plan(withoutTarget(renamed, "U"));
    QVERIFY(!m_cell->document().plans()->paths[0].waypoints.back().target);
    QVERIFY(!outdated(renamed.paths[0]).isAny());
  }

  // So is one through a configuration that is other joint values now, also where it was removed and stored anew; not
  // where it is missing. Planned again it goes there.
  void aPathWhoseConfigurationHasChanged() {
    CellPlans plans;
    plans.configurations = {{"home", m_cell->document().joints()}, {"away", m_cell->document().joints()}};
    plans.configurations[1].joints[0] += 0.4;
    m_cell->plan(plans);
    RobotPath path = plannedTo({called("home"), called("away")});
    QVERIFY(!outdated(path).isAny());
    CellPlans without = plans;
    without.configurations.erase(without.configurations.begin());
    m_cell->plan(without);
    QVERIFY(!outdated(path).isAny());
    plans.configurations[0].joints[0] += 0.5e-3 * M_PI / 180.0;  // half of what programs are read back to
    m_cell->plan(plans);
    QVERIFY(!outdated(path).isAny());
    plans.configurations[0].joints[0] -= 0.2;
    m_cell->plan(plans);
    QVERIFY((outdated(path) == OutdatedReasons{.configurations = {"home"}}));
    const RobotPath again = plannedTo(path.waypoints);
    QVERIFY(!outdated(again).isAny());
    QVERIFY(again.waypoints.front().joints == plans.configurations[0].joints);
    QVERIFY(again.waypoints.back().joints == path.waypoints.back().joints);
    // In files, and by another name.
    const RobotModel& robot = m_cell->document().robot().model;
    const auto read = pathFrom(toJson(robot, path), robot, m_cell->document().joints());
    QVERIFY(read && *read == path);
    path.name = "way";
    path.process = PathProcess{{{"from", std::string("home")}, {"part", std::string("home")}}};
    plans.paths = {path, {"other", {path.waypoints.back()}}};
    QVERIFY((pathsThrough(plans, "home") == std::vector<std::string>{"way"}));
    const CellPlans renamed = withConfigurationRenamed(plans, "home", "base");
    m_cell->plan(renamed);
    const RobotPath& kept = renamed.paths[0];
    QVERIFY(renamed.configuration("base") && !renamed.configuration("home"));
    QCOMPARE(kept.waypoints.front().name, std::string("base"));
    QVERIFY((outdated(kept) == OutdatedReasons{.configurations = {"base"}}));
    QVERIFY(kept.process->values.at("from") == PathProcess::Value(std::string("base")));
    QVERIFY(kept.process->values.at("part") == PathProcess::Value(std::string("home")));
    QVERIFY(renamed.paths[1] == plans.paths[1]);
  }

  // A name denotes one waypoint.
  void namesAreUnique() {
    const RobotCellSnapshot cell = changedBy(operationValues({{"add", std::string("home")}}), m_cell->content());
    const auto refused = changedCell(operationValues({{"add-target", std::string("home")}}), cell);
    QVERIFY(!refused && refused.error().code == CellError::WaypointNameTaken);
    QCOMPARE(cell.plans->freePoseName("home"), std::string("home 2"));
  }

  // Its numbers are properties, of the frame that it is in.
  void numbersOfATarget() {
    const BodyId box = m_cell->addBox({20, 20, 20}, {200, 300, 0}, {0, 0, 0.7});
    CellPlans plans;
    plans.targets = {{"drop.off", poseOf({10, 20, 30}, {0.1, 0.2, 0.3}), box}};
    m_cell->plan(plans);
    RobotCellDocument& document = m_cell->document();
    QCOMPARE(std::get<double>(document.property("target.drop.off.y")->value), 20.0);
    QVERIFY(!document.property("target.drop.off.w") && !document.property("target.other.x"));
    const int steps = m_cell->steps();
    QVERIFY(document.setProperty("target.drop.off.rz", -0.4).hasValue());
    QCOMPARE(m_cell->steps(), steps + 1);
    const NamedTarget changed = *document.plans()->target("drop.off");
    QVERIFY(changed.pose.isApprox(poseOf({10, 20, 30}, {0.1, 0.2, -0.4}), 1e-12));
    QCOMPARE(changed.body, box);
    QVERIFY(document.setProperty("target.other.x", 1.0).error().code == ErrorCode::ReferenceMissing);
    QVERIFY(document.setProperty("target.drop.off.x", 1e9).error().code == ErrorCode::ValueOutOfRange);
    QVERIFY(document.setProperty("target.drop.off.x", std::nan("")).error().code == ErrorCode::ElementMalformed);
  }

  // A pose of the tool by one property at a time, as in the panel and in `set`.
  void typedPose() {
    RobotCellDocument& document = m_cell->document();
    const Vec3 before = m_cell->tool().translation();
    const int steps = m_cell->steps();
    QVERIFY(document.setProperty("tool.y", before.y() + 15.0).hasValue());
    QCOMPARE(m_cell->steps(), steps + 1);
    QVERIFY((m_cell->tool().translation() - before - Vec3(0.0, 15.0, 0.0)).norm() < 1e-6);
    const Status far = document.setProperty("tool.x", 5000.0);
    QVERIFY(!far && far.error().code == CellError::ToolOutOfReach);
    QCOMPARE(far.error().arguments[0], std::string("5000"));
    // Straight up the sixth joint of this arm can turn the tool through a full turn; behind its foot the first cannot.
    QVERIFY(document.setProperty("tool.rz", 0.2).hasValue());
    QVERIFY(std::abs(rollPitchYaw(m_cell->tool()).z() - 0.2) < 1e-6);
  }

 private:
  Waypoint called(const char* waypoint) {
    const auto found = waypointCalled(*m_cell->scene(), m_cell->content(), waypoint, m_cell->document().joints());
    if (!found) qFatal("refused: %s", found.error().code->id);
    return *found;
  }
  RobotPath plannedTo(const std::vector<Waypoint>& waypoints) {
    const auto made = plannedThrough(*m_cell->scene(), *m_cell->document().plans(), waypoints, {});
    if (!made) qFatal("not planned: %s", made.error().code->id);
    return made->path;
  }
  OutdatedReasons outdated(const RobotPath& path) {
    return outdatedReasonsOf(m_cell->document().robot(), m_cell->document().placement(), path);
  }

  std::unique_ptr<ArmCell> m_cell;
};

HANDWHEEL_TEST(TargetsTest)
#include "TargetsTest.moc"
