// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/CellTool.h"

#include "DragFixture.h"
#include "TestClass.h"
#include "document/cell/BodyCarriers.h"
#include "document/scene/BodyChanges.h"
#include "scene/PrimitiveGeometry.h"
#include "scene/RigidPose.h"

#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kAway = 1000.0;

// Along y and down, through a point; a pixel is 0.01.
PointerEvent slanted(Kind kind, const Vec3& through, double slope, Modifiers modifiers = {}) {
  PointerEvent event = at(kind, 0, 0, modifiers);
  event.ray = {through - Vec3(0, kAway, -slope * kAway), Vec3(0, 1, -slope).normalized()};
  return event;
}

// A robot with a cube of 20 mm beside it, and its tool.
class CellFixture {
 public:
  CellFixture() {
    Body cube{.name = "cube", .geometry = *PrimitiveGeometry::make(Primitive::Cuboid, {20, 20, 20})};
    cube.pose = poseOf({0, 500, 0}, {0, 0, 0.3});
    document().commit("Add", std::move(addBodyEdit(document().bodies(), cube)).value());
  }
  RobotCellDocument& document() { return m_fixture.document(); }
  CellTool tool(const std::string& part) { return CellTool(document(), selection, m_fixture.picking(part)); }
  Vec3 position() { return document().bodies().withId(1)->pose.translation(); }
  void raise(double z) {
    Body cube = *document().bodies().withId(1);
    cube.pose.translation().z() = z;
    BodySet raised = document().bodies();
    document().commit("Raise", std::move(changeBodyEdit(raised, cube)).value());
    document().history()->clear();
  }
  // The cube is hit where the rays of slanted() go.
  CellTool slantedTool(double slope) {
    return CellTool(document(), selection, [slope](const Ray& ray) -> std::optional<RobotCellPick> {
      return RobotCellPick{"body.1", ray.origin + Vec3(0, kAway, -slope * kAway)};
    });
  }
  int steps() { return document().history()->count(); }

  BodySelection selection;

 private:
  Fixture m_fixture;
};

// Returns the displayed pose of the cube.
Pose bodyShown(const CellTool& tool) {
  const auto shown = tool.preview().replaced;
  for (const DisplayPart& part : shown ? shown->parts : std::vector<DisplayPart>()) {
    if (part.name == "body.1") return part.pose;
  }
  return poseOf({1e9, 1e9, 1e9}, {0, 0, 0});
}

}  // namespace

class CellToolTest : public QObject {
  Q_OBJECT

 private slots:
  void aClickSelects() {
    CellFixture fixture;
    CellTool tool = fixture.tool("body.1");
    QCOMPARE(tool.pointer(at(Kind::Press, 0, 500)), ToolReply::Used);
    QCOMPARE(tool.pointer(at(Kind::Release, 0, 500)), ToolReply::Used);
    QCOMPARE(fixture.selection.body(), std::optional<BodyId>(1));
    QCOMPARE(fixture.steps(), 1);
    QVERIFY(!tool.preview().replaced);  // it has not moved
  }

  // A body that the robot carries is a part of it: dragged, it moves the joint, and stays selected.
  void aCarriedBodyMovesTheJoint() {
    CellFixture fixture;
    const RobotModel& robot = fixture.document().robot().model;
    fixture.document().commit("Mount",
                              std::move(mountEdit(fixture.document().bodies(), 1, toolLink(robot), robot)).value());
    const JointValues before = fixture.document().joints();
    const int steps = fixture.steps();
    CellTool tool = fixture.tool("body.1");
    QCOMPARE(tool.pointer(at(Kind::Press, 850, 0)), ToolReply::Used);
    QCOMPARE(fixture.selection.body(), std::optional<BodyId>(1));
    tool.pointer(at(Kind::Drag, 950, 20));
    QVERIFY((bodyShown(tool).translation() - Vec3(900, 0, 0)).norm() < 1e-9);
    tool.pointer(at(Kind::Release, 950, 20));
    QCOMPARE(fixture.steps(), steps + 1);
    const std::uint32_t slide = dofMoving(robot, toolLink(robot));
    QCOMPARE(fixture.document().joints()[slide], before[slide] + 100.0);
    QCOMPARE(fixture.document().bodies().withId(1)->pose.matrix(), Pose::Identity().matrix());
  }

