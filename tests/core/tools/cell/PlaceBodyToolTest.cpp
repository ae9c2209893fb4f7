// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/PlaceBodyTool.h"

#include "ArmCell.h"
#include "TestClass.h"
#include "ToolEvents.h"
#include "document/cell/BodyCarriers.h"
#include "document/cell/CellDisplay.h"
#include "document/cell/CellFrames.h"
#include "document/cell/RobotChanges.h"
#include "robot/Kinematics.h"
#include "robot/dh/DhTable.h"

#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kPixel = 1.0;  // mm: an arrow is 110 mm long

// A pointer event straight down, through a point on the plane z = 0.
PointerEvent down(Kind kind, double x, double y, Modifiers modifiers = kControl) {
  PointerEvent event = above(kind, x, y, modifiers);
  event.pixel = kPixel;
  return event;
}

PointerEvent ofDevice(Kind kind, const Pose& pose) {
  PointerEvent event;
  event.kind = kind;
  event.button = kind == Kind::Hover ? PointerButton::None : PointerButton::First;
  event.ray = {pose.translation(), -pose.linear().col(2)};
  event.device = pose;
  event.pixel = kPixel;
  return event;
}

Pose moved(const Pose& pose, const Vec3& displacement) {
  return Eigen::Translation3d(displacement) * pose;
}

}  // namespace

