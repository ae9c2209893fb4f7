// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/HandGuidingTool.h"

#include "HandGuidingFixture.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Turns the tool along the path of HandGuidingFixture::addTurn(), beside it by a wave of so many mm, with a device; a
// step is 20 ms.
void followTurn(HandGuidingFixture& fixture, HandGuidingTool& tool, double angle, double wave) {
  constexpr int kSteps = 50;
  const Pose begin = fixture.toolPose();
  const Pose hand = moved({7, 8, 9});
  tool.pointer(byHand(Kind::Press, hand));
  for (int i = 1; i <= kSteps; ++i) {
    fixture.time += 0.02;
    JointValues joints = HandGuidingFixture::start();
    joints[0] += angle * i / kSteps;
    Vec3 displacement = fixture.toolPose(joints).translation() - begin.translation();
    displacement.z() += wave * std::sin(M_PI * i / 5.0);
    tool.pointer(byHand(Kind::Drag, moved(hand.translation() + displacement)));
  }
  tool.pointer(byHand(
      Kind::Release,
      tool.toolPose() ? moved(hand.translation() + tool.toolPose()->translation() - begin.translation()) : hand));
}

}  // namespace

// Leads the tool of a robot by hand.
class HandGuidingToolTest : public QObject {
  Q_OBJECT

 private slots:
  // In the plane of the view, as far as the pointer: the tool keeps its turn, and undo brings the joints back.
  void theMouseMovesTheTool() {
    HandGuidingFixture fixture;
    HandGuidingTool tool = fixture.tool();
    const Pose before = fixture.toolPose();
    const Vec3 at = before.translation();
    const int steps = fixture.steps();
    QCOMPARE(tool.pointer(above(Kind::Press, at.x(), at.y())), ToolReply::Used);
    QVERIFY(tool.isLeading());
    tool.pointer(above(Kind::Drag, at.x() - 25.0, at.y() + 40.0));
    QVERIFY(tool.preview().replaced);
    QCOMPARE(fixture.steps(), steps);
    tool.pointer(above(Kind::Release, at.x() - 30.0, at.y() + 50.0));
    QVERIFY(!tool.isLeading());
    QCOMPARE(fixture.steps(), steps + 1);
    QVERIFY((fixture.toolPose().translation() - at - Vec3(-30.0, 50.0, 0.0)).norm() < 0.05);
    QVERIFY((fixture.toolPose().linear() - before.linear()).norm() < 1e-3);
    fixture.document().history()->undo();
    QVERIFY(fixture.document().joints() == HandGuidingFixture::start());
  }

  void aClickChangesNothing() {
    HandGuidingFixture fixture;
    HandGuidingTool tool = fixture.tool();
    const int steps = fixture.steps();
    tool.pointer(above(Kind::Press, 300, 50));
    tool.pointer(above(Kind::Release, 300, 50));
    QCOMPARE(fixture.steps(), steps);
    tool.pointer(above(Kind::Press, 300, 50));
    tool.pointer(above(Kind::Drag, 290, 50));
    QCOMPARE(tool.perform("revert"), ToolReply::Used);
    QCOMPARE(fixture.steps(), steps);
    QVERIFY(tool.joints() == HandGuidingFixture::start());
    QCOMPARE(tool.perform("revert"), ToolReply::Finished);
  }

  // With Shift the tool turns, and stays where it is.
  void shiftTurns() {
    HandGuidingFixture fixture;
    HandGuidingTool tool = fixture.tool();
    const Pose before = fixture.toolPose();
    tool.pointer(above(Kind::Press, 300, 50, kShift));
    tool.pointer(above(Kind::Drag, 300.4, 50, kShift));  // 40 pixels to the right: about the axis that points up there
    tool.pointer(above(Kind::Release, 300.4, 50, kShift));
    const Eigen::AngleAxisd turned(fixture.toolPose().linear() * before.linear().transpose());
    QVERIFY((fixture.toolPose().translation() - before.translation()).norm() < 0.05);
    QVERIFY(std::abs(turned.angle() - 0.2) < 1e-3);
    QVERIFY(std::abs(turned.axis().y()) > 0.999);
  }

  // However far the hand goes, the robot stays before the wall, and the settings say why.
  void neverThroughAWall() {
    HandGuidingFixture fixture;
    HandGuidingTool tool = fixture.tool();
    const Vec3 at = fixture.toolPose().translation();
    tool.pointer(above(Kind::Press, at.x(), at.y()));
    for (int i = 1; i <= 10; ++i) tool.pointer(above(Kind::Drag, at.x() + 30.0 * i, at.y()));
    const auto settings = tool.settings();
    const Property* behind = propertyNamed(settings, "behind");
    QVERIFY(behind && std::get<double>(behind->value) > 50.0);
    QCOMPARE(behind->problem, std::string("something is in the way"));
    tool.pointer(above(Kind::Release, at.x() + 300.0, at.y()));
    QVERIFY(fixture.clearance() > 0.0 && fixture.clearance() < 5.0);
  }