  // Collisions are marked at the displayed joints and poses.
  void marksWhatItShows() {
    CellFixture fixture;
    int marked = 0;
    CellTool tool(
        fixture.document(), fixture.selection,
        [](const Ray& ray) -> std::optional<RobotCellPick> {
          return RobotCellPick{"body.1", Vec3(ray.origin.x(), ray.origin.y(), 0)};
        },
        [&](DisplayModel& shown, const JointValues& joints, const Body* moved) {
          ++marked;
          QVERIFY(joints == fixture.document().joints());
          QVERIFY(moved && moved->id == 1);
          for (DisplayPart& part : shown.parts) part.colour = {1.0f, 0.0f, 0.0f};
        });
    tool.pointer(at(Kind::Press, 5, 505));
    QVERIFY(!tool.preview().replaced);
    QCOMPARE(marked, 0);
    tool.pointer(at(Kind::Drag, 60, 480));
    const auto shown = tool.preview().replaced;
    QCOMPARE(marked, 1);
    QVERIFY(shown && shown->parts.back().colour[1] == 0.0f);
  }

  void aDragIsOneStep() {
    CellFixture fixture;
    CellTool tool = fixture.tool("body.1");
    tool.pointer(at(Kind::Press, 5, 505));
    for (double x : {10.0, 25.0, 60.0}) QCOMPARE(tool.pointer(at(Kind::Drag, x, 480)), ToolReply::Used);
    QCOMPARE(fixture.position(), Vec3(0, 500, 0));  // a preview so far
    QVERIFY((bodyShown(tool).translation() - Vec3(55, 475, 0)).norm() < 1e-9);
    QCOMPARE(tool.settings().size(), std::size_t{3});
    for (const Property& position : tool.settings())
      QVERIFY(std::isinf(position.least) && std::isinf(position.largest));
    tool.pointer(at(Kind::Release, 65, 480));
    QVERIFY((fixture.position() - Vec3(60, 475, 0)).norm() < 1e-9);
    QCOMPARE(fixture.steps(), 2);
    fixture.document().history()->undo();
    QCOMPARE(fixture.position(), Vec3(0, 500, 0));
  }

  // Seen from the side and above, as a table is: the drag goes along the floor.
  void theHeightIsKept() {
    CellFixture fixture;
    fixture.raise(0.1 + 0.2);  // not a multiple of any step
    const double height = fixture.position().z();
    CellTool tool = fixture.slantedTool(1.0);
    tool.pointer(slanted(Kind::Press, {3, 500, height}, 1.0));
    for (double x : {30.0, 103.0}) tool.pointer(slanted(Kind::Drag, {x, 540, height}, 1.0));
    tool.pointer(slanted(Kind::Release, {103, 540, height}, 1.0));
    QVERIFY((fixture.position() - Vec3(100, 540, height)).norm() < 1e-6);
    QCOMPARE(fixture.position().z(), height);
  }

  void shiftMovesUpAndDown() {
    CellFixture fixture;
    CellTool tool = fixture.slantedTool(0.5);
    tool.pointer(slanted(Kind::Press, {0, 500, 0}, 0.5, kShift));
    tool.pointer(slanted(Kind::Drag, {0, 500, 40}, 0.5, kShift));
    QVERIFY((bodyShown(tool).translation() - Vec3(0, 500, 40)).norm() < 1e-6);
    tool.pointer(slanted(Kind::Drag, {70, 500, 40}, 0.5));  // without Shift it goes on from there
    tool.pointer(slanted(Kind::Release, {70, 500, 40}, 0.5));
    QVERIFY((fixture.position() - Vec3(70, 500, 40)).norm() < 1e-6);
    QCOMPARE(fixture.steps(), 2);
  }

  // A plane seen at less than 15° would run away under the pointer.
  void aFlatViewMovesUpAndDown() {
    const double tangent = std::tan(10.0 / 180.0 * kPi);
    CellFixture fixture;
    CellTool tool = fixture.slantedTool(tangent);
    tool.pointer(slanted(Kind::Press, {0, 500, 0}, tangent));
    tool.pointer(slanted(Kind::Release, {30, 500, 25}, tangent));
    QCOMPARE(Vec3(fixture.position().x(), fixture.position().y(), 0), Vec3(0, 500, 0));
    QVERIFY(std::abs(fixture.position().z() - 25) < 1e-6);
  }

