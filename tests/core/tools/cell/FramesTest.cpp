// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ArmCell.h"
#include "TestClass.h"
#include "document/cell/BodyCarriers.h"
#include "document/cell/CellErrors.h"
#include "document/cell/CellFrames.h"
#include "document/cell/RobotChanges.h"
#include "document/scene/BodyErrors.h"
#include "robot/dh/DhTable.h"
#include "tools/cell/ConfigurationOperation.h"
#include "tools/cell/path/PathExport.h"
#include "tools/cell/path/PlanOperation.h"

#include <QFile>
#include <QTemporaryDir>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using FrameValues = std::vector<std::pair<const char*, PropertyValue>>;

OperationValues frameValues(const FrameValues& list) {
  OperationValues values(configurationOperation());
  for (const auto& [id, value] : list) values.setValid(id, value);
  return values;
}

// The plans after the operation "configuration" with these values.
CellPlans plansAfter(const OperationValues& values, const RobotCellSnapshot& cell) {
  Result<ChangedCell> changed = changedCell(values, cell);
  if (!changed) qFatal("refused: %s", changed.error().code->id);
  return std::move(changed->plans);
}

RobotCellSnapshot withPlans(RobotCellSnapshot cell, CellPlans plans) {
  cell.plans = std::make_shared<const CellPlans>(std::move(plans));
  return cell;
}

}  // namespace

