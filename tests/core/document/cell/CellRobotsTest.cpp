// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/RobotChanges.h"

#include "Cells.h"
#include "TestClass.h"
#include "document/cell/CellArms.h"
#include "document/cell/CellErrors.h"
#include "document/cell/CellReach.h"
#include "document/scene/BodyChanges.h"
#include "planning/PathVerification.h"
#include "robot/Kinematics.h"
#include "robot/SrdfReader.h"
#include "robot/dh/DhTable.h"
#include "scene/PrimitiveGeometry.h"
#include "scene/RigidPose.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A bar of 400 × 20 × 20 mm that turns about z at one end, above a foot without a shape.
const std::string kBarUrdf = R"(<robot name='bar'><link name='foot'/>
  <link name='bar'><visual><origin xyz='0.2 0 0'/><geometry><box size='0.4 0.02 0.02'/></geometry></visual></link>
  <link name='tip'/>
  <joint name='turn' type='revolute'><parent link='foot'/><child link='bar'/><axis xyz='0 0 1'/>
    <limit lower='-3' upper='3' velocity='1' effort='1'/></joint>
  <joint name='end' type='fixed'><parent link='bar'/><child link='tip'/><origin xyz='0.4 0 0'/></joint>
</robot>)";

RobotCellSnapshot changedOrThrow(Result<RobotCellSnapshot> changed) {
  if (!changed) throw std::runtime_error("not changed: error " + std::string(changed.error().code->id));
  return std::move(changed).value();
}

std::shared_ptr<const RobotCellSnapshot> shared(RobotCellSnapshot cell) {
  return std::make_shared<const RobotCellSnapshot>(std::move(cell));
}

double number(double least, double largest) {
  return least + (largest - least) * *rc::gen::inRange(0, 100'001) / 1e5;
}

Pose anyBase() {
  return poseOf({number(-2000, 2000), number(-2000, 2000), number(-500, 500)},
                {number(-3, 3), number(-1.5, 1.5), number(-3, 3)});
}

bool areEqual(const RobotCellSnapshot& a, const RobotCellSnapshot& b) {
  return a.robot->description == b.robot->description && a.robot->arms == b.robot->arms && a.joints == b.joints &&
         *a.plans == *b.plans && a.bodies == b.bodies && a.robot->surfaces.size() == b.robot->surfaces.size();
}

JointPath line(double from, double to) {
  ArmValues a(1), b(1);
  a << from;
  b << to;
  return {a, b};
}

}  // namespace