  void placesSnapToAStepThatFitsTheZoom_data() {
    QTest::addColumn<double>("pixel");
    QTest::addColumn<double>("step");  // 1, 2 or 5 times a power of ten, of at least four pixels
    QTest::newRow("near") << 0.01 << 0.05;
    QTest::newRow("tenths") << 0.02 << 0.1;
    QTest::newRow("usual") << 0.4 << 2.0;
    QTest::newRow("far") << 2.0 << 10.0;
  }
  void placesSnapToAStepThatFitsTheZoom() {
    QFETCH(double, pixel);
    QFETCH(double, step);
    for (const Modifiers modifiers : {kNoModifiers, kControl}) {
      CellFixture fixture;
      CellTool tool = fixture.tool("body.1");
      PointerEvent event = at(Kind::Press, 0, 500, modifiers);
      event.pixel = pixel;
      tool.pointer(event);
      event.kind = Kind::Release;
      event.ray.origin.x() = 30.4 * step;
      event.ray.origin.y() += 0.1 * step;  // the hand trembles
      tool.pointer(event);
      const bool snaps = !modifiers.control;
      QVERIFY(std::abs(fixture.position().x() - (snaps ? 30.0 : 30.4) * step) < 1e-9);
      QVERIFY(std::abs(fixture.position().y() - (snaps ? 500.0 : 500.0 + 0.1 * step)) < 1e-9);
    }
  }

  void escapeDeselects() {
    CellFixture fixture;
    CellTool tool = fixture.tool("body.1");
    fixture.selection.select(1);
    QVERIFY(isEnabled(tool, "revert"));
    QCOMPARE(tool.perform("revert"), ToolReply::Used);
    QVERIFY(fixture.selection.empty());
    QCOMPARE(tool.perform("revert"), ToolReply::Finished);
    QCOMPARE(fixture.steps(), 1);
  }

  void aPressOnTheRobotDeselects() {
    CellFixture fixture;
    fixture.selection.select(1);
    CellTool tool = fixture.tool("upper/0");
    QCOMPARE(tool.pointer(at(Kind::Press, 850, 0)), ToolReply::Used);
    QVERIFY(fixture.selection.empty());
    tool.pointer(at(Kind::Release, 300, 0));
    QCOMPARE(tool.perform("delete"), ToolReply::Ignored);
  }

  void escapeTakesItBack() {
    CellFixture fixture;
    CellTool tool = fixture.tool("body.1");
    tool.pointer(at(Kind::Press, 0, 500));
    tool.pointer(at(Kind::Drag, 50, 500));
    QCOMPARE(tool.perform("revert"), ToolReply::Used);
    QVERIFY(!tool.preview().replaced);
    tool.pointer(at(Kind::Release, 50, 500));
    QCOMPARE(fixture.steps(), 1);
    QCOMPARE(fixture.position(), Vec3(0, 500, 0));
  }

  void theRobotIsMovedAsBefore() {
    CellFixture fixture;
    CellTool tool = fixture.tool("upper/0");
    QCOMPARE(tool.pointer(at(Kind::Press, 850, 0)), ToolReply::Used);
    tool.pointer(at(Kind::Drag, 0, 300));
    tool.pointer(at(Kind::Release, 0, 300));
    QVERIFY(std::abs(fixture.document().joints()[0] - 0.5 * kPi) < 1e-6);
    QVERIFY(!fixture.selection.body());
    CellTool nothing = fixture.tool("");
    QCOMPARE(nothing.pointer(at(Kind::Press, 0, 0)), ToolReply::Ignored);  // the camera's
  }

  void deleting() {
    CellFixture fixture;
    CellTool tool = fixture.tool("body.1");
    QCOMPARE(tool.perform("delete"), ToolReply::Ignored);  // nothing is selected
    fixture.selection.select(1);
    QCOMPARE(tool.perform("delete"), ToolReply::Used);
    tool.documentChanged();
    QVERIFY(fixture.document().bodies().empty() && !fixture.selection.body());
    fixture.document().history()->undo();
    QCOMPARE(fixture.position(), Vec3(0, 500, 0));
  }

  // The scene has an end.
  void nothingGoesTooFar() {
    CellFixture fixture;
    CellTool tool = fixture.tool("body.1");
    tool.pointer(at(Kind::Press, 0, 500));
    tool.pointer(at(Kind::Drag, 1e9, 500));
    tool.pointer(at(Kind::Release, 1e9, 500));
    QVERIFY(isRigid(fixture.document().bodies().withId(1)->pose));
  }

  void changesEndADrag() {
    CellFixture fixture;
    CellTool tool = fixture.tool("body.1");
    tool.pointer(at(Kind::Press, 0, 500));
    tool.pointer(at(Kind::Drag, 50, 500));
    fixture.document().history()->undo();
    tool.documentChanged();
    QVERIFY(!fixture.selection.body() && !tool.preview().replaced);
    tool.pointer(at(Kind::Release, 50, 500));
    QVERIFY(fixture.document().bodies().empty());
  }
};

HANDWHEEL_TEST(CellToolTest)
#include "CellToolTest.moc"
