// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/ProcessPathTool.h"

#include "DragFixture.h"
#include "TestClass.h"
#include "document/scene/BodyChanges.h"
#include "scene/PrimitiveGeometry.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A cube of 20 mm beside a robot, its top at z = 10, and the tool. Whatever is pointed to is the cube.
class ProcessFixture {
 public:
  ProcessFixture() {
    Body cube{.name = "cube", .geometry = *PrimitiveGeometry::make(Primitive::Cuboid, {20, 20, 20})};
    cube.pose.translation() = Vec3(0, 500, 0);
    document().commit("Add", std::move(addBodyEdit(document().bodies(), cube)).value());
  }
  RobotCellDocument& document() { return m_fixture.document(); }
  // half: mm that the part reaches to either side; else whatever is pointed to is the part.
  ProcessPathTool tool(double half = 1e9) {
    ProcessPathServices services;
    services.pick = [half](const Ray& ray) -> std::optional<RobotCellPick> {
      if (std::abs(ray.origin.x()) > half) return std::nullopt;
      return RobotCellPick{"body.1", Vec3(ray.origin.x(), ray.origin.y(), 10.0)};
    };
    services.surface = [this](const BodyPointer& body) {
      return isPrepared ? std::make_shared<const PartSurface>(*body->geometry->surface()) : nullptr;
    };
    services.plan = [this](const OperationValues& values) { planned.push_back(values); };
    return {document(), std::move(services)};
  }

  std::vector<OperationValues> planned;
  bool isPrepared = true;

 private:
  Fixture m_fixture;
};

void click(ProcessPathTool& tool, double x, double y) {
  tool.pointer(above(Kind::Press, x, y));
  tool.pointer(above(Kind::Release, x, y));
}

double shownLength(const ProcessPathTool& tool) {
  const ToolPreview preview = tool.preview();
  if (preview.lines.empty()) return 0.0;
  double length = 0.0;
  for (std::size_t i = 1; i < preview.lines[0].size(); ++i)
    length += (preview.lines[0][i] - preview.lines[0][i - 1]).norm();
  return length;
}

}  // namespace

// Chooses and draws curves on parts.
class ProcessPathToolTest : public QObject {
  Q_OBJECT

 private slots:
  // The edge under the pointer, 20 mm, is shown, then taken.
  void anEdge() {
    ProcessFixture fixture;
    ProcessPathTool tool = fixture.tool();
    tool.pointer(above(Kind::Hover, 9.5, 500));
    QCOMPARE(shownLength(tool), 20.0);
    QVERIFY(!isEnabled(tool, "commit"));
    click(tool, 9.5, 500);
    QVERIFY(isEnabled(tool, "commit"));
    tool.perform("commit");
    QCOMPARE(fixture.planned.size(), std::size_t{1});
    QCOMPARE(fixture.planned[0].numbers("near"), (std::vector<double>{9.5, 500.0, 10.0}));
  }

  // An outline is hit by pointing beside it: 4 pixels beside the cube its edge is shown and taken, 40 beside nothing.
  void anEdgeFromOutside() {
    ProcessFixture fixture;
    ProcessPathTool tool = fixture.tool(10.0);
    const auto beside = [](Kind kind, double x) {
      PointerEvent event = above(kind, x, 500);
      event.pixel = 1.0;
      return event;
    };
    tool.pointer(beside(Kind::Hover, 50));
    QCOMPARE(shownLength(tool), 0.0);
    tool.pointer(beside(Kind::Hover, 14));
    QCOMPARE(shownLength(tool), 20.0);
    tool.pointer(beside(Kind::Press, 14));
    tool.pointer(beside(Kind::Release, 14));
    QVERIFY(isEnabled(tool, "commit"));
  }

  // The pointer rests on a part whose edges are still being looked for: they are shown once they are found.
  void anEdgeThatIsFoundLater() {
    ProcessFixture fixture;
    fixture.isPrepared = false;
    ProcessPathTool tool = fixture.tool();
    tool.pointer(above(Kind::Hover, 9.5, 500));
    QCOMPARE(shownLength(tool), 0.0);
    fixture.isPrepared = true;
    QCOMPARE(shownLength(tool), 20.0);
  }

  // Drawn by clicks, with the piece to the pointer shown; the last point is removed again.
  void drawnByClicks() {
    ProcessFixture fixture;
    ProcessPathTool tool = fixture.tool();
    tool.setSetting("along", PropertyValue(static_cast<double>(kAlongDrawn)));
    click(tool, -5, 495);
    QVERIFY(!isEnabled(tool, "commit") && !isEnabled(tool, "removeLast"));
    tool.pointer(above(Kind::Hover, 5, 495));
    QVERIFY(std::abs(shownLength(tool) - 10.0) < 1e-9);
    click(tool, 5, 495);
    click(tool, 5, 505);
    click(tool, -5, 505);
    QVERIFY(std::abs(shownLength(tool) - 30.0) < 1e-9);
    tool.perform("removeLast");
    QVERIFY(std::abs(shownLength(tool) - 20.0) < 1e-9);
    tool.pointer(above(Kind::Hover, -9, 505));  // A point under the pointer alone is not taken
    tool.perform("commit");
    QCOMPARE(fixture.planned.size(), std::size_t{1});
    QCOMPARE(fixture.planned[0].text("through"), std::string("5,495,10;5,505,10"));
    QCOMPARE(tool.perform("revert"), ToolReply::Used);
    QCOMPARE(shownLength(tool), 0.0);
    QCOMPARE(tool.perform("revert"), ToolReply::Finished);
  }

  // Drawn in one stroke: a point every twelve pixels.
  void drawnInOneGo() {
    ProcessFixture fixture;
    ProcessPathTool tool = fixture.tool();
    tool.setSetting("along", PropertyValue(static_cast<double>(kAlongDrawn)));
    tool.pointer(above(Kind::Press, -5, 500));
    for (int i = 1; i <= 100; ++i) tool.pointer(above(Kind::Drag, -5 + 0.1 * i, 500));
    tool.pointer(above(Kind::Release, 5, 500));
    QVERIFY(std::abs(shownLength(tool) - 10.0) < 0.2);
    tool.perform("commit");
    QCOMPARE(std::ranges::count(fixture.planned.at(0).text("through"), ';'), 49);  // 0.2 mm: pixels are 0.01, drags 0.1
  }

  // A curve on a part that moves away is discarded; another kind of curve begins anew.
  void whatChangesBelow() {
    ProcessFixture fixture;
    ProcessPathTool tool = fixture.tool();
    tool.setSetting("along", PropertyValue(static_cast<double>(kAlongDrawn)));
    click(tool, -5, 500);
    click(tool, 5, 500);
    fixture.document().history()->undo();
    tool.documentChanged();
    QCOMPARE(shownLength(tool), 0.0);
    QVERIFY(!isEnabled(tool, "commit"));
    fixture.document().history()->redo();
    tool.documentChanged();
    click(tool, -5, 500);
    click(tool, 5, 500);
    tool.setSetting("along", PropertyValue(1.0));
    QVERIFY(std::abs(shownLength(tool) - 80.0) < 1e-9);  // a section across x, all around
    tool.setSetting("along", PropertyValue(static_cast<double>(kAlongDrawn)));
    QCOMPARE(shownLength(tool), 0.0);
  }
};

HANDWHEEL_TEST(ProcessPathToolTest)
#include "ProcessPathToolTest.moc"
