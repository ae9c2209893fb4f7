// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/PairNames.h"

#include "../ArmCell.h"
#include "TestClass.h"

#include <QTest>
#include <algorithm>

using namespace handwheel;
using namespace handwheel::test;

// Pairs that are found may touch from now on, by their names, and no longer.
class PairNamesTest : public QObject {
  Q_OBJECT

 private slots:
  // A box around the robot blocks all its motions.
  void foundAndAllowed() {
    ArmCell cell;
    const BodyId box = cell.addBox({2000, 2000, 2000}, {0, 0, 0});
    const std::string part = "body." + std::to_string(box);
    const std::set<PairNames> found = met(cell);
    QVERIFY(!found.empty());
    for (const PairNames& each : found) {
      QCOMPARE(each.second, part);
      QVERIFY((shownNames(each, cell.document().bodies()) == PairNames{each.first, "box1"}));
    }
    CellPlans plans;
    for (const PairNames& each : found) setAllowed(plans, each, true);
    QVERIFY(plans.allowed == found);
    cell.plan(plans);
    QVERIFY(met(cell).empty());
    cell.document().history()->undo();
    QVERIFY(met(cell) == found);
    // In reverse order they are the same pairs.
    CellPlans turned;
    for (const auto& [link, body] : found) setAllowed(turned, {body, link}, true);
    cell.plan(turned);
    QVERIFY(met(cell).empty());
    for (const PairNames& each : found) {
      QVERIFY(isAllowed(turned, each));
      setAllowed(turned, each, true);  // it may already
    }
    QCOMPARE(turned.allowed.size(), found.size());
    for (const PairNames& each : found) setAllowed(turned, each, false);
    QVERIFY(turned.allowed.empty());
  }

  // Missing objects: no pair, and the number of a body that was removed.
  void nothingFound() {
    ArmCell cell;
    QVERIFY(!pairNamesOf(*cell.scene(), RobotScene::Nearest{.distance = 1.0}));
    QVERIFY((shownNames({"flange", "body.9"}, cell.document().bodies()) == PairNames{"flange", "body.9"}));
  }

  // Two bodies are found by what they are called; a link is no body, nor is what has the name of one.
  void bodiesByTheirNames() {
    ArmCell cell;
    const BodyId one = cell.addBox({20, 20, 20}, {900, 0, 0}), other = cell.addBox({20, 20, 20}, {0, 900, 0});
    const RobotModel& robot = cell.document().robot().model;
    const auto called = [&](const std::string& a, const std::string& b) {
      return bodiesCalled(a, b, cell.document().bodies(), robot);
    };
    QVERIFY((called("box1", "box2") == PairNames{"body." + std::to_string(one), "body." + std::to_string(other)}));
    QVERIFY(!called(robot.links.back().name, "box2") && !called("box1", "nothing"));
    Body named = *cell.document().bodies().withId(one);
    named.name = robot.links.back().name;
    cell.document().commit("Rename", std::move(changeBodyEdit(cell.document().bodies(), named)).value());
    QVERIFY(!called(robot.links.back().name, "box2"));
  }

  // Pairs that are left out of proofs: of things that are there, each once, also of links of one robot, but without
  // neighbours, and without a body and its carrier.
  void leftOut() {
    ArmCell cell;
    RobotCellDocument& document = cell.document();
    const BodyId box = cell.addBox({20, 20, 20}, {900, 0, 0}), tool = cell.addBox({20, 20, 20}, {0, 0, 30});
    const RobotModel& robot = document.robot().model;
    const std::string flange = robot.links[document.robot().arms[0].flange].name;
    Body carried = *document.bodies().withId(tool);
    carried.carrier = flange;
    document.commit("Carry", std::move(changeBodyEdit(document.bodies(), carried)).value());
    const std::string standing = "body." + std::to_string(box), moving = "body." + std::to_string(tool);
    const LinkPair next = *neighbours(robot).begin();
    const PairNames neighbouring{robot.links[next.first].name, robot.links[next.second].name};
    const PairNames ofItsTable{robot.links[1].name, flange};
    CellPlans plans;
    plans.allowed = {{flange, standing}, {standing, flange}, {standing, moving},    {flange, "body.99"},
                     {moving, flange},   neighbouring,       {"nowhere", standing}, ofItsTable};
    cell.plan(plans);
    CollisionMeshes meshes;
    const Result<CellScene> scene = sceneOf(cell.content(), meshes);
    const std::vector<PairNames> left = uncheckedPairs(*scene, plans.allowed);
    QCOMPARE(left.size(), std::size_t{3});
    const auto has = [&](const std::string& one, const std::string& other) {
      return std::any_of(left.begin(), left.end(), [&](const PairNames& each) {
        return each == PairNames{one, other} || each == PairNames{other, one};
      });
    };
    QVERIFY(has(flange, "box1") && has("box1", "box2") && has(robot.links[1].name, flange));
    QVERIFY(uncheckedPairs(*scene, {}).empty());
  }

 private:
  static std::set<PairNames> met(ArmCell& cell) {
    CollisionMeshes meshes;
    const Result<CellScene> scene = sceneOf(cell.content(), meshes);
    std::set<PairNames> found;
    for (const RobotScene::Nearest& each :
         scene->scene.allTooNear(scene->planned(cell.document().joints()), 0.0, 0.0)) {
      if (const auto pair = pairNamesOf(*scene, each)) found.insert(*pair);
    }
    return found;
  }
};

HANDWHEEL_TEST(PairNamesTest)
#include "PairNamesTest.moc"