// Several robots in one cell.
class CellRobotsTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { write(m_bar, kBarUrdf); }

  // Two bars whose feet are 700 mm apart, the second turned by half a turn. Each turns freely alone, and so does the
  // first one while the second points away; if it points to the first, the two collide while the first one's end is
  // within the 20 mm of the other.
  void barsThatMeet() {
    const RobotCellSnapshot cell = twoBars();
    CollisionMeshes meshes;
    QVERIFY(verificationOf(bar(), line(-1.0, 1.0)).isCertified());
    RobotCellSnapshot away = cell;
    away.joints = values({0.0, 1.2});
    QVERIFY(verificationOf(away, line(-1.0, 1.0)).isCertified());
    const VerifiedPath met = verificationOf(cell, line(-1.0, 1.0));
    QCOMPARE(met.collisions.size(), std::size_t{1});
    // The corner at (400, -10) comes to y = 10: 400 sin q - 10 cos q = 10.
    const double until = std::asin(10.0 / std::hypot(400.0, 10.0)) + std::atan2(10.0, 400.0);
    QVERIFY(std::abs(met.collisions[0].from - (1.0 - until) / 2.0) < 0.01);
    QVERIFY(std::abs(met.collisions[0].to - (1.0 + until) / 2.0) < 0.01);
    const Result<CellScene> scene = sceneOf(cell, meshes);
    const auto [link, other] = scene->namesOf(met.collisions[0].deepest);
    QCOMPARE(link, std::string("bar"));
    QCOMPARE(other, std::string("bar_2_bar"));
    // The second one's view of the same.
    const VerifiedPath second = verificationOf(cell, line(-1.0, 1.0), 1);
    QCOMPARE(second.collisions.size(), std::size_t{1});
    QVERIFY(std::abs(second.collisions[0].from - met.collisions[0].from) < 0.01);
  }

  // Another robot is kept away from as any obstacle is: 280 mm lie between the end of one bar and that of the other
  // where both point to each other from feet 1080 mm apart.
  void clearance() {
    RobotCellSnapshot cell =
        changedOrThrow(withRobotAdded(bar(), {shared(bar()), {}, poseOf({1080, 0, 0}, {0, 0, M_PI})}));
    QVERIFY(verificationOf(cell, line(-1.0, 1.0), 0, 279.0).isCertified());
    QVERIFY(!verificationOf(cell, line(-1.0, 1.0), 0, 281.0).isCertified());
  }

  // Unless a person allows a pair, also where they always meet.
  void onlyAPersonAllowsPairs() {
    RobotCellSnapshot cell = changedOrThrow(withRobotAdded(bar(), {shared(bar()), {}, Pose::Identity()}));
    cell.joints = values({0.0, 0.0});
    CollisionMeshes meshes;
    const Result<CellScene> scene = sceneOf(cell, meshes);
    QVERIFY(scene->scene.nearest(scene->planned(cell.joints), 1.0).distance <= 0.0);
    CellPlans plans = *cell.plans;
    plans.allowed.insert({"bar", "bar_2_bar"});
    cell.plans = std::make_shared<const CellPlans>(plans);
    const Result<CellScene> allowed = sceneOf(cell, meshes);
    QVERIFY(allowed->scene.nearest(allowed->planned(cell.joints), 1.0).distance > 0.0);
  }

  // Bodies that the other robot carries move with it: a ball of 50 mm on its tip, 300 mm before the first one's foot.
  void carriedByTheOther() {
    RobotCellSnapshot cell = twoBars();
    Body ball{.id = 4, .name = "ball", .geometry = *PrimitiveGeometry::make(Primitive::Sphere, {50.0})};
    ball.carrier = "bar_2_tip";
    cell.bodies = cell.bodies.with(std::make_shared<const Body>(ball));
    CellPlans plans = *cell.plans;
    plans.allowed.insert({"bar", "bar_2_bar"});
    cell.plans = std::make_shared<const CellPlans>(plans);
    CollisionMeshes meshes;
    const Result<CellScene> scene = sceneOf(cell, meshes);
    const double turn = 0.7;
    const RobotScene::Nearest nearest = scene->scene.nearest(scene->planned(values({turn, 0.0})), 1e3);
    // The side of the bar that faces the ball is 10 mm from its axis.
    QVERIFY(std::abs(nearest.distance - (300.0 * std::sin(turn) - 10.0 - 50.0)) < 1e-3);
    QCOMPARE(scene->namesOf(nearest).second, std::string("ball"));
  }

  void kinematicsOfTheSecond() {
    const auto own = cellOf(*libraryTable("ur5")), first = cellOf(*libraryTable("irb120"));
    QVERIFY(rc::check("base times its own, there and back", [&] {
      const Pose base = anyBase();
      RobotCellSnapshot cell = changedOrThrow(withRobotAdded(*first, {own, "left", base}));
      cell.plans =
          std::make_shared<const CellPlans>(std::move(withArmChosen(*cell.robot, *cell.plans, "left")).value());
      JointValues turned(6);
      for (double& value : turned) value = number(-2.0, 2.0);
      cell.joints << first->joints, turned;
      const Pose alone = toolPose(*own->robot, *own->plans, turned);
      const Pose there = toolPose(*cell.robot, *cell.plans, cell.joints);
      RC_ASSERT(((base * alone).matrix() - there.matrix()).cwiseAbs().maxCoeff() < 1e-6);
      // One of the solutions of the closed form is the present one, and each reaches the pose.
      CollisionMeshes meshes;
      const Result<CellScene> scene = sceneOf(cell, meshes);
      RC_ASSERT(scene.hasValue());
      bool isFound = false;
      const ArmValues now = scene->planned(cell.joints);
      for (const CellIkSolution& solution : ikSolutionsTo(*scene, *cell.plans, there, now)) {
        isFound |= (solution.arm.values - now).cwiseAbs().maxCoeff() < 1e-4;
        const Pose reached = toolPose(*cell.robot, *cell.plans, scene->whole(solution.arm.values));
        RC_ASSERT((reached.matrix() - there.matrix()).cwiseAbs().maxCoeff() < 1e-4);
      }
      RC_ASSERT(isFound || std::abs(std::sin(turned[4])) < 0.02 || std::abs(std::sin(turned[2])) < 0.02);
      // From its base on it is the arm alone.
      const Pose fromBase = scene->armFromBase().tipPose(now);
      RC_ASSERT((fromBase.matrix() - alone.matrix()).cwiseAbs().maxCoeff() < 1e-6);
    }));
  }

  void saveLoadUndoRedo() {
    const RobotCellSnapshot arm = cellIn(importOrThrow(m_package.urdf()));
    QVERIFY(rc::check("as it was", [&] {
      RobotCellDocument document(openedAs(arm));
      const auto now = [&] { return std::static_pointer_cast<const RobotCellSnapshot>(document.snapshot()); };
      std::vector<std::shared_ptr<const RobotCellSnapshot>> states{now()};
      for (int steps = *rc::gen::inRange(1, 6); steps > 0; --steps) {
        const std::size_t count = document.robot().arms.size();
        const auto chosen = static_cast<std::size_t>(*rc::gen::inRange(0, 100)) % count;
        const int what = *rc::gen::inRange(0, 5);
        std::unique_ptr<Edit> edit;
        if (what == 0 || count == 1) {
          const auto other = *rc::gen::arbitrary<bool>() ? shared(bar()) : shared(arm);
          edit = document.robotsEdit(changedOrThrow(withRobotAdded(*now(), {other, {}, anyBase()})));
        } else if (what == 1) {
          edit = document.robotsEdit(changedOrThrow(withRobotRemoved(*now(), chosen)));
        } else if (what == 2) {
          auto moved = withRobotMoved(*now(), chosen, anyBase());
          if (moved) edit = document.robotsEdit(std::move(moved).value());
        } else if (what == 3) {
          CellPlans plans = *withArmChosen(document.robot(), *document.plans(), document.robot().arms[chosen].name);
          plans.configurations.push_back({plans.freePoseName("home"), document.joints(), plans.arm});
          plans.paths.push_back({plans.freePathName("way"), {{.joints = document.joints()}}, plans.arm});
          plans.tool.translation() = Vec3(0.0, 0.0, number(1.0, 300.0));
          edit = document.plansEdit(std::move(plans));
        } else {
          JointValues joints = document.joints();
          for (double& value : joints) value += number(0.0, 0.5);
          edit = document.jointEdit(joints);
        }
        if (!edit) continue;
        document.commit(QString::number(steps), std::move(edit));
        states.push_back(now());
      }
      const auto bytes = writeContainer(saved(*now()), Compression::Fast);
      RC_ASSERT(bytes.hasValue());
      const auto read = readContainer(*bytes);
      RC_ASSERT(read.hasValue());
      std::vector<Error> damage;
      const auto again = loaded(read->container, damage);
      RC_ASSERT(again && damage.empty());
      RC_ASSERT(areEqual(*again, *now()));
      const JointValues values = again->joints;
      const auto before = linkPoses(now()->robot->model, values), after = linkPoses(again->robot->model, values);
      for (std::size_t l = 0; l < before.size(); ++l) RC_ASSERT(before[l].matrix() == after[l].matrix());
      for (std::size_t i = 0; i < again->robot->surfaces.size(); ++i) {
        RC_ASSERT(bool(again->robot->surfaces[i]) == bool(now()->robot->surfaces[i]));
        if (again->robot->surfaces[i])
          RC_ASSERT(boxOf(*again->robot->surfaces[i]).isApprox(boxOf(*now()->robot->surfaces[i]), 1e-6));
      }
      for (std::size_t i = states.size(); i-- > 1;) {
        RC_ASSERT(areEqual(*now(), *states[i]));
        document.history()->undo();
      }
      RC_ASSERT(areEqual(*now(), *states.front()));
      for (std::size_t i = 1; i < states.size(); ++i) document.history()->redo();
      RC_ASSERT(areEqual(*now(), *states.back()));
    }));
  }

  // A file of a cell with one robot has no word about several, and is read as one.
  void aFileOfOneRobot() {
    Container container = saved(cellIn(importOrThrow(m_package.urdf())));
    QVERIFY(!(*container.manifest)["document"].contains("robots"));
    std::vector<Error> damage;
    const auto cell = loaded(container, damage);
    QVERIFY(cell && damage.empty());
    QCOMPARE(cell->robot->arms.size(), std::size_t{1});
    QCOMPARE(cell->robot->model.links[cell->robot->arms[0].flange].name, std::string("tool0"));
    QCOMPARE(cell->robot->arms[0].base, cell->robot->model.root);
  }

  void damagedFiles_data() {
    QTest::addColumn<QByteArray>("robots");
    QTest::newRow("no list") << QByteArray("7");
    QTest::newRow("none") << QByteArray("[]");
    QTest::newRow("no such link") << QByteArray(R"([{"name": "a", "base": "nothing", "flange": "tool0"}])");
    QTest::newRow("not at the root") << QByteArray(R"([{"name": "a", "base": "upper", "flange": "tool0"}])");
    QTest::newRow("upside down") << QByteArray(R"([{"name": "a", "base": "arm_2_foot", "flange": "tool0"}])");
    QTest::newRow("twice") << QByteArray(R"([{"name": "a", "base": "foot", "flange": "tool0"},
                                             {"name": "a", "base": "arm_2_foot", "flange": "arm_2_tool0"}])");
    QTest::newRow("flange of another") << QByteArray(R"([{"name": "a", "base": "foot", "flange": "arm_2_tool0"},
                                                        {"name": "b", "base": "arm_2_foot", "flange": "arm_2_tool0"}])");
    nlohmann::json many = nlohmann::json::array();
    for (int i = 0; i < 1'000; ++i)
      many.push_back({{"name", "a" + std::to_string(i)}, {"base", "foot"}, {"flange", "tool0"}});
    QTest::newRow("more than links") << QByteArray::fromStdString(many.dump());
    QTest::newRow("without a name") << QByteArray(R"([{"base": "foot", "flange": "tool0"}])");
  }
  void damagedFiles() {
    QFETCH(const QByteArray, robots);
    const RobotCellSnapshot arm = cellIn(importOrThrow(m_package.urdf()));
    Container container = saved(changedOrThrow(withRobotAdded(arm, {shared(arm)})));
    (*container.manifest)["document"]["robots"] = nlohmann::json::parse(robots.toStdString());
    std::vector<Error> damage;
    const auto cell = loaded(container, damage);
    QVERIFY(cell);
    QCOMPARE(damage.size(), std::size_t{1});
    QCOMPARE(cell->robot->arms.size(), std::size_t{1});
  }

  // Plans for a robot that is not there are for the first one.
  void plansOfNobody() {
    Container container = saved(twoBars());
    container.blobs["cell/plans.json"] = R"({"arm": "nobody", "tool": [1,0,0,5,0,1,0,0,0,0,1,0]})";
    std::vector<Error> damage;
    const auto cell = loaded(container, damage);
    QVERIFY(cell && damage.size() == 1);
    QCOMPARE(activeArm(*cell->robot, *cell->plans).name, std::string("bar"));
    QVERIFY(isSameArm(*cell->robot, cell->plans->arm, "bar"));
  }

  // The same robot again: its mesh goes with it, and each has joints of its own.
  void addedTwice() {
    const RobotCellSnapshot arm = cellIn(importOrThrow(m_package.urdf()));
    RobotCellSnapshot cell = changedOrThrow(withRobotAdded(arm, {shared(arm), {}, poseOf({0, 900, 0}, Vec3::Zero())}));
    cell = changedOrThrow(withRobotAdded(cell, {shared(arm), {}, poseOf({0, 1800, 0}, Vec3::Zero())}));
    QCOMPARE(cell.robot->arms[1].name, std::string("arm_2"));
    QCOMPARE(cell.robot->arms[2].name, std::string("arm_3"));
    QCOMPARE(cell.joints.size(), Eigen::Index{6});
    const DisplayModel shown = kKind.display(cell);
    int uppers = 0;
    for (const DisplayPart& part : shown.parts) {
      if (!part.name.ends_with("upper/0")) continue;
      Box box = boxOf(*part.soup);
      box.translate(part.pose.translation());
      QVERIFY(isNear(box, Vec3(0, 900.0 * uppers - 50, -50), Vec3(500, 900.0 * uppers + 50, 50)));
      ++uppers;
    }
    QCOMPARE(uppers, 3);
  }

  // Joints of a configuration of one robot only; a tool of its own.
  void eachHasItsOwnPlans() {
    RobotCellSnapshot cell = twoBars();
    QVERIFY(jointsSetBy(*cell.robot, "", values({1.0, 2.0}), values({0.0, 0.5})) == values({1.0, 0.5}));
    QVERIFY(jointsSetBy(*cell.robot, "bar_2", values({1.0, 2.0}), values({0.0, 0.5})) == values({0.0, 2.0}));
    QVERIFY(jointsSetBy(*cell.robot, "gone", values({1.0, 2.0}), values({0.0, 0.5})) == values({0.0, 0.5}));
    CellPlans plans = *cell.plans;
    plans.tool.translation() = Vec3(1, 0, 0);
    plans = *withArmChosen(*cell.robot, plans, "bar_2");
    QVERIFY(plans.tool.translation().isZero());
    plans.tool.translation() = Vec3(2, 0, 0);
    plans = *withArmChosen(*cell.robot, plans, "bar");
    QCOMPARE(plans.tool.translation().x(), 1.0);
    plans = *withArmChosen(*cell.robot, plans, "bar_2");
    QCOMPARE(plans.tool.translation().x(), 2.0);
    const Result<CellPlans> none = withArmChosen(*cell.robot, plans, "gone");
    QVERIFY(!none && none.error().code == CellError::ArmMissing);
  }

  // With a robot its plans go, and what it carries stands where it was held.
  void removed() {
    RobotCellSnapshot cell = twoBars();
    cell.joints = values({0.5, 0.0});
    CellPlans plans = *cell.plans;
    plans.configurations = {{"mine", cell.joints, ""}, {"its", cell.joints, "bar_2"}};
    plans.paths = {{"mine", {{.joints = cell.joints}}, "bar"}, {"its", {{.joints = cell.joints}}, "bar_2"}};
    plans.allowed = {{"bar", "bar_2_bar"}, {"bar_2_bar", "body.3"}, {"bar", "body.3"}};
    plans.arm = "bar_2";
    plans.tool.translation() = Vec3(5, 0, 0);
    cell.plans = std::make_shared<const CellPlans>(plans);
    Body held{.id = 3, .name = "held", .geometry = *PrimitiveGeometry::make(Primitive::Sphere, {5.0})};
    held.carrier = "tip";
    cell.bodies = cell.bodies.with(std::make_shared<const Body>(held));

    const RobotCellSnapshot first = changedOrThrow(withRobotRemoved(cell, 0));
    QCOMPARE(first.robot->arms.size(), std::size_t{1});
    QVERIFY(first.joints == values({0.0}));
    QVERIFY(first.plans->configuration("its") && !first.plans->configuration("mine"));
    QVERIFY(first.plans->path("its") && !first.plans->path("mine"));
    QVERIFY((first.plans->allowed == std::set<std::pair<std::string, std::string>>{{"bar_2_bar", "body.3"}}));
    QCOMPARE(first.plans->tool.translation().x(), 5.0);
    const BodyPointer body = first.bodies.withId(3);
    QVERIFY(body->carrier.empty());
    QVERIFY((body->pose.translation() - 400.0 * Vec3(std::cos(0.5), std::sin(0.5), 0.0)).norm() < 1e-6);
    const Pose tip = linkPoses(first.robot->model, first.joints)[first.robot->arms[0].flange];
    QVERIFY((tip.translation() - Vec3(300, 0, 0)).norm() < 1e-6);

    const RobotCellSnapshot second = changedOrThrow(withRobotRemoved(cell, 1));
    QVERIFY(second.joints == values({0.5}));
    QVERIFY(!second.plans->configuration("its") && second.plans->configuration("mine"));
    QVERIFY(second.bodies.withId(3)->carrier == "tip");
    QCOMPARE(second.plans->arm, std::string("bar"));
    QVERIFY(second.plans->tool.translation().isZero() && second.plans->otherTools.empty());
    const Result<RobotCellSnapshot> last = withRobotRemoved(second, 0);
    QVERIFY(!last && last.error().code == CellError::OnlyRobot);
  }

  void properties() {
    RobotCellDocument document(openedAs(twoBars()));
    QVERIFY(!document.property("robot.bar.x"));
    QCOMPARE(std::get<double>(document.property("robot.bar_2.x")->value), 700.0);
    QVERIFY(document.setProperty("robot.bar_2.x", 900.0).hasValue());
    QVERIFY(document.setProperty("robot.bar_2.rz", 0.0).hasValue());
    QVERIFY(document.setProperty("arm", 1.0).hasValue());
    QCOMPARE(document.plans()->arm, std::string("bar_2"));
    QCOMPARE(std::get<double>(document.property("tool.x")->value), 1300.0);
    QVERIFY(!document.setProperty("arm", 2.0).hasValue());
    QVERIFY(!document.setProperty("robot.bar_2.x", 1e9).hasValue());
    // To where its end is at x = 900 mm + 400 mm cos 1: it, not the other one, turns.
    JointValues turned = values({0.0, 1.0});
    document.commit("turn", document.jointEdit(turned));
    QVERIFY(std::abs(std::get<double>(document.property("tool.x")->value) - (900.0 + 400.0 * std::cos(1.0))) < 1e-6);
    // The joints of each in a group of its own, called as in its description.
    for (const char* const robot : {"bar", "bar_2"}) {
      const bool isFirst = std::string_view(robot) == "bar";
      const auto joint = document.property(isFirst ? "joint.turn" : "joint.bar_2_turn");
      QVERIFY(joint && joint->group == robot && joint->label == "turn" && !joint->groupTranslated);
    }
    const Result<RobotCellSnapshot> root = withRobotMoved(twoBars(), 0, Pose::Identity());
    QVERIFY(!root && root.error().code == CellError::ArmOnRoot);
  }

  // A semantic description is of one robot: its pairs, its states, and a link that meets all others of that robot only.
  void semanticsOfTheSecond() {
    const RobotCellSnapshot cell = twoBars();
    const RobotModel& model = cell.robot->model;
    const std::string srdf =
        "<robot name='bar'><disable_default_collisions link='foot'/><disable_collisions link1='bar' link2='tip'/>"
        "<group_state name='out' group='g'><joint name='turn' value='0.75'/></group_state></robot>";
    for (const std::string prefix : {"", "bar_2_"}) {
      const std::size_t arm = prefix.empty() ? 0 : 1;
      const Result<RobotSemantics> read = readSrdf(srdf, model, cell.robot->arms, arm);
      QVERIFY(read && read->damage.empty());
      std::set<std::pair<std::string, std::string>> names;
      for (const auto& [a, b] : read->allowed) names.insert(std::minmax(model.links[a].name, model.links[b].name));
      const auto pair = [&](const char* a, const char* b) {
        return std::pair<std::string, std::string>(std::minmax(prefix + a, prefix + b));
      };
      QVERIFY((names == std::set{pair("foot", "bar"), pair("foot", "tip"), pair("bar", "tip")}));
      QCOMPARE(read->states.size(), std::size_t(1));
      const auto [dof, value] = *read->states.front().values.begin();
      QCOMPARE(model.jointOfDof(dof).name, prefix + "turn");
      QCOMPARE(value, 0.75);
    }
    // Pairs of two robots by the names in the model.
    const std::string across = "<robot name='bar'><disable_collisions link1='tip' link2='bar_2_tip'/></robot>";
    const Result<RobotSemantics> pair = readSrdf(across, model, cell.robot->arms, 0);
    QVERIFY(pair && pair->allowed.size() == 1);
    QCOMPARE(model.links[pair->allowed.begin()->second].name, std::string("bar_2_tip"));
  }

  void standsElsewhere() {
    const RobotCellSnapshot cell = twoBars();
    CollisionMeshes meshes;
    const Result<CellScene> scene = sceneOf(cell, meshes);
    RobotPath path{"way", {{.joints = values({2.0, 0.0})}}};
    QVERIFY(scene->robotsElsewhere(path).empty());
    path.waypoints.push_back({.joints = values({0.0, 0.1})});
    QVERIFY(scene->robotsElsewhere(path) == std::set<std::string>{"bar_2"});
    QVERIFY(scene->areOwnUnplannedJointsAt(values({2.0, 0.1})));
  }

  // A path of another robot knows that a base was moved, also in its file, until that is back, or the robot gone.
  void baseElsewhere() {
    RobotCellDocument document(openedAs(twoBars()));
    const auto now = [&] { return std::static_pointer_cast<const RobotCellSnapshot>(document.snapshot()); };
    CellPlans plans = *document.plans();
    plans.paths = {{"mine", {{.joints = document.joints()}}, ""}, {"its", {{.joints = document.joints()}}, "bar_2"}};
    document.commit("paths", document.plansEdit(plans));
    const auto elsewhere = [&](const RobotCellSnapshot& cell, const char* path) {
      CollisionMeshes meshes;
      const RobotPath& asked = *cell.plans->path(path);
      return sceneOf(cell, meshes, *armNumber(*cell.robot, asked.arm))->robotsElsewhere(asked);
    };
    QVERIFY(document.setProperty("robot.bar_2.x", 900.0).hasValue());
    QVERIFY(document.setProperty("robot.bar_2.rz", 0.3).hasValue());
    QVERIFY(elsewhere(*now(), "mine") == std::set<std::string>{"bar_2"});
    QVERIFY(elsewhere(*now(), "its").empty());
    std::vector<Error> damage;
    const auto again = loaded(saved(*now()), damage);
    QVERIFY(again && damage.empty() && elsewhere(*again, "mine") == std::set<std::string>{"bar_2"});
    const RobotCellSnapshot alone = changedOrThrow(withRobotRemoved(*now(), 1));
    QVERIFY(alone.plans->path("mine")->bases.empty());
    QVERIFY(document.setProperty("robot.bar_2.x", 700.0).hasValue());
    QVERIFY(document.setProperty("robot.bar_2.rz", M_PI).hasValue());
    QVERIFY(elsewhere(*now(), "mine").empty());
    while (document.history()->canUndo()) document.history()->undo();
    document.history()->redo();
    QVERIFY(document.plans()->path("mine")->bases.empty());
  }

  // No more than is read of a file again.
  void tooManyPairs() {
    RobotCellSnapshot cell = bar();
    CellPlans plans;
    for (std::size_t i = 0; i < CellPlans::kMost; ++i) plans.allowed.insert({"bar", "body." + std::to_string(i + 1)});
    cell.plans = std::make_shared<const CellPlans>(plans);
    QVERIFY(withRobotAdded(cell, {shared(bar())}).hasValue());
    RobotCellSnapshot touching = bar();
    CellPlans pair;
    pair.allowed.insert({"foot", "tip"});
    touching.plans = std::make_shared<const CellPlans>(pair);
    const Result<RobotCellSnapshot> full = withRobotAdded(cell, {shared(touching)});
    QVERIFY(!full && full.error().code == CellError::PlansFull);
  }

 private:
  RobotCellSnapshot bar() const { return cellIn(importOrThrow(m_bar)); }
  RobotCellSnapshot twoBars() const {
    return changedOrThrow(withRobotAdded(bar(), {shared(bar()), {}, poseOf({700, 0, 0}, {0, 0, M_PI})}));
  }
  static OpenedFile openedAs(const RobotCellSnapshot& cell) {
    OpenedFile opened;
    opened.kind = &kKind;
    opened.content = shared(cell);
    return opened;
  }
  static VerifiedPath verificationOf(const RobotCellSnapshot& cell, const JointPath& path, std::size_t arm = 0,
                                     double clearance = 0.0) {
    CollisionMeshes meshes;
    const Result<CellScene> scene = sceneOf(cell, meshes, arm);
    if (!scene) throw std::runtime_error("no scene");
    MotionCheckSettings settings;
    settings.clearance = clearance;
    return verified(scene->scene, path, settings, 0.005);
  }

  ArmPackage m_package;
  QString m_bar = m_package.path("bar/bar.urdf");
};

HANDWHEEL_TEST(CellRobotsTest)
#include "CellRobotsTest.moc"
