// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Cells.h"
#include "TestClass.h"
#include "document/cell/CellErrors.h"
#include "document/cell/PlansBlobs.h"
#include "document/cell/PlansEdit.h"
#include "document/cell/WaypointProperties.h"
#include "scene/RigidPose.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

JointValues anyJoints() {
  return values({*rc::gen::inRange(0, 1001) / 1.0, *rc::gen::inRange(-200, 201) / 100.0});
}

CellPlans anyPlans() {
  CellPlans plans;
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i)
    plans.configurations.push_back({plans.freePoseName("home"), anyJoints()});
  for (int i = *rc::gen::inRange(0, 3); i > 0; --i) {
    RobotPath path{plans.freePathName("way"), {}};
    for (int k = *rc::gen::inRange(0, 4); k > 0; --k) path.waypoints.push_back({.joints = anyJoints()});
    if (*rc::gen::arbitrary<bool>()) path.clearance = *rc::gen::inRange(0, 100) / 7.0;
    plans.paths.push_back(std::move(path));
  }
  FreeNames frames;
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
    NamedFrame frame{.name = frames.take("fixture")};
    frame.pose = poseOf({0.25, *rc::gen::inRange(-900, 901) / 3.0, 12.5}, {-0.4, 0.3 * i, 2.0});
    frame.body = *rc::gen::inRange<std::uint32_t>(0, 3);
    if (frame.body == 0) frame.link = *rc::gen::element<std::string>("", "upper", "gone");
    plans.frames.push_back(std::move(frame));
  }
  if (!plans.frames.empty() && *rc::gen::arbitrary<bool>()) plans.workFrame = plans.frames.front().name;
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
    NamedTarget target{.name = plans.freePoseName("spot")};
    target.pose = poseOf({*rc::gen::inRange(-900, 901) / 7.0, 0.5, -3.25}, {0.1 * i, -0.2, 1.5});
    if (!plans.frames.empty() && *rc::gen::arbitrary<bool>())
      target.frame = plans.frames.back().name;
    else
      target.body = *rc::gen::inRange<std::uint32_t>(0, 5);
    plans.targets.push_back(std::move(target));
  }
  if (*rc::gen::arbitrary<bool>()) plans.allowed.insert({"upper", "body.3"});
  if (*rc::gen::arbitrary<bool>()) plans.tool = Pose(Eigen::Translation3d(1.0, 2.0, 3.5));
  plans.clearance = *rc::gen::inRange(0, 100) / 10.0;
  if (*rc::gen::arbitrary<bool>()) plans.rates.turning = *rc::gen::inRange(1, 100) / 7.0;
  if (*rc::gen::arbitrary<bool>()) plans.rates.timeToRamp = *rc::gen::inRange(1, 100) / 90.0;
  return plans;
}

}  // namespace

// The plans of a cell: saved, loaded, changed and undone.
class CellPlansTest : public QObject {
  Q_OBJECT

 private slots:
  void saveAndLoad() {
    const RobotCellSnapshot cell = cellIn(importOrThrow(m_package.urdf()));
    QVERIFY(rc::check("save and load", [&] {
      auto planned = std::make_shared<RobotCellSnapshot>(cell);
      planned->plans = std::make_shared<const CellPlans>(anyPlans());
      const auto bytes = writeContainer(saved(*planned), Compression::Fast);
      RC_ASSERT(bytes.hasValue());
      const auto read = readContainer(*bytes);
      RC_ASSERT(read.hasValue());
      std::vector<Error> damage;
      const auto again = loaded(read->container, damage);
      RC_ASSERT(again && damage.empty());
      RC_ASSERT(*again->plans == *planned->plans);
    }));
  }

  // Fields of the cell, and what a file may have in their stead.
  void rates() {
    RobotCellDocument document(importOrThrow(m_package.urdf()));
    const auto set = [&](const char* id, double value) {
      auto edit = document.propertyEdit(id, value);
      if (!edit) return false;
      if (*edit) document.commit("Set", std::move(edit).value());
      return true;
    };
    for (const char* const id : {"rates.turning", "rates.sliding", "rates.to_speed_s", "rates.to_acceleration_s"})
      QVERIFY2(document.property(id) && document.property(id)->editable, id);
    QVERIFY(set("rates.turning", 2.0) && set("rates.sliding", 800.0) && set("rates.to_speed_s", 0.5));
    QVERIFY(!set("rates.to_acceleration_s", 0.0) && !set("rates.turning", -1.0) && !set("rates.other", 1.0));
    QCOMPARE(document.plans()->rates.turning, 2.0);
    QCOMPARE(document.plans()->rates.sliding, 800.0);
    QCOMPARE(document.plans()->rates.timeToSpeed, 0.5);
    document.history()->undo();
    QCOMPARE(document.plans()->rates.timeToSpeed, 0.25);
    Container container;
    container.blobs["cell/plans.json"] =
        R"({"rates": {"turning": -1, "sliding": "fast", "to_speed_s": 0.4, "to_acceleration_s": 1e9}})";
    std::vector<Error> damage;
    const auto read = readPlans(container, document.robot().model, document.joints(), damage);
    QVERIFY(read->rates == (AssumedRates{.timeToSpeed = 0.4}));
  }

