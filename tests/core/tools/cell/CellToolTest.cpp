// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/CellTool.h"

#include "DragBench.h"
#include "TestClass.h"
#include "document/scene/BodyChanges.h"
#include "scene/PrimitiveGeometry.h"
#include "scene/RigidPose.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A robot with a cube of 20 mm beside it, and its tool.
class CellBench {
 public:
  CellBench() {
    Body cube{.name = "cube", .geometry = *PrimitiveGeometry::make(Primitive::Cuboid, {20, 20, 20})};
    cube.pose = poseOf({0, 500, 0}, {0, 0, 0.3});
    document().commit("Add", std::move(addBodyEdit(document().bodies(), cube)).value());
  }
  RobotCellDocument& document() { return m_bench.document(); }
  CellTool tool(const std::string& part) { return CellTool(document(), selection, m_bench.picking(part)); }
  Vec3 place() { return document().bodies().withId(1)->pose.translation(); }
  int steps() { return document().history()->count(); }

  BodySelection selection;

 private:
  Bench m_bench;
};

}  // namespace

class CellToolTest : public QObject {
  Q_OBJECT

 private slots:
  void aClickSelects() {
    CellBench bench;
    CellTool tool = bench.tool("body.1");
    QCOMPARE(tool.pointer(at(Kind::Press, 0, 500)), ToolReply::Used);
    QCOMPARE(tool.pointer(at(Kind::Release, 0, 500)), ToolReply::Used);
    QCOMPARE(bench.selection.body(), std::optional<BodyId>(1));
    QCOMPARE(bench.steps(), 1);
    QCOMPARE(tool.preview().lines.size(), std::size_t{12});  // the edges of its box
  }

  // Rays from above: the plane of the view is horizontal.
  void aDragIsOneStep() {
    CellBench bench;
    CellTool tool = bench.tool("body.1");
    tool.pointer(at(Kind::Press, 5, 505));
    for (double x : {10.0, 25.0, 60.0}) QCOMPARE(tool.pointer(at(Kind::Drag, x, 480)), ToolReply::Used);
    QCOMPARE(bench.place(), Vec3(0, 500, 0));  // a preview so far
    QCOMPARE(tool.preview().parts.size(), std::size_t{1});
    QVERIFY((tool.preview().parts[0].pose.translation() - Vec3(55, 475, 0)).norm() < 1e-9);
    QCOMPARE(tool.settings().size(), std::size_t{3});
    tool.pointer(at(Kind::Release, 65, 480));
    QVERIFY((bench.place() - Vec3(60, 475, 0)).norm() < 1e-9);
    QCOMPARE(bench.steps(), 2);
    bench.document().history()->undo();
    QCOMPARE(bench.place(), Vec3(0, 500, 0));
  }

  void escapeTakesItBack() {
    CellBench bench;
    CellTool tool = bench.tool("body.1");
    tool.pointer(at(Kind::Press, 0, 500));
    tool.pointer(at(Kind::Drag, 50, 500));
    QCOMPARE(tool.perform("revert"), ToolReply::Used);
    QVERIFY(tool.preview().parts.empty());
    tool.pointer(at(Kind::Release, 50, 500));
    QCOMPARE(bench.steps(), 1);
    QCOMPARE(bench.place(), Vec3(0, 500, 0));
  }

  void theRobotIsMovedAsBefore() {
    CellBench bench;
    CellTool tool = bench.tool("upper/0");
    QCOMPARE(tool.pointer(at(Kind::Press, 300, 0)), ToolReply::Used);
    tool.pointer(at(Kind::Drag, 0, 300));
    tool.pointer(at(Kind::Release, 0, 300));
    QVERIFY(std::abs(bench.document().joints()[0] - 0.5 * kPi) < 1e-6);
    QVERIFY(!bench.selection.body());
    CellTool nothing = bench.tool("");
    QCOMPARE(nothing.pointer(at(Kind::Press, 0, 0)), ToolReply::Ignored);  // the camera's
  }

  void deleting() {
    CellBench bench;
    CellTool tool = bench.tool("body.1");
    QCOMPARE(tool.perform("delete"), ToolReply::Ignored);  // nothing is selected
    bench.selection.select(1);
    QCOMPARE(tool.perform("delete"), ToolReply::Used);
    tool.documentChanged();
    QVERIFY(bench.document().bodies().empty() && !bench.selection.body());
    bench.document().history()->undo();
    QCOMPARE(bench.place(), Vec3(0, 500, 0));
  }

  // The scene has an end.
  void nothingGoesTooFar() {
    CellBench bench;
    CellTool tool = bench.tool("body.1");
    tool.pointer(at(Kind::Press, 0, 500));
    tool.pointer(at(Kind::Drag, 1e9, 500));
    tool.pointer(at(Kind::Release, 1e9, 500));
    QVERIFY(isRigid(bench.document().bodies().withId(1)->pose));
  }

  void changesEndADrag() {
    CellBench bench;
    CellTool tool = bench.tool("body.1");
    tool.pointer(at(Kind::Press, 0, 500));
    tool.pointer(at(Kind::Drag, 50, 500));
    bench.document().history()->undo();
    tool.documentChanged();
    QVERIFY(!bench.selection.body() && tool.preview().parts.empty());
    tool.pointer(at(Kind::Release, 50, 500));
    QVERIFY(bench.document().bodies().empty());
  }
};

HANDWHEEL_TEST(CellToolTest)
#include "CellToolTest.moc"