// A body is placed by its handles: a box of 20 mm at x 500, y 100.
class PlaceBodyToolTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    m_cell = std::make_unique<ArmCell>();
    m_box = m_cell->addBox({20, 20, 20}, {500, 100, 0}, {0, 0, 0.4});
    m_selection.select(m_box);
    m_picked.clear();
    m_robot.reset();
    m_frame.clear();
    m_steps = m_cell->steps();
  }

  // Dragged by the arrow it goes along the axis only, however the mouse goes; one step, undone.
  void anArrow() {
    PlaceBodyTool tool = make();
    const Pose before = pose();
    tool.pointer(down(Kind::Hover, 560, 100));
    QCOMPARE(tool.pointer(down(Kind::Press, 560, 101)), ToolReply::Used);
    tool.pointer(down(Kind::Drag, 570, 130));
    tool.pointer(down(Kind::Drag, 583, 160));
    QVERIFY(tool.preview().replaced);
    QCOMPARE(tool.preview().label->figures.front().prefix, std::string("X"));
    QVERIFY(std::abs(tool.preview().label->figures.front().value - 23.0) < 1e-9);
    QCOMPARE(m_cell->steps(), m_steps);
    tool.pointer(down(Kind::Release, 583, 160));
    QCOMPARE(m_cell->steps(), m_steps + 1);
    QVERIFY(pose().isApprox(moved(before, {23, 0, 0}), 1e-12));
    m_cell->document().history()->undo();
    QVERIFY(pose().matrix() == before.matrix());
  }

  // A selected frame goes along the arrow, too, whatever carries it, and stays on that; one step, undone.
  void aFrame() {
    const CellRobot& robots = m_cell->document().robot();
    const std::string flange = robots.model.links[robots.arms[0].flange].name;
    const Pose before = poseOf({300.0, -200.0, 0.0}, {0.0, 0.0, 0.3});
    for (const NamedFrame& carried :
         {NamedFrame{"F"}, NamedFrame{.name = "F", .body = m_box}, NamedFrame{.name = "F", .link = flange}}) {
      CellPlans plans;
      plans.frames = {frameAt(carried, before, m_cell->document().placement())};
      m_cell->plan(plans);
      m_frame = "F";
      const auto frame = [&] { return *m_cell->document().plans()->frame("F"); };
      const auto framePose = [&] { return *poseOfFrame(frame(), m_cell->document().placement()); };
      const NamedFrame kept = frame();
      const int steps = m_cell->steps();
      PlaceBodyTool tool = make();
      tool.pointer(down(Kind::Hover, 0, 0));  // the arrows get their length
      QCOMPARE(tool.pointer(down(Kind::Press, 360, -200)), ToolReply::Used);
      tool.pointer(down(Kind::Drag, 370, -180));
      QVERIFY(!tool.preview().replaced);  // the cell stays as it is
      tool.pointer(down(Kind::Release, 383, -150));
      QCOMPARE(m_cell->steps(), steps + 1);
      QVERIFY(framePose().isApprox(moved(before, {23, 0, 0}), 1e-9));
      QVERIFY(frame().body == kept.body && frame().link == kept.link);
      m_cell->document().history()->undo();
      QVERIFY(frame() == kept);
      // The typed turn is about its own origin.
      tool.setSetting("turn_z", 0.5);
      QCOMPARE(tool.perform("commit"), ToolReply::Used);
      QVERIFY(framePose().isApprox(poseOf({300.0, -200.0, 0.0}, {0.0, 0.0, 0.8}), 1e-9));
      m_cell->document().history()->undo();
    }
    m_frame = "none of this name";
    QVERIFY(make().handles());  // those of the body
  }

  // A pose that is too far from its carrier to be read again is refused.
  void aFrameTooFar() {
    const BodyId far = m_cell->addBox({20, 20, 20}, {9e6, 0.0, 0.0});
    CellPlans plans;
    plans.frames = {{"F", poseOf({-5e6, 0.0, 0.0}, Vec3::Zero()), far}};
    m_cell->plan(plans);
    m_frame = "F";
    const int steps = m_cell->steps();
    PlaceBodyTool tool = make();
    tool.setSetting("move_x", -1e7);
    QCOMPARE(tool.perform("commit"), ToolReply::Used);
    QCOMPARE(m_cell->steps(), steps);
    tool.setSetting("move_x", 1e6);
    QCOMPARE(tool.perform("commit"), ToolReply::Used);
    QCOMPARE(m_cell->steps(), steps + 1);
  }

  // By a ring it turns about its middle.
  void aRing() {
    PlaceBodyTool tool = make();
    const Pose before = pose();
    tool.pointer(down(Kind::Hover, 0, 0));  // the arrows get their length
    const double radius = tool.handles()->ringRadius(), angle = 0.9;
    // Away from where rings cross.
    const auto at = [&](double turn) { return Vec3(500 + radius * std::cos(turn), 100 + radius * std::sin(turn), 0); };
    tool.pointer(down(Kind::Press, at(0.7).x(), at(0.7).y()));
    tool.pointer(down(Kind::Drag, at(1.2).x(), at(1.2).y()));
    tool.pointer(down(Kind::Release, at(0.7 + angle).x(), at(0.7 + angle).y()));
    QCOMPARE(m_cell->steps(), m_steps + 1);
    QVERIFY((pose().translation() - before.translation()).norm() < 1e-9);
    const Eigen::AngleAxisd turned(Eigen::Matrix3d(pose().linear() * before.linear().transpose()));
    QVERIFY(std::abs(turned.angle() - angle) < 1e-9);
    QVERIFY(turned.axis().isApprox(Vec3::UnitZ(), 1e-9));
  }

  // Without Ctrl a turn is in steps of 5°, and a displacement in steps that fit the zoom.
  void snapping() {
    PlaceBodyTool tool = make();
    tool.pointer(down(Kind::Hover, 0, 0, kNoModifiers));
    tool.pointer(down(Kind::Press, 560, 100, kNoModifiers));
    tool.pointer(down(Kind::Release, 583.3, 100, kNoModifiers));
    QVERIFY(std::abs(pose().translation().x() - 525.0) < 1e-9);  // 4 pixels of 1 mm: steps of 5 mm
    const double radius = tool.handles()->ringRadius();
    const Pose before = pose();
    tool.pointer(down(Kind::Press, 525 + radius * std::cos(0.7), 100 + radius * std::sin(0.7), kNoModifiers));
    tool.pointer(down(Kind::Release, 525 + radius * std::cos(0.9), 100 + radius * std::sin(0.9), kNoModifiers));
    const Eigen::AngleAxisd turned(Eigen::Matrix3d(pose().linear() * before.linear().transpose()));
    QVERIFY(std::abs(turned.angle() - 10.0 * kRadiansPerDegree) < 1e-9);
  }

  void aClickMovesNothing() {
    PlaceBodyTool tool = make();
    tool.pointer(down(Kind::Hover, 560, 100));
    tool.pointer(down(Kind::Press, 560, 100));
    tool.pointer(down(Kind::Release, 560, 100));
    QCOMPARE(m_cell->steps(), m_steps);
    tool.pointer(down(Kind::Press, 560, 100));
    tool.pointer(down(Kind::Drag, 600, 100));
    QCOMPARE(tool.perform("revert"), ToolReply::Used);
    QCOMPARE(m_cell->steps(), m_steps);
    QVERIFY(!tool.preview().replaced);
    QCOMPARE(tool.perform("revert"), ToolReply::Finished);
  }

  // A click on another body takes that; one beside everything is the camera's.
  void selects() {
    const BodyId other = m_cell->addBox({20, 20, 20}, {0, 600, 0});
    PlaceBodyTool tool = make();
    m_picked = "body." + std::to_string(other);
    tool.pointer(down(Kind::Hover, 0, 600));
    QCOMPARE(tool.pointer(down(Kind::Press, 5, 600)), ToolReply::Used);
    QCOMPARE(m_selection.body(), std::optional(other));
    const int steps = m_cell->steps();
    tool.pointer(down(Kind::Release, 5, 600));
    QCOMPARE(m_cell->steps(), steps);
    m_picked.clear();
    QCOMPARE(tool.pointer(down(Kind::Press, -900, -900)), ToolReply::Ignored);
  }

  // Numbers: shown, then committed as one step; along the body's own axes if that is chosen.
  void numbers() {
    PlaceBodyTool tool = make();
    const Pose before = pose();
    QVERIFY(!isEnabled(tool, "commit"));
    tool.setSetting("frame", 1.0);
    tool.setSetting("move_x", 30.0);
    tool.setSetting("turn_z", 0.5);
    QVERIFY(tool.preview().replaced && isEnabled(tool, "commit"));
    QCOMPARE(m_cell->steps(), m_steps);
    tool.perform("commit");
    QCOMPARE(m_cell->steps(), m_steps + 1);
    const Pose wanted = before * Pose(Eigen::Translation3d(30.0, 0, 0) * Eigen::AngleAxisd(0.5, Vec3::UnitZ()));
    QVERIFY(pose().isApprox(wanted, 1e-12));
    QCOMPARE(std::get<double>(propertyNamed(tool.settings(), "move_x")->value), 0.0);
  }

  // A body that the robot carries is placed where it is seen, and stays on its link.
  void onTheRobot() {
    const RobotModel& robot = m_cell->document().robot().model;
    m_cell->stand({0.3, 0.4, 0.2, 0.5, 0.8, -0.3});
    auto edit = carryEdit(m_cell->document().bodies(), {m_box}, toolLink(robot), robot, m_cell->document().joints());
    m_cell->document().commit("Carry", std::move(edit).value());
    PlaceBodyTool tool = make();
    const Pose before = poseInBase();
    tool.pointer(down(Kind::Hover, 560, 100));
    tool.pointer(down(Kind::Press, 560, 100));
    tool.pointer(down(Kind::Release, 577, 100));
    QVERIFY(poseInBase().isApprox(moved(before, {17, 0, 0}), 1e-9));
    QVERIFY(!m_cell->document().bodies().withId(m_box)->carrier.empty());
  }

  // A device holds an arrow: only what goes along it counts. It holds the body: that moves and turns as the hand does.
  void byTheDevice() {
    PlaceBodyTool tool = make();
    const Pose before = pose();
    tool.pointer(down(Kind::Hover, 0, 0));
    const Pose tip(Eigen::Translation3d(560, 100, 3));
    QCOMPARE(tool.pointer(ofDevice(Kind::Press, tip)), ToolReply::Used);
    tool.pointer(ofDevice(Kind::Release, moved(tip, {12.5, 40, -8})));
    QVERIFY(pose().isApprox(moved(before, {12.5, 0, 0}), 1e-12));
    m_picked = "body." + std::to_string(m_box);
    const Pose hand(Eigen::Translation3d(508, 96, -9.5));
    const Pose motion = poseOf({5, -3, 20}, {0.2, 0.1, -0.4});
    const Pose now = pose();
    QCOMPARE(tool.pointer(ofDevice(Kind::Press, hand)), ToolReply::Used);
    tool.pointer(ofDevice(Kind::Drag, motion * hand));
    tool.pointer(ofDevice(Kind::Release, motion * hand));
    QVERIFY(pose().isApprox(motion * now, 1e-9));
  }

  // A device turns a ring as far as its hand goes round the axis, also further than half round; shown meanwhile.
  void aRingByTheDevice() {
    PlaceBodyTool tool = make();
    const Pose before = pose();
    tool.pointer(down(Kind::Hover, 0, 0));  // the rings get their size
    const double radius = tool.handles()->ringRadius();
    const auto hand = [&](double turn) {
      return Pose(Eigen::Translation3d(500 + radius * std::cos(turn), 100 + radius * std::sin(turn), 0.0));
    };
    const auto shown = [&] { return std::get<double>(propertyNamed(tool.settings(), "turn_z")->value); };
    tool.pointer(ofDevice(Kind::Hover, hand(0.7)));
    tool.pointer(ofDevice(Kind::Press, hand(0.7)));
    for (const double turn : {1.0, 2.0, 3.0, 4.0}) {
      tool.pointer(ofDevice(Kind::Drag, hand(0.7 + turn)));
      QVERIFY(std::abs(shown() - std::remainder(turn, 2.0 * M_PI)) < 1e-9);
    }
    tool.pointer(ofDevice(Kind::Drag, Pose(Eigen::Translation3d(500, 100, 40))));  // on the axis: no turn can be known
    tool.pointer(ofDevice(Kind::Release, hand(0.7 + 4.0)));
    QCOMPARE(m_cell->steps(), m_steps + 1);
    QVERIFY((pose().translation() - before.translation()).norm() < 1e-9);
    QVERIFY(pose().linear().isApprox(Eigen::AngleAxisd(4.0, Vec3::UnitZ()) * before.linear(), 1e-9));
  }

  // The handle under the pointer is marked, until it leaves; a changed document ends a drag and discards typed numbers.
  void leftAndChanged() {
    PlaceBodyTool tool = make();
    tool.pointer(down(Kind::Hover, -900, -900));
    const std::size_t plain = tool.preview().lines.size();
    tool.pointer(down(Kind::Hover, 560, 100));
    QVERIFY(tool.preview().lines.size() > plain);
    tool.pointer(down(Kind::Leave, 560, 100));
    QCOMPARE(tool.preview().lines.size(), plain);
    tool.pointer(ofDevice(Kind::Hover, Pose(Eigen::Translation3d(560, 100, 3))));
    QVERIFY(tool.preview().lines.size() > plain);
    tool.setSetting("turn_x", 0.5);
    tool.pointer(down(Kind::Press, 560, 100));
    tool.pointer(down(Kind::Drag, 580, 100));
    tool.documentChanged();
    QVERIFY(!tool.preview().replaced && tool.preview().lines.size() == plain);
    QCOMPARE(std::get<double>(propertyNamed(tool.settings(), "turn_x")->value), 0.0);
    QCOMPARE(tool.pointer(down(Kind::Release, 580, 100)), ToolReply::Ignored);
    for (const ToolKey& key : PlaceBodyTool::keys()) QVERIFY(actionNamed(tool.actions(), key.action));
  }

  // Dragged by any of its links another robot goes over the floor as the pointer does, its joints as they are; one
  // step. The first one stays.
  void aRobotByALink() {
    auto changed = withRobotAdded(m_cell->content(),
                                  {cellOf(*libraryTable("ur5")), "", poseOf({500.0, 100.0, 0.0}, Vec3(0.0, 0.0, 0.5))});
    m_cell->document().commit("Add", m_cell->document().robotsEdit(std::move(changed).value()));
    m_selection.clear();
    const int steps = m_cell->steps();
    PlaceBodyTool tool = make();
    const CellRobot& robots = m_cell->document().robot();
    const auto drag = [&](std::uint32_t link) {
      m_picked = robots.model.links[link].name + "/0";
      tool.pointer(down(Kind::Press, 300, 0));
      tool.pointer(down(Kind::Drag, 310, 0));
      tool.pointer(down(Kind::Release, 340, -30));
    };
    const Pose first = base(0), before = base(1);
    const JointValues joints = m_cell->document().joints();
    drag(robots.arms[0].flange);
    QCOMPARE(m_cell->steps(), steps);
    drag(robots.arms[1].flange);
    QCOMPARE(m_cell->steps(), steps + 1);
    QVERIFY(base(1).isApprox(moved(before, {40, -30, 0}), 1e-9));
    QVERIFY(base(0).matrix() == first.matrix() && m_cell->document().joints() == joints);
    drag(robots.model.joints[robots.model.links[robots.arms[1].flange].parentJoint].parent);
    QVERIFY(base(1).isApprox(moved(before, {80, -60, 0}), 1e-9));
    m_cell->document().history()->undo();
    m_cell->document().history()->undo();
    QVERIFY(base(1).matrix() == before.matrix());
  }

  // The base of another robot, pressed to select it, goes by its arrow and ring; its links are seen there before, and
  // each is one step. The first one, which all is measured from, has no handles.
  void aRobot() {
    auto changed = withRobotAdded(m_cell->content(),
                                  {cellOf(*libraryTable("ur5")), "", poseOf({500.0, 100.0, 0.0}, Vec3(0.0, 0.0, 0.5))});
    m_cell->document().commit("Add", m_cell->document().robotsEdit(std::move(changed).value()));
    m_selection.clear();
    const int steps = m_cell->steps();
    PlaceBodyTool tool = make();
    const CellRobot& robots = m_cell->document().robot();
    m_picked = robots.model.links[robots.arms[0].base].name + "/0";
    QCOMPARE(tool.pointer(down(Kind::Press, 0, 0)), ToolReply::Used);
    QVERIFY(m_robot == std::size_t(0) && !tool.handles());
    m_picked = robots.model.links[robots.arms[1].base].name + "/0";
    QCOMPARE(tool.pointer(down(Kind::Press, 500, 100)), ToolReply::Used);
    QVERIFY(m_robot == std::size_t(1) && tool.handles());
    tool.pointer(down(Kind::Release, 500, 100));
    m_picked.clear();
    const Pose before = base(1);
    const Vec3 tip = tipOf(1);
    tool.pointer(down(Kind::Hover, 560, 100));
    tool.pointer(down(Kind::Press, 560, 101));
    tool.pointer(down(Kind::Drag, 583, 160));
    const auto seen = tool.preview().replaced;
    QVERIFY(seen);
    for (const DisplayPart& part : seen->parts) {
      const std::uint32_t link = linkOfPart(m_cell->document().robot(), part.name);
      if (link == kNone) continue;
      const bool isOfIt = armsOfLinks(robots.model, robots.arms)[link] == 1;
      const auto shown = displayOf(m_cell->document().robot(), m_cell->document().joints()).parts;
      const auto still = std::ranges::find(shown, part.name, &DisplayPart::name);
      QVERIFY(part.pose.isApprox(moved(still->pose, {isOfIt ? 23.0 : 0.0, 0, 0}), 1e-9));
    }
    tool.pointer(down(Kind::Release, 583, 160));
    QCOMPARE(m_cell->steps(), steps + 1);
    QVERIFY(base(1).isApprox(moved(before, {23, 0, 0}), 1e-9));
    QVERIFY((tipOf(1) - tip - Vec3(23, 0, 0)).norm() < 1e-6);
    tool.setSetting("turn_z", 0.25);
    QCOMPARE(tool.perform("commit"), ToolReply::Used);
    QCOMPARE(m_cell->steps(), steps + 2);
    const Pose turned = moved(before, {23, 0, 0}) * Pose(Eigen::AngleAxisd(0.25, Vec3::UnitZ()));
    QVERIFY(base(1).isApprox(turned, 1e-9));
    for (int i = 0; i < 2; ++i) m_cell->document().history()->undo();
    QVERIFY(base(1).isApprox(before, 1e-12));
  }

 private:
  PlaceBodyTool make() {
    return PlaceBodyTool(m_cell->document(), m_selection,
                         {[this](const Ray& ray) -> std::optional<RobotCellPick> {
                            if (m_picked.empty()) return std::nullopt;
                            return RobotCellPick{m_picked, Vec3(ray.origin.x(), ray.origin.y(), 0)};
                          },
                          {},
                          [this] { return m_robot; },
                          [this](std::size_t robot) { m_robot = robot; },
                          {},
                          [this] { return m_frame; }});
  }
  Pose base(std::size_t robot) const {
    return basePose(m_cell->document().robot().model, m_cell->document().robot().arms[robot]);
  }
  Vec3 tipOf(std::size_t robot) const {
    const CellRobot& robots = m_cell->document().robot();
    return linkPoses(robots.model, m_cell->document().joints())[robots.arms[robot].flange].translation();
  }
  Pose pose() const { return m_cell->document().bodies().withId(m_box)->pose; }
  Pose poseInBase() const {
    const RobotModel& robot = m_cell->document().robot().model;
    return inFrameOfBase(m_cell->document().bodies(), robot, m_cell->document().joints()).withId(m_box)->pose;
  }

  std::unique_ptr<ArmCell> m_cell;
  BodySelection m_selection;
  BodyId m_box = 0;
  std::optional<std::size_t> m_robot;  // The selected robot
  std::string m_frame;                 // The selected frame
  std::string m_picked;
  int m_steps = 0;
};

HANDWHEEL_TEST(PlaceBodyToolTest)
#include "PlaceBodyToolTest.moc"
