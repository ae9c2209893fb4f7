// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ArmCell.h"
#include "TestClass.h"
#include "document/cell/CellArms.h"
#include "document/cell/RobotChanges.h"
#include "document/scene/BodyEdit.h"
#include "tools/cell/ProcessPathOperation.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kSame = 1e-4;  // mm, of inverse kinematics

// A block before the arm, with the tool above it.
class BlockCell {
 public:
  BlockCell() {
    m_cell.stand({0.0, 0.5, 0.3, 0.0, 0.77, 0.0});
    m_block = m_cell.addBox({100, 100, 60}, {350, 0, 230});
  }
  RobotCellDocument& document() { return m_cell.document(); }
  auto scene() { return m_cell.scene(); }
  void stand(std::initializer_list<double> joints) { m_cell.stand(joints); }
  Body block() { return *document().bodies().withId(m_block); }
  Result<PlannedPath> planned(const OperationValues& values, const std::optional<Pose>& chosenAt = {}) {
    const Body body = block();
    const auto surface = std::make_shared<const PartSurface>(*body.geometry->surface());
    return processPath(*m_cell.scene(), m_cell.content(), values, surface, body, {}, chosenAt);
  }
  void moveBlock(const Pose& by) {
    auto moved = std::make_shared<Body>(block());
    moved->pose = by * moved->pose;
    document().commit("Move", std::make_unique<BodyEdit>(std::vector<BodyEdit::Change>{{m_block, std::move(moved)}}));
  }
  void setTool(const Pose& tool) {
    CellPlans plans = *document().plans();
    plans.tool = tool;
    m_cell.plan(plans);
  }
  OutdatedReasons outdated(const PlannedPath& planned) {
    return outdatedReasonsOf(document().robot(), document().placement(), planned.path);
  }
  // Returns the poses of the tool centre point at the waypoints of a path, in the base frame.
  std::vector<Pose> tools(const PlannedPath& planned) {
    std::vector<Pose> all;
    const auto scene = m_cell.scene();
    for (const Waypoint& waypoint : planned.path.waypoints)
      all.push_back(scene->arm.tipPose(scene->planned(waypoint.joints)) * document().plans()->tool);
    return all;
  }

 private:
  ArmCell m_cell;
  BodyId m_block;
};

OperationValues valuesAlong(std::size_t along) {
  OperationValues values(processPathOperation());
  values.setValid("part", std::string("box1"));
  values.setValid("along", static_cast<double>(along));
  values.setValid("near", std::vector<double>{350.0, along == kAlongEdge ? -50.0 : 0.0, 260.0});
  values.setValid("length", 40.0);
  values.setValid("standoff", 20.0);
  values.setValid("tilt", 0.2);
  if (along == kAlongDrawn) values.setValid("through", std::string("370,10,260;380,-5,260"));
  return values;
}

}  // namespace

// Paths along curves on parts keep what made them, and are made again where the part is.
class ProcessPathTest : public QObject {
  Q_OBJECT

 private slots:
  // The part is moved and turned about the vertical: the tool follows the same curve of it, so all its poses are moved
  // and turned alike. The first and the last, approach and retract, too.
  void thePartHasMoved_data() {
    QTest::addColumn<int>("along");
    for (const int along : {int(kAlongEdge), 1, 2, int(kAlongDrawn)}) QTest::addRow("%d", along) << along;
  }
  void thePartHasMoved() {
    QFETCH(const int, along);
    BlockCell cell;
    const auto before = cell.planned(valuesAlong(static_cast<std::size_t>(along)));
    QVERIFY2(before.hasValue(), before.hasValue() ? "" : before.error().code->id);
    QVERIFY(before->path.process.has_value());
    const Pose by(Eigen::Translation3d(15, -25, -10) * Eigen::AngleAxisd(0.15, Vec3::UnitZ()));
    const std::vector<Pose> old = cell.tools(*before);
    cell.moveBlock(by);
    const PathProcess& process = *before->path.process;
    const auto after = cell.planned(valuesOf(process), process.part);
    QVERIFY2(after.hasValue(), after.hasValue() ? "" : after.error().code->id);
    const std::vector<Pose> tools = cell.tools(*after);
    QCOMPARE(tools.size(), old.size());
    for (std::size_t i = 0; i < old.size(); ++i)
      QVERIFY(((by * old[i]).matrix() - tools[i].matrix()).cwiseAbs().maxCoeff() < kSame);
    // It keeps where it was chosen: again and again nothing creeps.
    QVERIFY(after->path.process->part.isApprox(process.part, kSame));
    QVERIFY(after->path.process->values == process.values);
    QVERIFY(after->path.process->planned.isApprox(by * process.planned, kSame));
  }