  // A device can start anywhere. It moves the tool by its own displacement times the scale, and turns it. No force acts
  // in free space.
  void aDeviceMovesAndTurns() {
    HandGuidingFixture fixture;
    HandGuidingTool tool = fixture.tool();
    tool.setSetting("scale", PropertyValue(2.0));
    const Pose before = fixture.toolPose();
    Pose hand = moved({50, 60, 70});
    hand.rotate(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
    const Pose grip = hand;
    tool.pointer(byHand(Kind::Press, hand));
    QVERIFY(tool.forces().empty());
    hand.translation() += Vec3(-10, 15, 5);
    hand.linear() = Eigen::AngleAxisd(0.3, Vec3::UnitZ()) * grip.linear();
    tool.pointer(byHand(Kind::Drag, hand));
    QCOMPARE(tool.forces().size(), std::size_t{1});
    QVERIFY((tool.forces()[0].target - hand.translation()).norm() < 0.05);
    QVERIFY(tool.forces()[0].turning > 0.0);
    QVERIFY(tool.forces()[0].turn.angularDistance(Eigen::Quaterniond(hand.linear())) < 1e-3);
    tool.pointer(byHand(Kind::Release, hand));
    QVERIFY((fixture.toolPose().translation() - before.translation() - Vec3(-20, 30, 10)).norm() < 0.05);
    const Eigen::AngleAxisd turned(fixture.toolPose().linear() * before.linear().transpose());
    QVERIFY(std::abs(turned.angle() - 0.3) < 1e-3 && turned.axis().z() > 0.999);
  }

  // If the robot is held back, the spring draws the hand back to the reachable pose.
  void aDeviceFeelsTheWall() {
    HandGuidingFixture fixture;
    HandGuidingTool tool = fixture.tool();
    Pose hand = moved({0, 0, 0});
    tool.pointer(byHand(Kind::Press, hand));
    for (int i = 1; i <= 30; ++i) tool.pointer(byHand(Kind::Drag, moved({10.0 * i, 0, 0})));
    const auto springs = tool.forces();
    QCOMPARE(springs.size(), std::size_t{1});
    const Vec3 pull = springs[0].stiffness * (springs[0].target - Vec3(300, 0, 0));
    QVERIFY(pull.x() < -5.0);
    tool.setSetting("felt", PropertyValue(false));
    QVERIFY(tool.forces().empty());
  }

  // The second button of a device adds a waypoint and goes on leading.
  void aDeviceAddsWaypoints() {
    HandGuidingFixture fixture;
    HandGuidingTool tool = fixture.tool();
    tool.pointer(byHand(Kind::Press, moved({0, 0, 0})));
    tool.pointer(byHand(Kind::Drag, moved({-10, 0, 0})));
    PointerEvent second = byHand(Kind::Press, moved({-10, 0, 0}));
    second.button = PointerButton::Second;
    const int steps = fixture.steps();
    tool.pointer(second);
    QCOMPARE(fixture.added, 1);
    QCOMPARE(fixture.steps(), steps + 1);  // Joint values of the waypoint
    QVERIFY(tool.isLeading());
  }

  // Joint by joint: 100 mm of the hand are half of a joint's range.
  // Whoever stores, saves or goes to another tool meanwhile has the robot where the hand has led it.
  void settlesWhereItIs() {
    HandGuidingFixture fixture;
    HandGuidingTool tool = fixture.tool();
    const Pose before = fixture.toolPose(), hand = moved({7, 8, 9});
    const int steps = fixture.steps();
    tool.settle();
    QCOMPARE(fixture.steps(), steps);  // nothing was led
    tool.pointer(byHand(Kind::Press, hand));
    tool.pointer(byHand(Kind::Drag, moved({7, 8, 29})));
    const Pose led = *tool.toolPose();
    QVERIFY((led.translation() - before.translation()).norm() > 15.0);
    tool.settle();
    QCOMPARE(fixture.steps(), steps + 1);
    QVERIFY((fixture.toolPose().translation() - led.translation()).norm() < 1e-6);
    QVERIFY(!tool.isLeading());
  }

  void jointByJoint() {
    HandGuidingFixture fixture;
    HandGuidingTool tool = fixture.tool();
    tool.setSetting("way", PropertyValue(1.0));
    tool.pointer(byHand(Kind::Press, moved({0, 0, 0})));
    tool.pointer(byHand(Kind::Release, moved({-10, 0, 0})));
    const double range = 330.0 / 180.0 * M_PI;  // Range of the first joint of an IRB 120
    QVERIFY(std::abs(fixture.document().joints()[0] - (0.2 - 0.1 * 0.5 * range)) < 1e-6);
    QVERIFY((fixture.document().joints().tail(5) - HandGuidingFixture::start().tail(5)).norm() < 1e-12);
  }

  // A change of the document ends the move: nothing of it stays.
  void anUndoInBetween() {
    HandGuidingFixture fixture;
    HandGuidingTool tool = fixture.tool();
    tool.pointer(above(Kind::Press, 300, 50));
    tool.pointer(above(Kind::Drag, 280, 50));
    fixture.document().history()->undo();
    tool.documentChanged();
    QVERIFY(!tool.isLeading());
    QCOMPARE(tool.pointer(above(Kind::Release, 280, 50)), ToolReply::Ignored);
    QVERIFY(fixture.document().joints() == HandGuidingFixture::start());
  }

  void whileTheCellIsPrepared() {
    HandGuidingFixture fixture;
    HandGuidingServices services;
    services.scene = [] { return std::shared_ptr<const CellScene>(); };
    HandGuidingTool tool(fixture.document(), std::move(services));
    QCOMPARE(tool.pointer(above(Kind::Press, 300, 50)), ToolReply::Ignored);
    QVERIFY(!isEnabled(tool, "place"));
    QVERIFY(tool.preview().lines.empty());
  }

  // A hand that waves by 6 mm beside a path: with the fixture the tool is nearer to it, by the cube of the share of the
  // snap distance; each try is kept with its help.
  void aPathIsFollowed() {
    HandGuidingFixture fixture;
    fixture.addTurn(-0.6);
    HandGuidingTool tool = fixture.tool();
    const auto settings = tool.settings();
    const Property* paths = propertyNamed(settings, "path");
    QVERIFY(paths && paths->choices.size() == 2);
    tool.setSetting("path", PropertyValue(1.0));
    for (const double snap : {0.0, 12.0}) {
      tool.setSetting("snap", PropertyValue(snap));
      followTurn(fixture, tool, -0.6, 6.0);
      fixture.document().history()->undo();
      tool.documentChanged();
    }
    QCOMPARE(fixture.trials.size(), std::size_t{2});
    QVERIFY(fixture.trials[0].help == HandGuidingTrial::Help::Force &&
            fixture.trials[1].help == HandGuidingTrial::Help::Fixture);
    QVERIFY(fixture.trials[0].figures.isComplete() && fixture.trials[1].figures.isComplete());
    // The largest value of the wave in steps of 36 degrees, and what becomes of it.
    const double largest = 6.0 * std::sin(0.4 * M_PI);
    QVERIFY(std::abs(fixture.trials[0].figures.most - largest) < 0.2);
    QVERIFY(std::abs(fixture.trials[1].figures.most - 12.0 * std::pow(largest / 12.0, 3.0)) < 0.2);
    QVERIFY(fixture.trials[1].figures.rms < 0.3 * fixture.trials[0].figures.rms);
    QVERIFY(std::abs(fixture.trials[0].figures.seconds - 1.0) < 0.1);
    const auto shown = tool.settings();
    QVERIFY(propertyNamed(shown, "try.1") && propertyNamed(shown, "try.2") && !propertyNamed(shown, "try.0"));
  }

  // A path that was chosen is followed also when the cell has been prepared anew since.
  void thePathOutlivesThePreparation() {
    HandGuidingFixture fixture;
    fixture.addTurn(-0.6);
    HandGuidingTool tool = fixture.tool();
    tool.setSetting("path", PropertyValue(1.0));
    fixture.isUnderWay = true;
    tool.documentChanged();
    fixture.isUnderWay = false;
    followTurn(fixture, tool, -0.6, 6.0);
    QCOMPARE(fixture.trials.size(), std::size_t{1});
  }

  // A hand that presses before the guide curve has been computed is drawn to it from then on.
  void theGuideComesWhileLeading() {
    HandGuidingFixture fixture;
    fixture.addTurn(-0.6);
    HandGuidingTool tool = fixture.tool();
    tool.setSetting("path", PropertyValue(1.0));
    tool.setSetting("snap", PropertyValue(12.0));
    fixture.guideComesAt = 0.01;  // after the press, which is at 0
    followTurn(fixture, tool, -0.6, 6.0);
    QCOMPARE(fixture.trials.size(), std::size_t{1});
    QVERIFY(fixture.trials[0].figures.isComplete());
    QVERIFY(std::abs(fixture.trials[0].figures.most - 12.0 * std::pow(0.5 * std::sin(0.4 * M_PI), 3.0)) < 0.2);
  }

  // NaN and leaps from a device.
  void anyHand() {
    HandGuidingFixture fixture;
    HandGuidingTool tool = fixture.tool();
    tool.pointer(byHand(Kind::Press, moved({0, 0, 0})));
    for (const double value : {std::nan(""), 1e300, -1e9, std::numeric_limits<double>::infinity(), 0.0}) {
      tool.pointer(byHand(Kind::Drag, moved({value, 0, value})));
      QVERIFY(tool.joints().allFinite());
      for (const DeviceSpring& spring : tool.forces()) QVERIFY(spring.target.allFinite());
    }
    tool.pointer(byHand(Kind::Release, moved({0, 0, 0})));
    QVERIFY(fixture.clearance() > 0.0);
  }
};

HANDWHEEL_TEST(HandGuidingToolTest)
#include "HandGuidingToolTest.moc"