// Named frames: stored, used by planning, and by programs.
class FramesTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    m_cell = std::make_unique<ArmCell>();
    m_cell->stand({0.3, 0.4, 0.2, 0.5, 0.8, -0.3});
  }

  // From the tool, from numbers, on a body, on a link; replaced, and removed with the targets kept.
  void storeAndRemove() {
    m_cell->addBox({20, 20, 20}, {200, 300, 0}, {0, 0, 0.7});
    RobotCellSnapshot cell = m_cell->content();
    cell = withPlans(cell, plansAfter(frameValues({{"add-frame", std::string("F")}}), cell));
    QVERIFY(cell.plans->frame("F")->pose.isApprox(m_cell->tool(), 1e-12));
    OperationValues onBox = frameValues({{"add-frame", std::string("G")}, {"on", std::string("box1")}});
    onBox.setValid("at", std::vector<double>{350.0, 40.0, 300.0});
    cell = withPlans(cell, plansAfter(onBox, cell));
    const CellPlacement at{*cell.plans, cell.bodies, cell.robot->model, cell.joints};
    QVERIFY((poseOfFrame("G", at)->translation() - Vec3(350.0, 40.0, 300.0)).norm() < 1e-9);
    QCOMPARE(cell.plans->frame("G")->body, cell.bodies.withName("box1")->id);
    const std::string link = cell.robot->model.links.back().name;
    const CellPlans linked = plansAfter(frameValues({{"add-frame", std::string("F")}, {"link", link}}), cell);
    QCOMPARE(linked.frames.size(), std::size_t{2});
    QCOMPARE(linked.frame("F")->link, link);
    OperationValues target = frameValues({{"add-target", std::string("T")}, {"in", std::string("G")}});
    cell = withPlans(cell, plansAfter(target, cell));
    QCOMPARE(cell.plans->target("T")->frame, std::string("G"));
    const CellPlans left = plansAfter(frameValues({{"remove-frame", std::string("G")}}), cell);
    QVERIFY(!left.frame("G") && left.target("T")->body == cell.bodies.withName("box1")->id);
    QVERIFY(poseOfTarget(left.targets[0], {left, cell.bodies, cell.robot->model, cell.joints})
                ->isApprox(m_cell->tool(), 1e-9));
  }

  void refused() {
    const RobotCellSnapshot cell = m_cell->content();
    const auto code = [&](const FrameValues& list) {
      const Result<ChangedCell> changed = changedCell(frameValues(list), cell);
      return changed ? std::string() : std::string(changed.error().code->id);
    };
    const std::string name = "F";
    QCOMPARE(code({{"remove-frame", name}}), std::string(CellError::FrameMissing.id));
    QCOMPARE(code({{"add-target", name}, {"in", name}}), std::string(CellError::FrameMissing.id));
    QCOMPARE(code({{"add-frame", name}, {"on", name}}), std::string(BodyError::BodyMissing.id));
    QCOMPARE(code({{"add-frame", name}, {"link", std::string("none")}}), std::string(ErrorCode::ReferenceMissing.id));
    QCOMPARE(code({{"add-frame", std::string("two\nlines")}}), std::string(BodyError::NameUnusable.id));
    const FrameValues unfit[] = {{{"link", name}, {"go", name}},
                                 {{"in", name}, {"add-frame", name}},
                                 {{"on", name}, {"in", name}, {"add-target", name}},
                                 {{"on", name}, {"link", name}, {"add-frame", name}},
                                 {{"add-frame", name}, {"remove-frame", name}}};
    for (const FrameValues& list : unfit) QVERIFY(!problemOfConfigurationValues(frameValues(list)).empty());
  }

  // Planning goes to where a target is with its frame.
  void planningFollows() {
    const Pose there = m_cell->tool();
    const BodyId box = m_cell->addBox({20, 20, 20}, {-500, -500, 0});
    CellPlans plans;
    plans.frames = {{"F", Pose::Identity(), box}};
    plans.targets = {{"T", m_cell->document().bodies().withId(box)->pose.inverse(Eigen::Isometry) * there, 0, "F"}};
    m_cell->plan(plans);
    const auto tip = [&] {
      const auto scene = m_cell->scene();
      const auto waypoint = waypointCalled(*scene, m_cell->content(), "T", m_cell->document().joints());
      return waypoint ? Pose(scene->arm.tipPose(scene->planned(waypoint->joints))) : Pose(Pose::Identity());
    };
    QVERIFY(tip().isApprox(there, 1e-6));
    QVERIFY(m_cell->document().setProperty("body." + std::to_string(box) + ".z", 15.0).hasValue());
    QVERIFY((tip().translation() - there.translation() - Vec3(0, 0, 15)).norm() < 1e-4);
    QVERIFY(m_cell->document().setProperty("frame.F.z", -5.0).hasValue());
    QVERIFY((tip().translation() - there.translation() - Vec3(0, 0, 10)).norm() < 1e-4);
  }

  // The frame in the base of the robot that the program is for, also where that stands beside the origin.
  void programFrames() {
    const BodyId box = m_cell->addBox({20, 20, 20}, {-400, -500, 0}, {0, 0, 0.5 * M_PI});
    CellPlans plans;
    plans.frames = {{"F", poseOf({0, 0, 100}, Vec3::Zero()), box}};
    plans.workFrame = "F";
    RobotCellSnapshot cell = withPlans(m_cell->content(), plans);
    CollisionMeshes meshes;
    const Pose inRoot = poseOf({-400, -500, 100}, {0, 0, 0.5 * M_PI});
    QVERIFY(programFrame(*sceneOf(cell, meshes), plans)->isApprox(inRoot, 1e-12));
    const Pose base = poseOf({0, 4000, 200}, {0, 0, -0.5 * M_PI});
    const Result<RobotCellSnapshot> two = withRobotAdded(cell, {cellOf(*libraryTable("ur5")), "second", base});
    QVERIFY(two.hasValue());
    const CellPlans ofSecond = *withArmChosen(*two->robot, *two->plans, "second");
    const Result<CellScene> scene = sceneOf(withPlans(*two, ofSecond), meshes);
    QVERIFY(programFrame(*scene, ofSecond)->isApprox(base.inverse(Eigen::Isometry) * inRoot, 1e-7));
  }

  // A frame that the robot itself moves is none to write in; one that another robot carries is where that stands.
  void movingFrames() {
    CellPlans plans;
    const RobotModel& robot = m_cell->document().robot().model;
    plans.frames = {{"moves", Pose::Identity(), 0, robot.links[m_cell->document().robot().arms[0].flange].name},
                    {"foot", Pose::Identity(), 0, robot.links[robot.root].name}};
    const auto frameOf = [&](const char* name) {
      plans.workFrame = name;
      return programFrame(*m_cell->scene(), plans);
    };
    QVERIFY(frameOf("moves").error().code == CellError::FrameMoves);
    QVERIFY(frameOf("foot")->isApprox(Pose::Identity(), 1e-12));
    QVERIFY(frameOf("none").error().code == CellError::FrameMissing);
    QVERIFY(frameOf("")->isApprox(Pose::Identity(), 0.0));
    plans.frames.push_back({"stray", Pose::Identity(), 77});
    QVERIFY(frameOf("stray").error().code == CellError::FrameStray);
  }

 private:
  std::unique_ptr<ArmCell> m_cell;
};

HANDWHEEL_TEST(FramesTest)
#include "FramesTest.moc"
