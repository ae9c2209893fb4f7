// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/path/PathBasis.h"

#include "../ArmCell.h"
#include "TestClass.h"
#include "document/cell/CellFrames.h"
#include "document/cell/RobotChanges.h"
#include "robot/dh/DhTable.h"
#include "tools/cell/path/PathExport.h"

using namespace handwheel;
using namespace handwheel::test;

// The inputs of a verification: all data that affect it, and nothing else; undone changes do not count.
class PathBasisTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    m_cell = std::make_unique<ArmCell>();
    m_box = m_cell->addBox({20, 20, 20}, {600, 300, 0});
    RobotPath path{"way", {{.joints = m_cell->document().joints()}, {.joints = m_cell->document().joints()}}};
    path.waypoints.back().joints[0] = 0.5;
    CellPlans plans = *m_cell->document().plans();
    plans.paths.push_back(path);
    m_cell->plan(plans);
    m_basis = basisOf(m_cell->content(), *storedPath());
    QCOMPARE(change(), BasisChange::Nothing);
  }

  void whatItSees_data() {
    QTest::addColumn<int>("what");
    QTest::addColumn<BasisChange>("seen");
    QTest::newRow("a place") << 0 << BasisChange::Path;
    QTest::newRow("the tool") << 1 << BasisChange::Tool;
    QTest::newRow("the clearance") << 2 << BasisChange::Clearance;
    QTest::newRow("a pair") << 3 << BasisChange::Pairs;
    QTest::newRow("a name") << 4 << BasisChange::Nothing;
    QTest::newRow("another path") << 5 << BasisChange::Nothing;
    QTest::newRow("the rates") << 6 << BasisChange::Rates;
  }
  void whatItSees() {
    QFETCH(int, what);
    QFETCH(BasisChange, seen);
    CellPlans plans = *m_cell->document().plans();
    if (what == 0) plans.paths[0].waypoints[1].blend = 2.0;
    if (what == 1) plans.tool.translation().z() = 10.0;
    if (what == 2) plans.clearance = 3.0;
    if (what == 3) plans.allowed.insert({"a", "b"});
    if (what == 4) plans.paths[0].name = "other";
    if (what == 6) plans.rates.timeToSpeed = 0.5;
    if (what == 5) plans.paths.push_back({"more", plans.paths[0].waypoints});
    m_cell->plan(plans);
    QCOMPARE(change(), seen);
    m_cell->document().history()->undo();
    QCOMPARE(change(), BasisChange::Nothing);
  }

  // The pose of the target of a waypoint, and its frame; not their names, nor other targets.
  void itsTargets() {
    CellPlans plans = *m_cell->document().plans();
    plans.frames = {{"F", poseOf({10, 20, 30}, Vec3::Zero())}};
    plans.targets = {{"T", poseOf({400, 0, 300}, Vec3::Zero()), 0, "F"}, {"U", poseOf({400, 0, 300}, Vec3::Zero())}};
    plans.paths[0].waypoints[1].target = WaypointTarget{"T"};
    m_cell->plan(plans);
    m_basis = basisOf(m_cell->content(), *storedPath());
    plans.targets[1].pose.translation().x() += 1.0;
    m_cell->plan(withFrameRenamed(plans, "F", "G"));
    QCOMPARE(change(), BasisChange::Nothing);
    for (const bool isFrame : {false, true}) {
      CellPlans moved = plans;
      (isFrame ? moved.frames[0].pose : moved.targets[0].pose).translation().x() += 1.0;
      m_cell->plan(moved);
      QCOMPARE(change(), BasisChange::Targets);
      m_cell->document().history()->undo();
      QCOMPARE(change(), BasisChange::Nothing);
    }
  }

  // The joint values of the configuration of a waypoint; not those of other robots, nor other configurations.
  void itsConfigurations() {
    CellPlans plans = *m_cell->document().plans();
    plans.configurations = {{"home", m_cell->document().joints()}, {"other", m_cell->document().joints()}};
    plans.paths[0].waypoints[0].configuration = "home";
    m_cell->plan(plans);
    m_basis = basisOf(m_cell->content(), *storedPath());
    plans.configurations[1].joints[2] += 0.1;
    m_cell->plan(plans);
    QCOMPARE(change(), BasisChange::Nothing);
    for (const bool isRemoved : {false, true}) {
      CellPlans changed = plans;
      changed.configurations[0].joints[2] += 0.1;
      if (isRemoved) changed.configurations.clear();
      m_cell->plan(changed);
      QCOMPARE(change(), BasisChange::Configurations);
      m_cell->document().history()->undo();
      QCOMPARE(change(), BasisChange::Nothing);
    }
  }

  // The pose of a body counts, its look does not; the joints that the path sets may have any values.
  void bodiesAndJoints() {
    Body body = *m_cell->document().bodies().withId(m_box);
    body.look.colour = {1.0f, 0.0f, 0.0f};
    change(body);
    QCOMPARE(change(), BasisChange::Nothing);
    body.pose.translation().x() += 1.0;
    change(body);
    QCOMPARE(change(), BasisChange::Bodies);
    m_cell->document().history()->undo();
    m_cell->stand({0.3, 0.1, 0.0, 0.0, 0.0, 0.0});
    QCOMPARE(change(), BasisChange::Nothing);
  }

  // Another robot: when it comes, when it moves its joints, and when its base is moved. What is planned for it has its
  // own tool.
  void anotherRobot() {
    add("ur5");
    QCOMPARE(change(), BasisChange::Robots);
    m_basis = basisOf(m_cell->content(), *storedPath());
    JointValues joints = m_cell->document().joints();
    joints[7] += 0.1;
    m_cell->document().commit("Move", m_cell->document().jointEdit(joints));
    QCOMPARE(change(), BasisChange::Joints);
    m_cell->document().history()->undo();
    QCOMPARE(change(), BasisChange::Nothing);
    CellPlans plans = *m_cell->document().plans();
    plans.choose(m_cell->document().robot().arms[1].name, m_cell->document().robot().arms[0].name);
    plans.tool.translation().z() = 77.0;
    m_cell->plan(plans);
    QCOMPARE(change(), BasisChange::Nothing);
    auto moved = withRobotMoved(m_cell->content(), 1, poseOf({0.0, 2000.0, 0.0}, Vec3::Zero()));
    m_cell->document().commit("Base", m_cell->document().robotsEdit(std::move(moved).value(), 1));
    QCOMPARE(change(), BasisChange::Robots);
  }

  // The makers of the library's robots, whose controllers the posts are for; descriptions give the model alone.
  void thePostOfARobot() {
    const auto postOf = [](const char* title) { return std::string(usualPost({.name = "r", .title = title}).id()); };
    QCOMPARE(postOf("ABB IRB 120-3/0.6"), std::string("rapid"));
    QCOMPARE(postOf("KUKA KR 6 R900 sixx"), std::string("krl"));
    QCOMPARE(postOf("Universal Robots UR5"), std::string("urscript"));
    QCOMPARE(postOf("ur5_robot"), std::string("urscript"));
    QCOMPARE(postOf("lrmate200id"), std::string("fanuc"));
    QVERIFY(*usualPost({.name = "r", .title = "my arm"}).maker() == '\0');
  }

 private:
  const RobotPath* storedPath() { return &m_cell->document().plans()->paths.front(); }
  BasisChange change() { return changeSince(m_basis, m_cell->content(), *storedPath()); }
  void change(const Body& body) {
    m_cell->document().commit("Change", std::move(changeBodyEdit(m_cell->document().bodies(), body)).value());
  }
  void add(const char* id) {
    auto changed =
        withRobotAdded(m_cell->content(), {cellOf(*libraryTable(id)), "", poseOf({0, 1500, 0}, Vec3::Zero())});
    m_cell->document().commit("Add", m_cell->document().robotsEdit(std::move(changed).value()));
  }

  std::unique_ptr<ArmCell> m_cell;
  BodyId m_box = 0;
  PathBasis m_basis;
};

HANDWHEEL_TEST(PathBasisTest)
#include "PathBasisTest.moc"
