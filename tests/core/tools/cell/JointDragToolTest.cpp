// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/JointDragTool.h"

#include "ToolEvents.h"
#include "document/cell/CellDisplay.h"
#include "document/cell/CellKind.h"
#include "robot/Kinematics.h"
#include "robot/ShapeSurfaces.h"
#include "robot/UrdfReader.h"
#include "tools/ToolRunner.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>
#include <memory>
#include <numbers>

using namespace handwheel;
using test::above;
using test::Kind;

namespace {

constexpr double kPi = std::numbers::pi;

std::string bar(const std::string& name) {
  return "<link name='" + name + "'><visual><origin xyz='0.2 0 0'/><geometry><box size='0.4 0.1 0.1'/></geometry>" +
         "</visual></link>";
}

std::string joint(const std::string& name, const std::string& type, const std::string& parent, const std::string& child,
                  double x, const std::string& axis, const std::string& more = "<limit lower='-2' upper='2'/>") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" + child +
         "'/><origin xyz='" + std::to_string(x) + " 0 0'/><axis xyz='" + axis + "'/>" + more + "</joint>";
}

// Two arms of 400 mm in the plane z = 0, turning about z by at most 2 rad; a sledge on the second, along it; and a
// finger that turns with the second joint.
const std::string kRobot =
    "<robot name='r'>" + bar("foot") + bar("upper") + bar("lower") + bar("sledge") + bar("finger") + bar("free") +
    joint("shoulder", "revolute", "foot", "upper", 0, "0 0 1") +
    joint("elbow", "revolute", "upper", "lower", 0.4, "0 0 1") +
    joint("slide", "prismatic", "lower", "sledge", 0.4, "1 0 0", "<limit lower='0' upper='0.3'/>") +
    joint("grip", "revolute", "upper", "finger", 0.2, "0 0 1", "<limit lower='-2' upper='2'/><mimic joint='elbow'/>") +
    joint("spin", "continuous", "foot", "free", -1.0, "0 0 1", "") + "</robot>";

class Bench {
 public:
  Bench() {
    auto read = readUrdf(kRobot);
    auto robot = std::make_shared<CellRobot>();
    robot->model = std::move(read->robot);
    for (const Shape& shape : robot->model.shapes)
      robot->surfaces.push_back(std::make_shared<const TriangleSoup>(surfaceOf(shape)));
    auto cell = std::make_shared<CellSnapshot>();
    cell->joints = restValues(robot->model);
    cell->robot = robot;
    OpenedFile opened;
    opened.kind = &m_kind;
    opened.content = cell;
    m_document = std::make_unique<CellDocument>(std::move(opened));
  }

  CellDocument& document() { return *m_document; }

  // The rays of the tests look straight down; what they meet is told beforehand.
  JointDragTool::Pick picking(const std::string& part) {
    return [part](const Ray& ray) -> std::optional<CellPick> {
      return CellPick{part, Vec3(ray.origin.x(), ray.origin.y(), 0)};
    };
  }

 private:
  CellKind m_kind;
  std::unique_ptr<CellDocument> m_document;
};

PointerEvent at(Kind kind, double x, double y, Modifiers modifiers = {}) {
  return above(kind, x, y, modifiers);
}

}  // namespace

class JointDragToolTest : public QObject {
  Q_OBJECT

 private slots:
  void turnsByTheAngleOfThePointer();
  void stopsAtTheLimit();
  void slides();
  void wholeArm();
  void followersMoveWithTheirLeader();
  void continuousJoints();
  void clicksChangeNothing();
  void escPutsBack();
  void theOtherButtonPutsBack();
  void nothingToTakeHoldOf();
  void previewMovesWhatMoves();
  void undoTakesItBack();
  void oddEvents();
  void anyDragKeepsTheLimits();
};