  void undo() {
    RobotCellDocument document(importOrThrow(m_package.urdf()));
    QVERIFY(!document.plansEdit(*document.plans()));
    CellPlans plans;
    plans.configurations.push_back({"home", values({0.0, 1.0})});
    document.commit("store", document.plansEdit(plans));
    QVERIFY(*document.plans() == plans);
    document.history()->undo();
    QVERIFY(*document.plans() == CellPlans());
    document.history()->redo();
    QVERIFY(*document.plans() == plans);
  }

  // A path along a curve whose speed is typed is no longer planned along it, or the speed would be lost; one that stays
  // as it was is.
  void speedsByHand() {
    CellPlans plans;
    Waypoint waypoint{.joints = values({0.0, 1.0}), .motion = ProgramMotion::Kind::Linear, .speed = 50.0};
    plans.paths = {{"way", {waypoint, waypoint}, "", PathProcess{{{"lead", 5.0}}}}};
    for (const auto& [id, same, other] : {std::tuple{"path.way.2.speed", 50.0, 60.0},
                                          {"path.way.2.blend", 0.0, 3.0},
                                          {"path.way.2.motion", 1.0, 0.0}}) {
      const auto field = waypointOfProperty(plans, id);
      QVERIFY(field);
      QVERIFY(*changedWaypoint(plans, *field, same) == plans);
      const Result<CellPlans> changed = changedWaypoint(plans, *field, other);
      QVERIFY(changed && !changed->paths[0].process && !(changed->paths[0].waypoints == plans.paths[0].waypoints));
    }
  }

  // A path keeps the clearance of the cell, or one of its own, with which a path along a curve is planned, too.
  void clearanceOfAPath() {
    CellPlans plans;
    plans.clearance = 2.0;
    plans.paths = {{"way", {}}, {"way.2", {}, "", PathProcess{{{"lead", 5.0}}}}};
    QVERIFY(!pathOfClearance(plans, "path.clearance") && !pathOfClearance(plans, "path.other.clearance"));
    QVERIFY(!pathOfClearance(plans, "path.way.2.blend"));
    const RobotPath* const second = pathOfClearance(plans, "path.way.2.clearance");
    QVERIFY(second == &plans.paths[1] && pathOfClearance(plans, "path.way.clearance") == &plans.paths[0]);
    QVERIFY(clearanceProperty(*second, plans).value == PropertyValue(2.0));
    const Result<CellPlans> changed = changedClearance(plans, *second, 7.5);
    QVERIFY(changed && changed->paths[0] == plans.paths[0]);
    QCOMPARE(changed->clearanceOf(changed->paths[0]), 2.0);
    QCOMPARE(changed->clearanceOf(changed->paths[1]), 7.5);
    QVERIFY(changed->paths[1].process->values.at("clearance") == PathProcess::Value(7.5));
    QVERIFY(!changedClearance(*changed, changed->paths[1], 2.0)->paths[1].clearance);  // The clearance of the cell
    for (const double wrong : {-1.0, 1e5, std::nan(""), HUGE_VAL}) QVERIFY(!changedClearance(plans, *second, wrong));
    QVERIFY(!changedClearance(plans, *second, std::string("7")));
  }

  // The property of the document is an undo step.
  void clearanceIsUndone() {
    RobotCellDocument document(importOrThrow(m_package.urdf()));
    CellPlans plans;
    plans.paths = {{"way", {}}};
    document.commit("plan", document.plansEdit(plans));
    auto edit = document.propertyEdit("path.way.clearance", 3.0);
    QVERIFY(edit.hasValue());
    document.commit("clearance", std::move(edit).value());
    QVERIFY(document.property("path.way.clearance")->value == PropertyValue(3.0));
    QVERIFY(document.plans()->paths[0].clearance == 3.0);
    document.history()->undo();
    QVERIFY(*document.plans() == plans);
  }

  // A cell that was written before there were frames.
  void withoutFrames() {
    Container container = saved(*importOrThrow(m_package.urdf()).content);
    container.blobs["cell/plans.json"] =
        R"({"targets": [{"name": "spot", "pose": [1,0,0,5,0,1,0,6,0,0,1,7], "body": 2}], "clearance_mm": 3})";
    std::vector<Error> damage;
    const auto cell = loaded(container, damage);
    QVERIFY(cell && damage.empty());
    CellPlans expected;
    expected.targets = {{"spot", poseOf({5.0, 6.0, 7.0}, Vec3::Zero()), 2}};
    expected.clearance = 3.0;
    QVERIFY(*cell->plans == expected);
  }

