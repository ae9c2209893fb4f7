// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DragFixture.h"
#include "TestClass.h"
#include "tools/ToolRunner.h"

#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

class JointDragMannersTest : public QObject {
  Q_OBJECT

 private slots:
  void clicksChangeNothing();
  void comingBackChangesNothing();
  void jointsThatCannotMove();
  void escPutsBack();
  void theOtherButtonPutsBack();
  void nothingToTakeHoldOf();
  void previewMovesWhatMoves();
  void undoTakesItBack();
  void oddEvents();
};

void JointDragMannersTest::clicksChangeNothing() {
  Fixture fixture;
  JointDragTool tool(fixture.document(), fixture.picking("upper/0"));
  for (double y : {20.0, 0.1, 1.0 / 3.0}) {
    tool.pointer(at(Kind::Press, 300.7, y));
    tool.pointer(at(Kind::Drag, 300.7, y));
    tool.pointer(at(Kind::Release, 300.7, y));
  }
  QCOMPARE(fixture.document().history()->count(), 0);
  QVERIFY(!tool.isDragging());
}

// Out and back; and once around the axis, where there are no limits.
void JointDragMannersTest::comingBackChangesNothing() {
  Fixture fixture;
  const std::pair<const char*, std::vector<Vec3>> kRoutes[] = {
      {"upper/0", {{300.7, 0.3, 0}, {200, 200, 0}, {-50, 200, 0}, {300.7, 0.3, 0}}},
      {"finger/0", {{300.7, 0.3, 0}, {250, 80, 0}, {300.7, 0.3, 0}}},
      {"free/0", {{-700, 0.3, 0}, {-900, 200, 0}, {-1200, 100, 0}, {-1200, -100, 0}, {-900, -200, 0}, {-700, 0.3, 0}}}};
  for (const auto& [part, route] : kRoutes) {
    JointDragTool tool(fixture.document(), fixture.picking(part));
    tool.pointer(at(Kind::Press, route[0].x(), route[0].y()));
    for (const Vec3& p : route) {
      tool.pointer(at(Kind::Drag, p.x(), p.y()));
      if (&p == &route[1]) QVERIFY(tool.joints() != fixture.document().joints());
    }
    tool.pointer(at(Kind::Release, route.back().x(), route.back().y()));
    QVERIFY(!tool.isDragging());
    QCOMPARE(fixture.document().history()->count(), 0);
  }
}

void JointDragMannersTest::jointsThatCannotMove() {
  Fixture fixture("<robot name='r'>" + bar("foot") + bar("upper") + bar("lower") +
                  joint("shoulder", "revolute", "foot", "upper", 0, "0 0 1") +
                  joint("elbow", "revolute", "upper", "lower", 0.4, "0 0 1", "<limit lower='0.5' upper='0.5'/>") +
                  "</robot>");
  JointDragTool tool(fixture.document(), fixture.picking("lower/0"));
  tool.pointer(at(Kind::Press, 600, 0));
  QCOMPARE(tool.settings().at(0).label, std::string("shoulder"));
  tool.pointer(at(Kind::Release, 0, 600));
  QVERIFY(std::abs(fixture.document().joints()[0] - kPi / 2) < 1e-12);
  QCOMPARE(fixture.document().joints()[1], 0.5);
}

void JointDragMannersTest::escPutsBack() {
  Fixture fixture;
  JointDragTool tool(fixture.document(), fixture.picking("upper/0"));
  tool.pointer(at(Kind::Press, 300, 0));
  tool.pointer(at(Kind::Drag, 0, 300));
  QCOMPARE(tool.perform("revert"), ToolReply::Used);
  QCOMPARE(tool.joints()[0], 0.0);
  QCOMPARE(tool.pointer(at(Kind::Release, 0, 300)), ToolReply::Ignored);
  QCOMPARE(fixture.document().history()->count(), 0);
  QCOMPARE(tool.perform("revert"), ToolReply::Finished);
  QCOMPARE(tool.perform("nothing"), ToolReply::Ignored);
  // Return in the midst of a drag takes what is there.
  tool.pointer(at(Kind::Press, 300, 0));
  tool.pointer(at(Kind::Drag, 0, 300));
  QCOMPARE(tool.perform("commit"), ToolReply::Used);
  QVERIFY(std::abs(fixture.document().joints()[0] - kPi / 2) < 1e-12);
}

void JointDragMannersTest::theOtherButtonPutsBack() {
  Fixture fixture;
  JointDragTool tool(fixture.document(), fixture.picking("upper/0"));
  tool.pointer(at(Kind::Press, 300, 0));
  tool.pointer(at(Kind::Drag, 0, 300));
  PointerEvent other = at(Kind::Press, 0, 300);
  other.button = PointerButton::Second;
  QCOMPARE(tool.pointer(other), ToolReply::Used);
  QVERIFY(!tool.isDragging());
  QCOMPARE(tool.pointer(other), ToolReply::Ignored);  // the camera's
}