void JointDragToolTest::turnsByTheAngleOfThePointer() {
  Bench bench;
  JointDragTool tool(bench.document(), bench.picking("upper/0"));
  QCOMPARE(tool.pointer(at(Kind::Press, 300, 0)), ToolReply::Used);
  QVERIFY(tool.isDragging());
  for (double angle : {0.1, 0.5, 1.2}) {
    tool.pointer(at(Kind::Drag, 300 * std::cos(angle), 300 * std::sin(angle)));
    QVERIFY(std::abs(tool.joints()[0] - angle) < 1e-12);
    QCOMPARE(bench.document().joints()[0], 0.0);  // not yet
  }
  tool.pointer(at(Kind::Release, 300 * std::cos(-0.7), 300 * std::sin(-0.7)));
  QVERIFY(!tool.isDragging());
  QVERIFY(std::abs(bench.document().joints()[0] + 0.7) < 1e-12);
  QCOMPARE(bench.document().history()->count(), 1);
  QCOMPARE(bench.document().history()->undoText(), QString("Move shoulder"));
  // The second arm turns about its own axis, wherever the first one has brought it.
  const Vec3 elbow(400 * std::cos(-0.7), 400 * std::sin(-0.7), 0);
  JointDragTool second(bench.document(), bench.picking("lower/0"));
  const auto on = [&](double angle) { return Vec3(elbow + 200 * Vec3(std::cos(angle), std::sin(angle), 0)); };
  second.pointer(at(Kind::Press, on(-0.7).x(), on(-0.7).y()));
  second.pointer(at(Kind::Drag, on(0.8).x(), on(0.8).y()));
  QVERIFY(std::abs(second.joints()[1] - 1.5) < 1e-9);
  QVERIFY(std::abs(second.joints()[0] + 0.7) < 1e-12);
}

// Past the limit and back again: the arm waits until the pointer is back.
void JointDragToolTest::stopsAtTheLimit() {
  Bench bench;
  JointDragTool tool(bench.document(), bench.picking("upper/0"));
  tool.pointer(at(Kind::Press, 300, 0));
  const std::pair<double, double> kWay[] = {{1.5, 1.5}, {2.5, 2.0}, {4.0, 2.0}, {5.5, 2.0}, {4.0, 2.0}, {1.0, 1.0}};
  for (const auto& [pointer, expected] : kWay) {
    tool.pointer(at(Kind::Drag, 300 * std::cos(pointer), 300 * std::sin(pointer)));
    QVERIFY(std::abs(tool.joints()[0] - expected) < 1e-9);
  }
}

void JointDragToolTest::slides() {
  Bench bench;
  JointDragTool tool(bench.document(), bench.picking("sledge/0"));
  tool.pointer(at(Kind::Press, 900, 10));
  tool.pointer(at(Kind::Drag, 1050, -70));
  QVERIFY(std::abs(tool.joints()[2] - 150) < 1e-9);
  tool.pointer(at(Kind::Drag, 2000, 10));
  QCOMPARE(tool.joints()[2], 300.0);
  tool.pointer(at(Kind::Release, 100, 10));
  QCOMPARE(bench.document().joints()[2], 0.0);
  QCOMPARE(bench.document().history()->count(), 0);  // back where it was
}

// The point that one holds comes under the pointer.
void JointDragToolTest::wholeArm() {
  Bench bench;
  JointDragTool tool(bench.document(), bench.picking("lower/0"));
  QVERIFY(bench.document().setProperty("joint.elbow", 0.5).hasValue());
  const RobotModel& robot = bench.document().robot().model;
  const std::uint32_t lower = linkNamed(robot, "lower");
  const Vec3 tip = linkPoses(robot, bench.document().joints())[lower] * Vec3(400, 0, 0);
  tool.pointer(at(Kind::Press, tip.x(), tip.y(), test::kShift));
  tool.pointer(at(Kind::Drag, 400, 450));
  const Vec3 moved = linkPoses(robot, tool.joints())[lower] * Vec3(400, 0, 0);
  QVERIFY((moved - Vec3(400, 450, 0)).norm() < 1e-3);
  QVERIFY(tool.joints()[0] != 0.0 && tool.joints()[1] != 0.5);
  tool.pointer(at(Kind::Release, 400, 450));
  QCOMPARE(bench.document().history()->undoText(), QString("Pull the arm"));
  QCOMPARE(bench.document().history()->count(), 2);
}

// The finger turns by what the elbow turns.
void JointDragToolTest::followersMoveWithTheirLeader() {
  Bench bench;
  JointDragTool tool(bench.document(), bench.picking("finger/0"));
  tool.pointer(at(Kind::Press, 500, 0));
  tool.pointer(at(Kind::Drag, 200 + 300 * std::cos(0.6), 300 * std::sin(0.6)));
  QCOMPARE(tool.joints()[0], 0.0);
  QVERIFY(std::abs(tool.joints()[1] - 0.6) < 1e-6);
}

void JointDragToolTest::continuousJoints() {
  Bench bench;
  JointDragTool tool(bench.document(), bench.picking("free/0"));
  tool.pointer(at(Kind::Press, -800, 0));
  for (double angle = 0.0; angle < 7.5; angle += 0.5)
    tool.pointer(at(Kind::Drag, -1000 + 200 * std::cos(angle), 200 * std::sin(angle)));
  tool.pointer(at(Kind::Release, -1000 + 200 * std::cos(7.5), 200 * std::sin(7.5)));
  const std::uint32_t dof = 3;
  QCOMPARE(bench.document().robot().model.jointOfDof(dof).name, std::string("spin"));
  QVERIFY(std::abs(bench.document().joints()[dof] - (7.5 - 2 * kPi)) < 1e-9);
}

