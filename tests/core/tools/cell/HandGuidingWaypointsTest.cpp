// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "HandGuidingFixture.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// Pulls waypoints by hand.
class HandGuidingWaypointsTest : public QObject {
  Q_OBJECT

 private slots:
  // A waypoint is taken near the tool centre point at it, by a device or the mouse, and follows the hand: one step, in
  // which the robot does not move. The other waypoint stays, too.
  void aWaypointIsPulled() {
    HandGuidingFixture fixture;
    fixture.addTurn(-0.6);
    HandGuidingTool tool = fixture.tool();
    tool.setSetting("way", PropertyValue(2.0));
    for (const bool byDevice : {true, false}) {
      const Pose before = fixture.poseAt(1);
      const Vec3 at = before.translation() + Vec3(6.0, -4.0, 0.0), displacement(-20.0, 5.0, byDevice ? 10.0 : 0.0);
      const auto event = [&](Kind kind, const Vec3& waypoint) {
        return byDevice ? byHand(kind, moved(waypoint)) : above(kind, waypoint.x(), waypoint.y());
      };
      const int steps = fixture.steps();
      QCOMPARE(tool.pointer(event(Kind::Press, at)), ToolReply::Used);
      QVERIFY(tool.isLeading());
      QVERIFY(tool.joints().isApprox(fixture.waypoint(1).joints, 1e-12));  // Displayed joint values
      tool.pointer(event(Kind::Drag, at + 0.5 * displacement));
      QCOMPARE(fixture.steps(), steps);
      tool.pointer(event(Kind::Release, at + displacement));
      QCOMPARE(fixture.steps(), steps + 1);
      QVERIFY((fixture.poseAt(1).translation() - before.translation() - displacement).norm() < 0.05);
      QVERIFY((fixture.poseAt(1).linear() - before.linear()).norm() < 1e-3);
      QVERIFY(fixture.waypoint(0).joints == HandGuidingFixture::start());
      QVERIFY(fixture.document().joints() == HandGuidingFixture::start());
      fixture.document().history()->undo();
      tool.documentChanged();
      QVERIFY(fixture.poseAt(1).isApprox(before, 1e-12));
    }
  }

  // Planning again has to pass it, also if the path was planned along a curve, or the waypoint was made by a planner.
  void aPulledWaypointIsKept() {
    HandGuidingFixture fixture;
    fixture.addTurn(-0.6);
    CellPlans plans = *fixture.document().plans();
    plans.paths[0].process = PathProcess();
    plans.paths[0].waypoints[1].isCritical = false;
    fixture.document().commit("Change", fixture.document().plansEdit(plans));
    HandGuidingTool tool = fixture.tool();
    tool.setSetting("way", PropertyValue(2.0));
    const Vec3 at = fixture.poseAt(1).translation();
    tool.pointer(byHand(Kind::Press, moved(at)));
    tool.pointer(byHand(Kind::Release, moved(at - Vec3(5, 0, 0))));
    QVERIFY(fixture.waypoint(1).isCritical);
    QVERIFY(!fixture.document().plans()->paths[0].process);
  }

  // Beside all waypoints, at a click, with the second button, after a change below, and with nothing prepared.
  void nothingIsPulled() {
    HandGuidingFixture fixture;
    fixture.addTurn(-0.6);
    HandGuidingTool tool = fixture.tool();
    tool.setSetting("way", PropertyValue(2.0));
    const Vec3 at = fixture.poseAt(1).translation();
    const int steps = fixture.steps();
    QCOMPARE(tool.pointer(byHand(Kind::Press, moved(at + Vec3(0, 0, 15.1)))), ToolReply::Ignored);
    QVERIFY(!tool.isLeading());
    tool.pointer(byHand(Kind::Press, moved(at)));
    tool.pointer(byHand(Kind::Release, moved(at)));
    tool.pointer(byHand(Kind::Press, moved(at)));
    tool.pointer(byHand(Kind::Drag, moved(at - Vec3(9, 0, 0))));
    PointerEvent second = byHand(Kind::Press, moved(at - Vec3(9, 0, 0)));
    second.button = PointerButton::Second;
    tool.pointer(second);
    QVERIFY(!tool.isLeading());
    tool.pointer(byHand(Kind::Press, moved(at)));
    tool.documentChanged();
    QVERIFY(!tool.isLeading());
    QCOMPARE(fixture.steps(), steps);
    QCOMPARE(fixture.added, 0);
    fixture.isUnderWay = true;
    QCOMPARE(tool.pointer(byHand(Kind::Press, moved(at))), ToolReply::Ignored);
    tool.setSetting("way", PropertyValue(0.0));
    fixture.isUnderWay = false;
    tool.pointer(byHand(Kind::Hover, moved(at)));
    QVERIFY(tool.forces().empty());
  }