  // A path along a part that has moved since does not meet its curve any more, and that is said; planned again it does.
  void aPartThatHasMoved() {
    BlockCell cell;
    const auto before = cell.planned(valuesAlong(kAlongEdge));
    QVERIFY(before.hasValue());
    QVERIFY(!cell.outdated(*before).isAny());
    const std::optional<Pose>& base = before->path.process->base;
    QVERIFY(base && base->isApprox(Pose::Identity()));  // Base of the first robot, which is the root
    cell.moveBlock(Pose(Eigen::Translation3d(10, 0, 0)));
    QVERIFY(!cell.outdated(*before).part.empty());
    const auto after = cell.planned(valuesOf(*before->path.process), before->path.process->part);
    QVERIFY(after.hasValue());
    QVERIFY(!cell.outdated(*after).isAny());
  }

  // With another centre point of the tool it leads beside the curve; planned again, the new point is on it. Nothing is
  // said of paths whose tool is not known.
  void anotherTool() {
    BlockCell cell;
    const auto before = cell.planned(valuesAlong(kAlongEdge));
    QVERIFY(before.hasValue());
    const std::vector<Pose> old = cell.tools(*before);
    cell.setTool(Pose(Eigen::Translation3d(0, 0, 12)));
    const OutdatedReasons outdated = cell.outdated(*before);
    QVERIFY(outdated.isToolOther && outdated.part.empty() && outdated.targets.empty());
    const auto after = cell.planned(valuesOf(*before->path.process), before->path.process->part);
    QVERIFY(after.hasValue());
    QVERIFY(!cell.outdated(*after).isAny());
    const std::vector<Pose> tools = cell.tools(*after);
    QCOMPARE(tools.size(), old.size());
    for (std::size_t i = 0; i < old.size(); ++i)
      QVERIFY((old[i].translation() - tools[i].translation()).norm() < kSame);
    PlannedPath unknown = *before;
    unknown.path.process->tool.reset();
    QVERIFY(!cell.outdated(unknown).isAny());
  }

  // A path does not move with the base of its robot: the tool misses the curve. Where the part was moved as the robot
  // was, it meets it again. A path that does not tell where the robot stood does from the first move on.
  void aRobotThatHasMoved() {
    ArmCell cell;
    RobotCellDocument& document = cell.document();
    const Pose stood = poseOf({0, 1500, 0}, Vec3::Zero());
    auto robots = withRobotAdded(cell.content(), {cellOf(*libraryTable("ur5")), "left", stood});
    document.commit("Add", document.robotsEdit(std::move(robots).value()));
    const BodyId box = cell.addBox({100, 100, 60}, {350, 1500, 230});
    PathProcess process{.values = {{"part", std::string("box1")}}, .part = document.bodies().withId(box)->pose};
    process.planned = process.part;
    CellPlans plans = *document.plans();
    plans.paths.push_back({.name = "unknown", .waypoints = {}, .arm = "left", .process = process});
    process.base = stood;
    plans.paths.push_back({.name = "known", .waypoints = {}, .arm = "left", .process = process});
    cell.plan(plans);
    const auto outdated = [&](const char* path) {
      return outdatedReasonsOf(document.robot(), document.placement(), *document.plans()->path(path));
    };
    const auto moveTo = [&](const Pose& base) {
      auto moved = withRobotMoved(cell.content(), 1, base);
      QVERIFY(moved.hasValue());
      document.commit("Move", document.robotsEdit(std::move(moved).value(), 1));
    };
    QVERIFY(!outdated("known").isAny() && !outdated("unknown").isAny());
    const Pose by(Eigen::Translation3d(15, -25, -10) * Eigen::AngleAxisd(0.15, Vec3::UnitZ()));
    moveTo(by * stood);
    for (const char* path : {"known", "unknown"}) QVERIFY((outdated(path) == OutdatedReasons{.isBaseOther = true}));
    auto moved = std::make_shared<Body>(*document.bodies().withId(box));
    moved->pose = by * moved->pose;
    document.commit("Move", std::make_unique<BodyEdit>(std::vector<BodyEdit::Change>{{box, std::move(moved)}}));
    for (const char* path : {"known", "unknown"}) QVERIFY(!outdated(path).isAny());
    moveTo(stood);
    for (const char* path : {"known", "unknown"}) QVERIFY((outdated(path) == OutdatedReasons{.part = "box1"}));
  }