void JointDragToolTest::clicksChangeNothing() {
  Bench bench;
  JointDragTool tool(bench.document(), bench.picking("upper/0"));
  for (double y : {20.0, 0.1, 1.0 / 3.0}) {
    tool.pointer(at(Kind::Press, 300.7, y));
    tool.pointer(at(Kind::Drag, 300.7, y));
    tool.pointer(at(Kind::Release, 300.7, y));
  }
  QCOMPARE(bench.document().history()->count(), 0);
  QVERIFY(!tool.isDragging());
}

void JointDragToolTest::escPutsBack() {
  Bench bench;
  JointDragTool tool(bench.document(), bench.picking("upper/0"));
  tool.pointer(at(Kind::Press, 300, 0));
  tool.pointer(at(Kind::Drag, 0, 300));
  QCOMPARE(tool.perform("revert"), ToolReply::Used);
  QCOMPARE(tool.joints()[0], 0.0);
  QCOMPARE(tool.pointer(at(Kind::Release, 0, 300)), ToolReply::Ignored);
  QCOMPARE(bench.document().history()->count(), 0);
  QCOMPARE(tool.perform("revert"), ToolReply::Finished);
  QCOMPARE(tool.perform("nothing"), ToolReply::Ignored);
  // Return in the midst of a drag takes what is there.
  tool.pointer(at(Kind::Press, 300, 0));
  tool.pointer(at(Kind::Drag, 0, 300));
  QCOMPARE(tool.perform("commit"), ToolReply::Used);
  QVERIFY(std::abs(bench.document().joints()[0] - kPi / 2) < 1e-12);
}

void JointDragToolTest::theOtherButtonPutsBack() {
  Bench bench;
  JointDragTool tool(bench.document(), bench.picking("upper/0"));
  tool.pointer(at(Kind::Press, 300, 0));
  tool.pointer(at(Kind::Drag, 0, 300));
  PointerEvent other = at(Kind::Press, 0, 300);
  other.button = PointerButton::Second;
  QCOMPARE(tool.pointer(other), ToolReply::Used);
  QVERIFY(!tool.isDragging());
  QCOMPARE(tool.pointer(other), ToolReply::Ignored);  // the camera's
}

void JointDragToolTest::nothingToTakeHoldOf() {
  Bench bench;
  JointDragTool foot(bench.document(), bench.picking("foot/0"));
  QCOMPARE(foot.pointer(at(Kind::Press, 300, 0)), ToolReply::Ignored);
  JointDragTool unknown(bench.document(), bench.picking("none/0"));
  QCOMPARE(unknown.pointer(at(Kind::Press, 300, 0)), ToolReply::Ignored);
  JointDragTool empty(bench.document(), [](const Ray&) { return std::nullopt; });
  QCOMPARE(empty.pointer(at(Kind::Press, 300, 0)), ToolReply::Ignored);
  QCOMPARE(empty.pointer(at(Kind::Drag, 300, 0)), ToolReply::Ignored);
  // On the axis of the elbow: the shoulder has a lever there.
  JointDragTool axis(bench.document(), bench.picking("lower/0"));
  axis.pointer(at(Kind::Press, 400, 0));
  axis.pointer(at(Kind::Drag, 0, 400));
  QVERIFY(std::abs(axis.joints()[0] - kPi / 2) < 1e-12);
  QCOMPARE(axis.joints()[1], 0.0);
}

void JointDragToolTest::previewMovesWhatMoves() {
  Bench bench;
  JointDragTool tool(bench.document(), bench.picking("lower/0"));
  QVERIFY(tool.preview().parts.empty() && tool.preview().lines.empty() && tool.settings().empty());
  tool.pointer(at(Kind::Hover, 600, 0));
  QCOMPARE(tool.preview().lines.size(), std::size_t{1});  // the axis that would turn
  for (const Vec3& p : tool.preview().lines[0]) QVERIFY(Vec3(p - Vec3(400, 0, 0)).head<2>().norm() < 1e-9);
  QCOMPARE(tool.settings().at(0).label, std::string("elbow"));
  tool.pointer(at(Kind::Leave, 600, 0));
  QVERIFY(tool.preview().lines.empty());
  tool.pointer(at(Kind::Press, 600, 0));
  QVERIFY(tool.preview().parts.empty());
  tool.pointer(at(Kind::Drag, 400, 200));
  std::vector<std::string> names;
  for (const DisplayPart& part : tool.preview().parts) names.push_back(part.name);
  QCOMPARE(names, (std::vector<std::string>{"lower/0", "sledge/0", "finger/0"}));
  QVERIFY((tool.preview().parts[0].pose.translation() - Vec3(400, 200, 0)).norm() < 1e-9);
  QVERIFY(std::abs(std::get<double>(tool.settings().at(0).value) - kPi / 2) < 1e-9);
  QVERIFY(test::isEnabled(tool, "revert") && test::isEnabled(tool, "commit"));
  QCOMPARE(tool.needs(), std::vector<std::string>{"picking"});
}