  // More entries than a cell can hold are refused when they are added, and noted when a file has them.
  void fullCells() {
    using nlohmann::json;
    const json entry = {{"name", "home"}, {"joints", {{"turn", 0.5}}}};
    const json pose = {{"name", "spot"}, {"pose", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}}};
    const json path = {{"name", "way"}, {"places", json::array()}};
    const auto many = [](const json& each, std::size_t count) { return json(json::array_t(count, each)); };
    const std::size_t most = CellPlans::kMost;
    Container container = saved(*importOrThrow(m_package.urdf()).content);
    const json stored = {
        {"configurations", many(entry, most)}, {"targets", many(pose, most + 1)}, {"paths", many(path, most + 7)}};
    container.blobs["cell/plans.json"] = stored.dump();
    std::vector<Error> damage;
    const auto cell = loaded(container, damage);
    QVERIFY(cell);
    QCOMPARE(damage.size(), std::size_t{2});
    QVERIFY(damage[0].code == ErrorCode::FileTooLarge &&
            damage[0].arguments == (std::vector<std::string>{"targets", "10001", "10000"}));
    QVERIFY(damage[1].code == ErrorCode::FileTooLarge &&
            damage[1].arguments == (std::vector<std::string>{"paths", "10007", "10000"}));
    CellPlans plans = *cell->plans;
    QVERIFY(plans.configurations.size() == most && plans.targets.size() == most && plans.paths.size() == most);
    QCOMPARE(plans.targets.back().name, std::string("spot 10000"));
    QVERIFY(checkCounts(plans).hasValue());
    plans.targets.push_back({.name = "one more"});
    const Status full = checkCounts(plans);
    QVERIFY(!full.hasValue() && full.error().code == CellError::PlansFull);
    plans.targets.pop_back();
    plans.frames.resize(CellPlans::kMostFrames + 1);
    QVERIFY(!checkCounts(plans).hasValue());
    plans.frames.pop_back();
    QVERIFY(checkCounts(plans).hasValue());
    plans.paths.front().waypoints.resize(RobotPath::kMostWaypoints + 1);
    QVERIFY(!checkCounts(plans).hasValue());
  }

  // The cell opens with any content.
  void hostile_data() {
    QTest::addColumn<QByteArray>("stored");
    QTest::newRow("no JSON") << QByteArray("{");
    QTest::newRow("a list") << QByteArray("[]");
    QTest::newRow("places beyond limits")
        << QByteArray(R"({"paths": [{"name": "a", "places": [{"joints": {"turn": 3}}]}]})");
    QTest::newRow("an unknown joint") << QByteArray(R"({"configurations": [{"name": "a", "joints": {"x": 3}}]})");
    QTest::newRow("numbers in place of objects") << QByteArray(R"({"configurations": [1, 2], "paths": [3]})");
    QTest::newRow("a target that is no pose") << QByteArray(R"({"targets": [{"name": "a", "pose": [1]}, 7]})");
    QTest::newRow("a mirrored target") << QByteArray(
        R"({"targets": [{"name": "a", "pose": [1,0,0,0,0,1,0,0,0,0,-1,0], "body": -2}]})");
    QTest::newRow("a target in a frame that is not there")
        << QByteArray(R"({"targets": [{"name": "a", "pose": [1,0,0,0,0,1,0,0,0,0,1,0], "frame": "b"}]})");
    QTest::newRow("a frame that is no pose") << QByteArray(R"({"frames": [{"name": "a", "pose": 3}, null]})");
    QTest::newRow("another frame than there are") << QByteArray(R"({"work_frame": "a"})");
    QTest::newRow("a tool without turn") << QByteArray(R"({"tool": [0,0,0,0,0,0,0,0,0,0,0,0]})");
  }
  void hostile() {
    QFETCH(const QByteArray, stored);
    Container container = saved(*importOrThrow(m_package.urdf()).content);
    container.blobs["cell/plans.json"] = stored.toStdString();
    std::vector<Error> damage;
    const auto cell = loaded(container, damage);
    QVERIFY(cell && !damage.empty());
    QVERIFY(cell->plans->configurations.empty() && cell->plans->paths.empty() && cell->plans->targets.empty());
    QVERIFY(cell->plans->frames.empty() && cell->plans->workFrame.empty());
  }

 private:
  ArmPackage m_package;
};

HANDWHEEL_TEST(CellPlansTest)
#include "CellPlansTest.moc"
