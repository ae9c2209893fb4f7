// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/path/PathDigests.h"

#include "../ArmCell.h"
#include "TestClass.h"
#include "document/Container.h"
#include "document/cell/RobotChanges.h"
#include "document/cell/path/PathBasis.h"
#include "document/scene/BodyEdit.h"
#include "robot/dh/DhTable.h"
#include "scene/MeshGeometry.h"

#include <rapidcheck.h>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using Cell = std::shared_ptr<const RobotCellSnapshot>;

Cell throughAFile(const RobotCellSnapshot& cell) {
  const RobotCellKind kind;
  Container container;
  kind.save(cell, container);
  std::vector<Error> damage;
  Result<SnapshotPointer> read = kind.load(container, damage, {});
  if (!read || !damage.empty()) qFatal("it cannot be read");
  return std::static_pointer_cast<const RobotCellSnapshot>(*read);
}

// The least that a number can change by.
double beside(double value, bool up) {
  return std::nextafter(value, up ? 1e9 : -1e9);
}

}  // namespace

// Digests of what a proof depends on: any change is seen after storing and reading, and nothing else.
class PathDigestsTest : public QObject {
  Q_OBJECT

 private slots:
  // Two robots, a box, a mesh that the first one carries, and a path of the first.
  void init() {
    m_cell = std::make_unique<ArmCell>();
    RobotCellDocument& document = m_cell->document();
    auto robots =
        withRobotAdded(m_cell->content(), {cellOf(*libraryTable("ur5")), "", poseOf({0, 1500, 0}, Vec3::Zero())});
    document.commit("Add", document.robotsEdit(std::move(robots).value()));
    m_box = m_cell->addBox({20, 20, 20.1}, {600, 300, 1.0 / 3.0}, {0.1, 0.2, 0.3});
    document.commit("Add", std::move(addBodyEdit(document.bodies(), meshBody(0.1))).value());
    CellPlans plans = *document.plans();
    RobotPath path{"way", {{.joints = document.joints()}, {.joints = document.joints()}}};
    path.waypoints.back().joints[0] = 1.0 / 7.0;
    path.waypoints.back().target = WaypointTarget{"T", poseOf({0.0, 1.0 / 3.0, 0.0}, {0.1, 0.2, 0.3})};
    plans.targets = {{"T", poseOf({300.1, 0.0, 400.0}, {0.1, 0.2, 0.3})}};
    path.waypoints.front().configuration = "home";
    plans.configurations = {{"home", document.joints()}};
    plans.configurations.front().joints[0] = 1.0 / 3.0;
    plans.paths.push_back(path);
    plans.tool.translation() = Vec3(1.0 / 3.0, 0.0, 100.0);
    plans.clearance = 0.7;
    plans.allowed.insert({"a", "b"});
    m_cell->plan(plans);
  }

  // Written and read it is the same cell.
  void isKeptByFiles() {
    const Cell before = now(), after = throughAFile(*before);
    QCOMPARE(changeBetween(digestsOf(before), digestsOf(after)), BasisChange::Nothing);
    QCOMPARE(changeBetween(digestsOf(before), digestsOf(throughAFile(*after))), BasisChange::Nothing);
  }

  // Each change, by as little as a number can, is named as the comparison of the values themselves names it.
  void seesEveryChange() {
    const Cell before = now();
    const BasisDigests then = digestsOf(before);
    const PathBasis basis = basisOf(*before, pathOf(*before));
    const bool isSeen = rc::check("any change of an input invalidates a proof", [&] {
      const int what = *rc::gen::inRange(0, kChanges);
      const bool up = *rc::gen::arbitrary<bool>();
      auto changed = std::make_shared<RobotCellSnapshot>(*before);
      const bool counts = change(*changed, what, up);
      const BasisChange expected = changeSince(basis, *changed, pathOf(*changed));
      RC_ASSERT((expected != BasisChange::Nothing) == counts);
      RC_ASSERT(changeBetween(then, digestsOf(changed)) == expected);
      RC_ASSERT(changeBetween(then, digestsOf(throughAFile(*changed))) == expected);
    });
    QVERIFY(isSeen);
  }

  // Findings are read as they were written; contradictory ones, and those of removed paths, are not.
  void findings() {
    PathProof proof{{.isCertified = true, .clearance = 0.7, .leastClearance = 1.0 / 3.0, .seconds = 2.1},
                    "2026-11-24T10:00:00Z",
                    digestsOf(now())};
    proof.found.robotsMoved = {"ur5"};
    proof.found.notChecked = {{"flange", "box \"1\""}, {"a", "b"}};
    PathProof other = proof;
    other.found.isCertified = false;
    other.found.collisions = 7;
    other.found.measures = PathMeasures{2.5, 1.0 / 7.0, 0.03};
    other.found.stopsAt = 3;
    other.found.outdated = {"box \"1\"", true, true, {"T", "U"}, {"home"}};
    other.found.listed = {{1, "link \"1\"", "box\n"}};
    PathProof broken = other;
    broken.found.isCertified = true;
    Container container;
    writeProofs({{"way", proof}, {"b", other}, {"broken", broken}, {"gone", proof}}, {"way", "b", "broken"}, container);
    QVERIFY((readProofs(container) == PathProofs{{"way", proof}, {"b", other}}));
    RobotCellDocument& document = m_cell->document();
    document.setProofs({{"way", proof}}, false);
    QVERIFY(*throughAFile(*now())->proofs == (PathProofs{{"way", proof}}));
  }