  // The nearest of two, and of the path that is chosen only.
  void theNearestWaypointIsPulled() {
    HandGuidingFixture fixture;
    fixture.addTurn(-0.02);  // some 6 mm
    CellPlans plans = *fixture.document().plans();
    plans.paths.push_back({"other", {{.joints = fixture.waypoint(1).joints}}});
    fixture.document().commit("Add", fixture.document().plansEdit(plans));
    HandGuidingTool tool = fixture.tool();
    tool.setSetting("way", PropertyValue(2.0));
    tool.setSetting("path", PropertyValue(1.0));
    const Pose first = fixture.poseAt(0), second = fixture.poseAt(1);
    const Vec3 at = 0.7 * second.translation() + 0.3 * first.translation();
    tool.pointer(byHand(Kind::Press, moved(at)));
    tool.pointer(byHand(Kind::Release, moved(at - Vec3(30, 0, 0))));
    QVERIFY(fixture.poseAt(0).isApprox(first, 1e-12));
    QVERIFY((fixture.poseAt(1).translation() - second.translation() + Vec3(30, 0, 0)).norm() < 0.05);
    QVERIFY(fixture.toolPose(fixture.document().plans()->path("other")->waypoints[0].joints).isApprox(second, 1e-12));
  }

  // However far the hand pulls, the waypoint stays before the wall.
  void noWaypointIsPulledIntoAWall() {
    HandGuidingFixture fixture;
    fixture.addTurn(-0.1);
    HandGuidingTool tool = fixture.tool();
    tool.setSetting("way", PropertyValue(2.0));
    const Vec3 at = fixture.poseAt(1).translation();
    tool.pointer(byHand(Kind::Press, moved(at)));
    for (int i = 1; i <= 30; ++i) tool.pointer(byHand(Kind::Drag, moved(at + Vec3(10.0 * i, 0, 0))));
    QVERIFY(!tool.forces().empty());
    tool.pointer(byHand(Kind::Release, moved(at + Vec3(300, 0, 0))));
    const double clearance = fixture.clearance(fixture.waypoint(1).joints);
    QVERIFY2(clearance > 0.0 && clearance < 5.0, qPrintable(QString::number(clearance)));
  }

  // Before the press a device is drawn to the waypoint, less so near the boundary of its range.
  void aWaypointDrawsTheDevice() {
    HandGuidingFixture fixture;
    fixture.addTurn(-0.6);
    HandGuidingTool tool = fixture.tool();
    tool.setSetting("way", PropertyValue(2.0));
    tool.setSetting("grasp", PropertyValue(20.0));
    const Vec3 at = fixture.poseAt(1).translation(), aside = Vec3(1, 2, -2) / 3.0;
    const auto pull = [&](double distance) {
      const Vec3 tip = at + distance * aside;
      tool.pointer(byHand(Kind::Hover, moved(tip)));
      const auto springs = tool.forces();
      return springs.empty() ? Vec3(Vec3::Zero()) : Vec3(springs[0].target - tip);
    };
    QVERIFY((pull(10.0) + 0.75 * 10.0 * aside).norm() < 1e-9);  // 1 - (10 / 20)²
    QVERIFY(pull(19.999).norm() < 0.01);
    QVERIFY(pull(0.0).norm() < 1e-9);
    QCOMPARE(pull(20.1), Vec3(Vec3::Zero()));
    QVERIFY(pull(std::nan("")).isZero(0.0));
    pull(5.0);
    QVERIFY(!tool.preview().lines.empty());
    PointerEvent left;
    left.kind = Kind::Leave;
    tool.pointer(left);
    QVERIFY(tool.forces().empty());
    pull(5.0);
    tool.setSetting("felt", PropertyValue(false));
    QVERIFY(tool.forces().empty());
    tool.setSetting("felt", PropertyValue(true));
    tool.pointer(above(Kind::Hover, at.x(), at.y()));  // by the mouse
    QVERIFY(tool.forces().empty());
  }
};

HANDWHEEL_TEST(HandGuidingWaypointsTest)
#include "HandGuidingWaypointsTest.moc"