void JointDragMannersTest::nothingToTakeHoldOf() {
  Fixture fixture;
  JointDragTool foot(fixture.document(), fixture.picking("foot/0"));
  QCOMPARE(foot.pointer(at(Kind::Press, 300, 0)), ToolReply::Ignored);
  JointDragTool unknown(fixture.document(), fixture.picking("none/0"));
  QCOMPARE(unknown.pointer(at(Kind::Press, 300, 0)), ToolReply::Ignored);
  JointDragTool empty(fixture.document(), [](const Ray&) { return std::nullopt; });
  QCOMPARE(empty.pointer(at(Kind::Press, 300, 0)), ToolReply::Ignored);
  QCOMPARE(empty.pointer(at(Kind::Drag, 300, 0)), ToolReply::Ignored);
  // On the axis of the elbow: the shoulder has a lever there.
  JointDragTool axis(fixture.document(), fixture.picking("lower/0"));
  axis.pointer(at(Kind::Press, 400, 0));
  axis.pointer(at(Kind::Drag, 0, 400));
  QVERIFY(std::abs(axis.joints()[0] - kPi / 2) < 1e-12);
  QCOMPARE(axis.joints()[1], 0.0);
}

void JointDragMannersTest::previewMovesWhatMoves() {
  Fixture fixture;
  JointDragTool tool(fixture.document(), fixture.picking("lower/0"));
  QVERIFY(tool.preview().parts.empty() && tool.preview().lines.empty() && tool.settings().empty());
  tool.pointer(at(Kind::Hover, 600, 0));
  QCOMPARE(tool.preview().lines.size(), std::size_t{1});  // the axis that would turn
  const ToolPreview hovering = tool.preview();
  for (const Vec3& p : hovering.lines[0]) QVERIFY(Vec3(p - Vec3(400, 0, 0)).head<2>().norm() < 1e-9);
  QCOMPARE(tool.settings().at(0).label, std::string("elbow"));
  tool.pointer(at(Kind::Leave, 600, 0));
  QVERIFY(tool.preview().lines.empty());
  tool.pointer(at(Kind::Press, 600, 0));
  QVERIFY(tool.preview().parts.empty());
  tool.pointer(at(Kind::Drag, 400, 200));
  std::vector<std::string> names;
  const ToolPreview dragging = tool.preview();
  for (const DisplayPart& part : dragging.parts) names.push_back(part.name);
  QCOMPARE(names, (std::vector<std::string>{"lower/0", "sledge/0", "finger/0"}));
  QVERIFY((tool.preview().parts[0].pose.translation() - Vec3(400, 200, 0)).norm() < 1e-9);
  QVERIFY(std::abs(std::get<double>(tool.settings().at(0).value) - kPi / 2) < 1e-9);
  QCOMPARE(tool.settings().at(0).least, -2.0);
  QCOMPARE(tool.settings().at(0).largest, 2.0);
  QVERIFY(isEnabled(tool, "revert") && isEnabled(tool, "commit"));
  QCOMPARE(tool.needs(), std::vector<std::string>{"picking"});
}

// Run as the window runs it: the tool's own edit does not disturb it, an undo under it drops the drag.
void JointDragMannersTest::undoTakesItBack() {
  Fixture fixture;
  ToolRunner runner;
  runner.start(std::make_unique<JointDragTool>(fixture.document(), fixture.picking("upper/0")), fixture.document());
  runner.pointer(at(Kind::Press, 300, 0));
  runner.pointer(at(Kind::Drag, 0, 300));
  runner.pointer(at(Kind::Release, 0, 300));
  QVERIFY(std::abs(fixture.document().joints()[0] - kPi / 2) < 1e-12);
  runner.pointer(at(Kind::Press, 0, 300));
  runner.pointer(at(Kind::Drag, 300, 0));
  fixture.document().history()->undo();
  const auto* tool = static_cast<const JointDragTool*>(runner.tool());
  QVERIFY(tool && !tool->isDragging());
  QCOMPARE(tool->joints()[0], 0.0);
  runner.pointer(at(Kind::Release, 300, 0));
  QCOMPARE(fixture.document().history()->count(), 1);
  QVERIFY(!fixture.document().isModified());
}

void JointDragMannersTest::oddEvents() {
  Fixture fixture;
  JointDragTool tool(fixture.document(), fixture.picking("upper/0"));
  PointerEvent odd = at(Kind::Press, 300, 0);
  odd.ray.direction.setZero();
  QCOMPARE(tool.pointer(odd), ToolReply::Ignored);
  for (const Modifiers& modifiers : {kNoModifiers, kShift}) {
    tool.pointer(at(Kind::Press, 300, 0, modifiers));
    for (double bad : {std::nan(""), HUGE_VAL, 1e308, 1e150}) {
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

HANDWHEEL_TEST(JointDragMannersTest)
#include "JointDragMannersTest.moc"