// Run as the window runs it: the tool's own edit does not disturb it, an undo under it drops the drag.
void JointDragToolTest::undoTakesItBack() {
  Bench bench;
  ToolRunner runner;
  runner.start(std::make_unique<JointDragTool>(bench.document(), bench.picking("upper/0")), bench.document());
  runner.pointer(at(Kind::Press, 300, 0));
  runner.pointer(at(Kind::Drag, 0, 300));
  runner.pointer(at(Kind::Release, 0, 300));
  QVERIFY(std::abs(bench.document().joints()[0] - kPi / 2) < 1e-12);
  runner.pointer(at(Kind::Press, 0, 300));
  runner.pointer(at(Kind::Drag, 300, 0));
  bench.document().history()->undo();
  const auto* tool = static_cast<const JointDragTool*>(runner.tool());
  QVERIFY(tool && !tool->isDragging());
  QCOMPARE(tool->joints()[0], 0.0);
  runner.pointer(at(Kind::Release, 300, 0));
  QCOMPARE(bench.document().history()->count(), 1);
  QVERIFY(!bench.document().isModified());
}

void JointDragToolTest::oddEvents() {
  Bench bench;
  JointDragTool tool(bench.document(), bench.picking("upper/0"));
  PointerEvent odd = at(Kind::Press, 300, 0);
  odd.ray.direction.setZero();
  QCOMPARE(tool.pointer(odd), ToolReply::Ignored);
  for (const Modifiers& modifiers : {test::kNoModifiers, test::kShift}) {
    tool.pointer(at(Kind::Press, 300, 0, modifiers));
    for (double bad : {NAN, INFINITY, 1e308, 1e150}) {
      for (int axis = 0; axis < 3; ++axis) {
        PointerEvent event = at(Kind::Drag, 300, 0);
        event.ray.origin[axis] = bad;
        tool.pointer(event);
        event = at(Kind::Drag, 300, 0);
        event.ray.direction[axis] = bad;
        tool.pointer(event);
        QVERIFY(tool.joints().allFinite());
      }
    }
    tool.perform("revert");
  }
  // A direction need not be of unit length.
  tool.pointer(at(Kind::Press, 300, 0));
  PointerEvent longer = at(Kind::Drag, 0, 300);
  longer.ray.direction *= 1e-3;
  tool.pointer(longer);
  QVERIFY(std::abs(tool.joints()[0] - kPi / 2) < 1e-9);
}

void JointDragToolTest::anyDragKeepsTheLimits() {
  QVERIFY(rc::check("limits", [] {
    Bench bench;
    const std::string parts[] = {"upper/0", "lower/0", "sledge/0", "finger/0", "free/0"};
    JointDragTool tool(bench.document(), bench.picking(parts[*rc::gen::inRange(0, 5)]));
    const auto coordinate = [] { return *rc::gen::inRange(-1500, 1501) / 1.0; };
    const double x = coordinate();
    tool.pointer(at(Kind::Press, x, coordinate(), *rc::gen::arbitrary<bool>() ? test::kShift : test::kNoModifiers));
    for (int i = *rc::gen::inRange(0, 6); i > 0; --i) {
      PointerEvent event = at(Kind::Drag, coordinate(), coordinate());
      event.ray.direction = Vec3(coordinate(), coordinate(), coordinate() - 1600).normalized();
      tool.pointer(event);
      RC_ASSERT(tool.joints().allFinite());
    }
    const JointValues shown = withinLimits(bench.document().robot().model, tool.joints());
    tool.perform("commit");
    RC_ASSERT(bench.document().joints() == shown);
    RC_ASSERT(withinLimits(bench.document().robot().model, shown) == shown);
    while (bench.document().history()->canUndo()) bench.document().history()->undo();
    RC_ASSERT(bench.document().joints().isZero(0.0));
  }));
}

QTEST_GUILESS_MAIN(JointDragToolTest)
#include "JointDragToolTest.moc"
