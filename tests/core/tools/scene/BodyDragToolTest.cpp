// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/scene/BodyDragTool.h"

#include "../ToolEvents.h"
#include "../cell/ArmCell.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A pointer event from the side and above, at 45°, to a point.
PointerEvent aslantTo(Kind kind, const Vec3& point, Modifiers modifiers = kControl) {
  PointerEvent event = above(kind, 0.0, 0.0, modifiers);
  const Vec3 direction = Vec3(1.0, 0.0, -1.0).normalized();
  event.ray = {point - 1000.0 * direction, direction};
  return event;
}

}  // namespace

// Bodies are selected by a click and dragged: a box of 20 mm on the floor at x 500, y 100, picked on its top.
class BodyDragToolTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    m_cell = std::make_unique<ArmCell>();
    m_box = m_cell->addBox({20, 20, 20}, {500, 100, 10});
    m_picked = m_box;
    m_selection.clear();
    m_steps = m_cell->steps();
  }

  // Over the floor, by as much as the pointer goes there; shown before, one step, undone.
  void overTheFloor() {
    BodyDragTool tool = make();
    const Pose before = pose();
    QCOMPARE(tool.pointer(aslantTo(Kind::Press, kTop)), ToolReply::Used);
    QVERIFY(tool.isDragging() && !tool.moved() && tool.preview().parts.empty());
    QCOMPARE(m_selection.body(), std::optional(m_box));
    QCOMPARE(tool.pointer(aslantTo(Kind::Drag, kTop + Vec3(30, -20, 0))), ToolReply::Used);
    QCOMPARE(tool.preview().parts.size(), std::size_t{1});
    QVERIFY((tool.preview().parts[0].pose.translation() - Vec3(530, 80, 10)).norm() < 1e-9);
    QVERIFY(tool.moved() && pose().matrix() == before.matrix());
    const auto settings = tool.settings();
    QCOMPARE(settings.size(), std::size_t{3});
    for (const Property& each : settings) QVERIFY(!each.editable);
    QVERIFY(std::abs(std::get<double>(settings[0].value) - 530.0) < 1e-9);
    tool.pointer(aslantTo(Kind::Release, kTop + Vec3(35, -20, 0)));
    QCOMPARE(m_cell->steps(), m_steps + 1);
    QVERIFY((pose().translation() - Vec3(535, 80, 10)).norm() < 1e-9);
    QVERIFY(tool.settings().empty());
    m_cell->document().history()->undo();
    QVERIFY(pose().matrix() == before.matrix());
  }

  // With Shift only up and down.
  void upAndDown() {
    BodyDragTool tool = make();
    const Modifiers both{true, true, false};
    tool.pointer(aslantTo(Kind::Press, kTop, both));
    tool.pointer(aslantTo(Kind::Release, kTop + Vec3(0, 0, 25), both));
    QVERIFY((pose().translation() - Vec3(500, 100, 35)).norm() < 1e-9);
  }

  // A click selects and moves nothing; one beside the bodies is the camera's, as is one with another button.
  void clicks() {
    BodyDragTool tool = make();
    tool.pointer(aslantTo(Kind::Press, kTop));
    QCOMPARE(tool.pointer(aslantTo(Kind::Release, kTop)), ToolReply::Used);
    QCOMPARE(m_selection.body(), std::optional(m_box));
    QCOMPARE(m_cell->steps(), m_steps);
    PointerEvent second = aslantTo(Kind::Press, kTop);
    second.button = PointerButton::Second;
    QCOMPARE(tool.pointer(second), ToolReply::Ignored);
    for (const Kind kind : {Kind::Drag, Kind::Release, Kind::DoubleClick})
      QCOMPARE(tool.pointer(aslantTo(kind, kTop)), ToolReply::Ignored);
    for (const Kind kind : {Kind::Hover, Kind::Leave}) QCOMPARE(tool.pointer(aslantTo(kind, kTop)), ToolReply::Used);
    for (const auto& picked : {std::optional<BodyId>(), std::optional<BodyId>(m_box + 7)}) {
      m_picked = picked;
      QCOMPARE(tool.pointer(aslantTo(Kind::Press, kTop)), ToolReply::Ignored);
    }
    QVERIFY(!tool.isDragging());
  }

  // The move is cancelled first, by the key or the other button, then the selection, then the tool.
  void stepByStepBack() {
    BodyDragTool tool = make();
    PointerEvent other = aslantTo(Kind::Press, kTop);
    other.button = PointerButton::Second;
    tool.pointer(aslantTo(Kind::Press, kTop));
    tool.pointer(aslantTo(Kind::Drag, kTop + Vec3(30, 0, 0)));
    QCOMPARE(tool.pointer(other), ToolReply::Used);
    QVERIFY(!tool.isDragging());
    tool.pointer(aslantTo(Kind::Press, kTop));
    tool.pointer(aslantTo(Kind::Drag, kTop + Vec3(30, 0, 0)));
    QVERIFY(!isEnabled(tool, "delete") && isEnabled(tool, "revert"));
    QCOMPARE(tool.perform("delete"), ToolReply::Ignored);
    QCOMPARE(tool.perform("revert"), ToolReply::Used);
    QVERIFY(tool.preview().parts.empty() && m_cell->steps() == m_steps);
    QCOMPARE(actionNamed(tool.actions(), "revert")->effect, std::string("deselect the body"));
    QCOMPARE(tool.perform("revert"), ToolReply::Used);
    QVERIFY(m_selection.empty() && !isEnabled(tool, "revert"));
    QCOMPARE(tool.perform("revert"), ToolReply::Finished);
    QCOMPARE(tool.perform("commit"), ToolReply::Ignored);
  }

  // All that is selected is removed in one step, which says what it is.
  void removed() {
    BodyDragTool tool = make();
    QVERIFY(!isEnabled(tool, "delete"));
    QCOMPARE(tool.perform("delete"), ToolReply::Ignored);
    const BodyId other = m_cell->addBox({5, 5, 5}, {0, 500, 0});
    const BodySet& bodies = m_cell->document().bodies();
    QCOMPARE(removeBodiesText(bodies, {other}), QStringLiteral("Remove box2"));
    QVERIFY(removeBodiesText(bodies, {m_box, other}).contains(QLatin1Char('2')));
    m_selection.selectAll({m_box, other});
    QVERIFY(isEnabled(tool, "delete"));
    const int steps = m_cell->steps();
    QCOMPARE(tool.perform("delete"), ToolReply::Used);
    QVERIFY(m_cell->document().bodies().empty() && m_cell->steps() == steps + 1);
    // A removed body is neither selected nor dragged any further.
    tool.documentChanged();
    QVERIFY(m_selection.empty());
    m_cell->document().history()->undo();
    tool.pointer(aslantTo(Kind::Press, kTop));
    tool.documentChanged();
    QVERIFY(!tool.isDragging() && m_selection.body() == m_box);
  }

  // Each key is that of an action.
  void keys() {
    const BodyDragTool tool = make();
    const std::vector<ToolAction> actions = tool.actions();
    for (const ToolKey& key : BodyDragTool::keys()) {
      const ToolAction* const action = actionNamed(actions, key.action);
      QVERIFY(action && action->input == key.input);
    }
  }

 private:
  BodyDragTool make() {
    return BodyDragTool(m_cell->document(), m_selection, [this](const Ray&) {
      return m_picked ? std::optional(BodyPick{*m_picked, kTop}) : std::nullopt;
    });
  }
  Pose pose() const { return m_cell->document().bodies().withId(m_box)->pose; }

  const Vec3 kTop{503.0, 98.0, 20.0};
  std::unique_ptr<ArmCell> m_cell;
  BodySelection m_selection;
  BodyId m_box = 0;
  std::optional<BodyId> m_picked;
  int m_steps = 0;
};

HANDWHEEL_TEST(BodyDragToolTest)
#include "BodyDragToolTest.moc"