  // The description tells what was found, and what has changed since; where that is undone, it holds again.
  void isDescribed() {
    RobotCellDocument& document = m_cell->document();
    const auto described = [&] { return RobotCellKind().describe(*now())["paths"][0]; };
    QVERIFY(!described().contains("verified"));
    const PathProof proof{
        {.isCertified = true, .clearance = 0.7, .leastClearance = 1.5}, "2026-11-24T10:00:00Z", digestsOf(now())};
    document.setProofs({{"way", proof}}, false);
    const auto changedSince = [&] { return described()["verified"]["changed_since"]; };
    QVERIFY(changedSince().is_null());
    auto moved = std::make_shared<Body>(*document.bodies().withId(m_box));
    moved->pose.translation().x() += 1.0;
    document.commit("Move", std::make_unique<BodyEdit>(std::vector<BodyEdit::Change>{{m_box, std::move(moved)}}));
    QCOMPARE(changedSince().get<std::string>(), std::string("bodies"));
    QVERIFY(described()["verified"]["certified"].get<bool>());  // Result at that time
    document.history()->undo();
    QVERIFY(changedSince().is_null());
    CellPlans plans = *document.plans();
    plans.clearance = 0.8;
    m_cell->plan(plans);
    QCOMPARE(changedSince().get<std::string>(), std::string("clearance"));
    plans.clearance = 0.7;
    plans.paths.front().waypoints.back().joints[0] = 0.2;
    m_cell->plan(plans);
    QCOMPARE(changedSince().get<std::string>(), std::string("path"));
  }

  // Read from text that anybody may have written.
  void hostileTexts() {
    for (const char* text : {"", "[]", "{\"method\":1}", "{\"method\":1,\"paths\":7}",
                             "{\"method\":1,\"paths\":[1,{}]}", "{\"method\":2,\"paths\":[{\"path\":\"a\"}]}",
                             "{\"method\":1,\"paths\":[{\"path\":\"a\",\"clearance_mm\":0,\"least_clearance_mm\":0,"
                             "\"seconds\":0,\"basis\":[]}]}"}) {
      Container container;
      container.blobs["cell/proofs.json"] = text;
      QVERIFY(readProofs(container).empty());
    }
  }

 private:
  static constexpr int kChanges = 20;

  Cell now() { return std::static_pointer_cast<const RobotCellSnapshot>(m_cell->document().snapshot()); }
  static const RobotPath& pathOf(const RobotCellSnapshot& cell) { return cell.plans->paths.front(); }
  static BasisDigests digestsOf(const Cell& cell) { return PathDigests(cell).of(pathOf(*cell)); }

  static Body meshBody(double corner) {
    TriangleSoup soup{{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, corner}},
                      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
    return {.name = "nozzle", .carrier = "flange", .geometry = std::make_shared<const MeshGeometry>(std::move(soup))};
  }

  // Returns true if the change counts.
  bool change(RobotCellSnapshot& cell, int what, bool up) const {
    CellPlans plans = *cell.plans;
    Body box = *cell.bodies.withId(m_box);
    Waypoint& waypoint = plans.paths.front().waypoints.back();
    const auto isBodies = what >= 5 && what <= 9;
    switch (what) {
      case 0:
        plans.clearance = beside(plans.clearance, up);
        break;
      case 1:
        plans.tool.translation().x() = beside(plans.tool.translation().x(), up);
        break;
      case 2:
        plans.allowed.insert({"a", up ? "c" : ""});
        break;
      case 3:
        waypoint.joints[0] = beside(waypoint.joints[0], up);
        break;
      case 4:
        waypoint.motion = ProgramMotion::Kind::Linear;
        waypoint.speed = up ? 250.0 : 249.0;
        break;
      case 5:
        box.pose.translation().z() = beside(box.pose.translation().z(), up);
        break;
      case 6:
        box.geometry = *PrimitiveGeometry::make(Primitive::Cuboid, {20, 20, beside(20.1, up)});
        break;
      case 7:
        box.carrier = cell.robot->model.links.back().name;
        break;
      case 8:
        box = *cell.bodies.withName("nozzle");
        box.geometry = meshBody(beside(0.1, up)).geometry;
        break;
      case 9:
        box.look.colour = {1.0f, 0.0f, 0.0f};
        box.name = "other";
        box.visible = !up;
        break;
      case 10:
        cell.joints[7] = beside(cell.joints[7], up);  // A joint of the second robot
        break;
      case 11:
        cell.joints[1] += 0.01;  // A joint of the first robot, which the path sets
        break;
      case 12: {
        auto moved = withRobotMoved(cell, 1, poseOf({0, 1500, up ? 0.001 : -0.001}, Vec3::Zero()));
        cell = std::move(moved).value();
        return true;
      }
      case 13:
        plans.paths.front().name = "another";
        break;
      case 14:
        waypoint.blend = 1.0;
        break;
      case 16:  // Its own clearance, also that of the cell
        plans.paths.front().clearance = up ? beside(plans.clearance, up) : plans.clearance;
        break;
      case 15: {
        auto removed = withRobotRemoved(cell, 1);
        cell = std::move(removed).value();
        return true;
      }
      case 17:
        plans.targets.front().pose.translation().x() = beside(300.1, up);
        break;
      case 18:
        plans.configurations.front().joints[0] = beside(1.0 / 3.0, up);
        break;
      case 19:
        plans.rates.sliding = beside(plans.rates.sliding, up);
        break;
    }
    if (isBodies) cell.bodies = cell.bodies.with(std::make_shared<const Body>(box));
    cell.plans = std::make_shared<const CellPlans>(std::move(plans));
    return what != 9 && what != 11 && what != 13 && (what != 16 || up);
  }

  std::unique_ptr<ArmCell> m_cell;
  BodyId m_box = 0;
};

HANDWHEEL_TEST(PathDigestsTest)
#include "PathDigestsTest.moc"
