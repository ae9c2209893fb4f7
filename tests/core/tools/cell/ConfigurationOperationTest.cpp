// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/ConfigurationOperation.h"

#include "ArmCell.h"
#include "TestClass.h"
#include "document/cell/CellArms.h"
#include "document/cell/CellErrors.h"
#include "document/cell/RobotChanges.h"
#include "document/scene/BodyErrors.h"
#include "tools/cell/path/PairNames.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using GivenWords = std::vector<std::pair<const char*, std::string>>;

OperationValues configurationValues(const GivenWords& words) {
  OperationValues values(configurationOperation());
  for (const auto& [id, word] : words) values.setValid(id, word);
  return values;
}

RobotCellSnapshot withConfigurations(RobotCellSnapshot cell, std::vector<NamedConfiguration> all) {
  CellPlans plans = *cell.plans;
  plans.configurations = std::move(all);
  cell.plans = std::make_shared<const CellPlans>(std::move(plans));
  return cell;
}

}  // namespace

// Joint values under names, and what planning goes by.
class ConfigurationOperationTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    m_cell = std::make_unique<ArmCell>();
    m_cell->stand({0.3, 0.4, 0.2, 0.5, 0.8, -0.3});
  }

  // One thing at a time, and nothing that has no effect.
  void valuesThatFitTogether() {
    const GivenWords fit[] = {{},
                              {{"add", "a"}, {"joints", "joint_1=0"}},
                              {{"go", "a"}, {"joints", "joint_1=0"}},
                              {{"add-target", "a"}, {"on", "box1"}},
                              {{"allow", "base,box1"}}};
    for (const GivenWords& words : fit)
      QCOMPARE(problemOfConfigurationValues(configurationValues(words)), std::string());
    const std::pair<GivenWords, std::string> unfit[] = {
        {{{"add", "a"}, {"go", "a"}}, "only one of add, remove, go"},
        {{{"remove", "a"}, {"remove-path", "a"}}, "only one of add, remove, go"},
        {{{"go", "a"}, {"at", "1,2,3"}}, "go moves to a stored place"},
        {{{"go", "a"}, {"turn", "0.1,0.2,0.3"}}, "go moves to a stored place"},
        {{{"on", "box1"}}, "on needs"},
        {{{"allow", "base"}}, "allow takes two names"},
        {{{"forbid", "base"}}, "forbid takes two names"},
        {{{"joints", "joint_1=0"}}, "joints needs add or go"}};
    for (const auto& [words, begin] : unfit) {
      const std::string problem = problemOfConfigurationValues(configurationValues(words));
      QVERIFY2(problem.starts_with(begin), problem.c_str());
    }
    OperationValues chosen = configurationValues({{"add-target", "a"}});
    chosen.setValid("solution", 2.0);
    QVERIFY(problemOfConfigurationValues(chosen).starts_with("solution chooses"));
  }

  // Stores the present joint values, or others; a configuration of that name is replaced.
  void stored() {
    const RobotCellSnapshot cell = m_cell->content();
    const auto once = changedCell(configurationValues({{"add", "A"}}), cell);
    QVERIFY(once && once->plans.configurations == (std::vector<NamedConfiguration>{{"A", cell.joints, ""}}));
    JointValues other = cell.joints;
    other[0] = 0.5;
    other[3] = -1.25;
    const RobotCellSnapshot one = withConfigurations(cell, once->plans.configurations);
    const auto twice = changedCell(configurationValues({{"add", "A"}, {"joints", "joint_1=0.5,joint_4=-1.25"}}), one);
    QVERIFY(twice && twice->plans.configurations == (std::vector<NamedConfiguration>{{"A", other, ""}}));
    QCOMPARE(twice->joints, cell.joints);  // the robot itself stays
  }

  void jointsThatCannotBe() {
    const auto errorOf = [&](const std::string& joints) {
      const auto changed = changedCell(configurationValues({{"add", "A"}, {"joints", joints}}), m_cell->content());
      return changed ? Error{} : changed.error();
    };
    QVERIFY(errorOf("elbow=1").code == ErrorCode::ReferenceMissing);
    QCOMPARE(errorOf("elbow=1").arguments[1], std::string("elbow"));
    for (const std::string word : {"joint_2", "joint_2=", "joint_2=far"}) {
      QVERIFY(errorOf("joint_1=0," + word).code == ErrorCode::NumberMalformed);
      QCOMPARE(errorOf("joint_1=0," + word).arguments, std::vector<std::string>{word});
    }
    QVERIFY(errorOf("joint_2=3").code == ErrorCode::ValueOutOfRange);  // it ends at 110 degrees
  }

  void namesThatCannotBe() {
    RobotCellSnapshot cell = m_cell->content();
    CellPlans plans;
    plans.targets = {{"T"}};
    cell.plans = std::make_shared<const CellPlans>(plans);
    const auto named = [&](const std::string& name) { return changedCell(configurationValues({{"add", name}}), cell); };
    QVERIFY(named("two\nlines").error().code == BodyError::NameUnusable);
    QVERIFY(named("T").error().code == CellError::WaypointNameTaken);
    QVERIFY(named("T2").hasValue());
  }

  // With two robots only the one whose joints are stored moves.
  void goneToAndRemoved() {
    auto two =
        withRobotAdded(m_cell->content(), {cellOf(*libraryTable("ur5")), "second", poseOf({0, 3000, 0}, Vec3::Zero())});
    QVERIFY(two.hasValue());
    const JointValues all = JointValues::Constant(12, 0.1);
    const RobotCellSnapshot cell = withConfigurations(*two, {{"A", all, ""}, {"B", all, "second"}});
    const auto joints = [&](const char* name) {
      return changedCell(configurationValues({{"go", name}}), cell)->joints;
    };
    JointValues first = cell.joints, second = cell.joints;
    for (const std::uint32_t dof : dofsOfArm(*cell.robot, 0)) first[dof] = 0.1;
    for (const std::uint32_t dof : dofsOfArm(*cell.robot, 1)) second[dof] = 0.1;
    QCOMPARE(joints("A"), first);
    QCOMPARE(joints("B"), second);
    const auto rest = changedCell(configurationValues({{"remove", "A"}}), cell);
    QVERIFY(rest && !rest->plans.configuration("A") && rest->plans.configuration("B"));
    QCOMPARE(rest->joints, cell.joints);
    for (const char* const verb : {"go", "remove"}) {
      const auto missing = changedCell(configurationValues({{verb, "C"}}), cell);
      QVERIFY(!missing && missing.error().code == CellError::WaypointMissing);
      QCOMPARE(missing.error().arguments, std::vector<std::string>{"C"});
    }
  }

  void pathsAreRemoved() {
    RobotCellSnapshot cell = m_cell->content();
    CellPlans plans;
    plans.paths = {{.name = "one", .waypoints = {}}, {.name = "two", .waypoints = {}}};
    cell.plans = std::make_shared<const CellPlans>(plans);
    const auto rest = changedCell(configurationValues({{"remove-path", "one"}}), cell);
    QVERIFY(rest && !rest->plans.path("one") && rest->plans.path("two"));
    QVERIFY(changedCell(configurationValues({{"remove-path", "three"}}), cell).error().code == CellError::PathMissing);
  }

  // Bodies by their names here, by their numbers in the plans; the order of the two does not matter.
  void pairsThatMayTouch() {
    const BodyId box = m_cell->addBox({20, 20, 20}, {500, 0, 0});
    RobotCellSnapshot cell = m_cell->content();
    const CellPlans before = *cell.plans;
    const auto allowed = changedCell(configurationValues({{"allow", "box1,link_2"}}), cell);
    QVERIFY(allowed && isAllowed(allowed->plans, {"link_2", "body." + std::to_string(box)}));
    cell.plans = std::make_shared<const CellPlans>(allowed->plans);
    const auto forbidden = changedCell(configurationValues({{"forbid", "link_2,box1"}}), cell);
    QVERIFY(forbidden && forbidden->plans.allowed == before.allowed);
    for (const char* const pair : {"link_2,box7", "box7,link_2"})
      QVERIFY(changedCell(configurationValues({{"allow", pair}}), cell).error().code == BodyError::BodyMissing);
  }

  void whatPlanningGoesBy() {
    OperationValues values = configurationValues({});
    values.setValid("clearance", 7.5);
    values.setValid("tool", std::vector<double>{1.0, -2.0, 120.0});
    CellPlans plans;
    plans.tool = poseOf({5, 5, 5}, {0.1, 0.2, 0.3});
    RobotCellSnapshot cell = m_cell->content();
    cell.plans = std::make_shared<const CellPlans>(plans);
    const auto changed = changedCell(values, cell);
    QVERIFY(changed.hasValue());
    QCOMPARE(changed->plans.clearance, 7.5);
    QCOMPARE(changed->plans.tool.translation(), Vec3(1.0, -2.0, 120.0));
    QCOMPARE(changed->plans.tool.linear(), plans.tool.linear());  // Only its position is set
  }

  // Each number is another solution for the present tool pose; beyond the last one there is none.
  void numberedSolutions() {
    const RobotCellSnapshot cell = m_cell->content();
    const Pose tool = m_cell->tool();
    std::vector<JointValues> found;
    OperationValues values = configurationValues({});
    for (;;) {
      values.setValid("solution", 1.0 + static_cast<double>(found.size()));
      const auto changed = changedCell(values, cell);
      if (!changed) {
        const std::string most = std::to_string(found.size()), number = std::to_string(found.size() + 1);
        QVERIFY(changed.error().code == ErrorCode::ValueOutOfRange);
        QCOMPARE(changed.error().arguments, (std::vector<std::string>{"solution", number, "1", most}));
        break;
      }
      QVERIFY(toolPose(*cell.robot, *cell.plans, changed->joints).isApprox(tool, 1e-6));
      for (const JointValues& each : found) QVERIFY((each - changed->joints).cwiseAbs().maxCoeff() > 1e-3);
      found.push_back(changed->joints);
    }
    QVERIFY(found.size() >= 2);  // the wrist can be turned over
    QVERIFY((found.front() - cell.joints).cwiseAbs().maxCoeff() < 1e-6);
    values.setValid("at", std::vector<double>{1e4, 0.0, 0.0});
    QVERIFY(changedCell(values, cell).error().code == CellError::ToolOutOfReach);
  }

  // The states of an SRDF become configurations, with names of their own; its pairs may touch.
  void semantics() {
    const RobotCellSnapshot cell = withConfigurations(m_cell->content(), {{"home", m_cell->document().joints(), ""}});
    RobotSemantics read;
    read.allowed = {{1, 3}};
    read.states = {{"home", "arm", {{0, 0.25}, {4, -0.5}}}, {"as it stands", "arm", {}}};
    const auto plans = withSemantics(*cell.plans, read, cell);
    QVERIFY(plans.hasValue());
    const RobotModel& robot = cell.robot->model;
    QVERIFY(isAllowed(*plans, {robot.links[1].name, robot.links[3].name}));
    JointValues home = cell.joints;
    home[0] = 0.25;
    home[4] = -0.5;
    QCOMPARE(plans->configurations.size(), std::size_t{3});
    QVERIFY(plans->configurations[0] == cell.plans->configurations[0]);
    QVERIFY(plans->configurations[1].joints == home && plans->configurations[1].name != "home");
    QVERIFY((plans->configurations[2] == NamedConfiguration{"as it stands", cell.joints, ""}));
    read.states[0].values[1] = 3.0;  // it ends at 110 degrees
    QVERIFY(withSemantics(*cell.plans, read, cell).error().code == ErrorCode::ValueOutOfRange);
  }

  // In a cell of several robots a state belongs to the one whose joints it names.
  void semanticsOfTheSecondRobot() {
    auto two =
        withRobotAdded(m_cell->content(), {cellOf(*libraryTable("ur5")), "second", poseOf({0, 3000, 0}, Vec3::Zero())});
    QVERIFY(two.hasValue());
    const std::uint32_t own = dofsOfArm(*two->robot, 0)[2], others = dofsOfArm(*two->robot, 1)[2];
    RobotSemantics read;
    read.states = {{"one", "arm", {{own, 0.1}}}, {"other", "arm", {{others, 0.1}}}};
    const auto plans = withSemantics(*two->plans, read, *two);
    QVERIFY(plans.hasValue());
    QCOMPARE(*armNumber(*two->robot, plans->configuration("one")->arm), std::size_t{0});
    QCOMPARE(*armNumber(*two->robot, plans->configuration("other")->arm), std::size_t{1});
  }

 private:
  std::unique_ptr<ArmCell> m_cell;
};

HANDWHEEL_TEST(ConfigurationOperationTest)
#include "ConfigurationOperationTest.moc"