  // Joint 6 turns by more than one revolution: from the present values, nearly a revolution is behind it. The path
  // comes from another waypoint, and needs no more than half a revolution of that joint from there, as any attitude of
  // the tool does.
  void whereTheRobotStands_data() {
    QTest::addColumn<bool>("isFree");
    QTest::newRow("held") << false;
    QTest::newRow("free to turn") << true;
  }
  void whereTheRobotStands() {
    QFETCH(const bool, isFree);
    BlockCell cell;
    CellPlans plans = *cell.document().plans();
    plans.configurations.push_back({.name = "left", .joints = cell.document().joints()});
    cell.document().commit("Plan", cell.document().plansEdit(plans));
    OperationValues values = valuesAlong(kAlongEdge);
    values.setValid("free", isFree);
    for (const char* const end : {"from", "to"}) values.setValid(end, std::string("left"));
    const auto expected = cell.planned(values);
    QVERIFY2(expected.hasValue(), expected.hasValue() ? "" : expected.error().code->id);
    cell.stand({0.0, 0.5, 0.3, 0.0, 0.77, -6.1});
    const auto planned = cell.planned(values);
    QVERIFY2(planned.hasValue(), planned.hasValue() ? "" : planned.error().code->id);
    // The approach and the retraction may be planned freely.
    const auto onCurve = [](const PlannedPath& path) {
      const auto isCalled = [](const char* name) { return [name](const Waypoint& each) { return each.name == name; }; };
      const std::vector<Waypoint>& all = path.path.waypoints;
      const auto first = std::find_if(all.begin(), all.end(), isCalled("approach"));
      return std::vector<Waypoint>(first, std::find_if(first, all.end(), isCalled("retract")));
    };
    const std::vector<Waypoint> wanted = onCurve(*expected), found = onCurve(*planned);
    QVERIFY(found.size() >= 3);  // with the approach
    QVERIFY(std::abs(found.front().joints[5]) <= std::numbers::pi + kSame);
    QCOMPARE(found.size(), wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      QVERIFY((found[i].joints - wanted[i].joints).cwiseAbs().maxCoeff() < kSame);
  }

  void valuesComeBack() {
    BlockCell cell;
    const OperationValues values = valuesAlong(kAlongEdge);
    const auto planned = cell.planned(values);
    QVERIFY(planned.hasValue());
    QVERIFY(valuesOf(*planned->path.process) == values);
    // A process of another version of the program: unknown values, and those beyond their range, are left out.
    PathProcess other = *planned->path.process;
    other.values["colour"] = std::string("red");
    other.values["tilt"] = 99.0;
    OperationValues expected = values;
    expected.reset("tilt");
    QVERIFY(valuesOf(other) == expected);
  }
};

HANDWHEEL_TEST(ProcessPathTest)
#include "ProcessPathTest.moc"
