// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DragFixture.h"
#include "TestClass.h"
#include "robot/Kinematics.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

class JointDragToolTest : public QObject {
  Q_OBJECT

 private slots:
  void turnsByTheAngleOfThePointer();
  void stopsAtTheLimit();
  void slides();
  void wholeArm();
  void followersMoveWithTheirLeader();
  void continuousJoints();
  void anyDragKeepsTheLimits();
};

void JointDragToolTest::turnsByTheAngleOfThePointer() {
  Fixture fixture;
  JointDragTool tool(fixture.document(), fixture.picking("upper/0"));
  QCOMPARE(tool.pointer(at(Kind::Press, 300, 0)), ToolReply::Used);
  QVERIFY(tool.isDragging());
  for (double angle : {0.1, 0.5, 1.2}) {
    tool.pointer(at(Kind::Drag, 300 * std::cos(angle), 300 * std::sin(angle)));
    QVERIFY(std::abs(tool.joints()[0] - angle) < 1e-12);
    QCOMPARE(fixture.document().joints()[0], 0.0);  // not yet
  }
  tool.pointer(at(Kind::Release, 300 * std::cos(-0.7), 300 * std::sin(-0.7)));
  QVERIFY(!tool.isDragging());
  QVERIFY(std::abs(fixture.document().joints()[0] + 0.7) < 1e-12);
  QCOMPARE(fixture.document().history()->count(), 1);
  QCOMPARE(fixture.document().history()->undoText(), QString("Move shoulder"));
  // The second arm turns about its own axis, wherever the first one has brought it.
  const Vec3 elbow(400 * std::cos(-0.7), 400 * std::sin(-0.7), 0);
  JointDragTool second(fixture.document(), fixture.picking("lower/0"));
  const auto on = [&](double angle) { return Vec3(elbow + 200 * Vec3(std::cos(angle), std::sin(angle), 0)); };
  second.pointer(at(Kind::Press, on(-0.7).x(), on(-0.7).y()));
  second.pointer(at(Kind::Drag, on(0.8).x(), on(0.8).y()));
  QVERIFY(std::abs(second.joints()[1] - 1.5) < 1e-9);
  QVERIFY(std::abs(second.joints()[0] + 0.7) < 1e-12);
}

// Past the limit and back again: the arm waits until the pointer is back.
void JointDragToolTest::stopsAtTheLimit() {
  Fixture fixture;
  JointDragTool tool(fixture.document(), fixture.picking("upper/0"));
  tool.pointer(at(Kind::Press, 300, 0));
  const std::pair<double, double> kTravel[] = {{1.5, 1.5}, {2.5, 2.0}, {4.0, 2.0}, {5.5, 2.0}, {4.0, 2.0}, {1.0, 1.0}};
  for (const auto& [pointer, expected] : kTravel) {
    tool.pointer(at(Kind::Drag, 300 * std::cos(pointer), 300 * std::sin(pointer)));
    QVERIFY(std::abs(tool.joints()[0] - expected) < 1e-9);
  }
}

void JointDragToolTest::slides() {
  Fixture fixture;
  JointDragTool tool(fixture.document(), fixture.picking("sledge/0"));
  tool.pointer(at(Kind::Press, 900, 10));
  tool.pointer(at(Kind::Drag, 1050, -70));
  QVERIFY(std::abs(tool.joints()[2] - 150) < 1e-9);
  tool.pointer(at(Kind::Drag, 2000, 10));
  QCOMPARE(tool.joints()[2], 300.0);
  tool.pointer(at(Kind::Release, 100, 10));
  QCOMPARE(fixture.document().joints()[2], 0.0);
  QCOMPARE(fixture.document().history()->count(), 0);  // back where it was
}

// The point that one holds comes under the pointer.
void JointDragToolTest::wholeArm() {
  Fixture fixture;
  JointDragTool tool(fixture.document(), fixture.picking("lower/0"));
  QVERIFY(fixture.document().setProperty("joint.elbow", 0.5).hasValue());
  const RobotModel& robot = fixture.document().robot().model;
  const std::uint32_t lower = linkNamed(robot, "lower");
  const Vec3 tip = linkPoses(robot, fixture.document().joints())[lower] * Vec3(400, 0, 0);
  tool.pointer(at(Kind::Press, tip.x(), tip.y(), kShift));
  tool.pointer(at(Kind::Drag, 400, 450));
  const Vec3 moved = linkPoses(robot, tool.joints())[lower] * Vec3(400, 0, 0);
  QVERIFY((moved - Vec3(400, 450, 0)).norm() < 1e-3);
  QVERIFY(tool.joints()[0] != 0.0 && tool.joints()[1] != 0.5);
  tool.pointer(at(Kind::Release, 400, 450));
  QCOMPARE(fixture.document().history()->undoText(), QString("Pull the arm"));
  QCOMPARE(fixture.document().history()->count(), 2);
}

// The finger turns by what the elbow turns.
void JointDragToolTest::followersMoveWithTheirLeader() {
  Fixture fixture;
  JointDragTool tool(fixture.document(), fixture.picking("finger/0"));
  tool.pointer(at(Kind::Press, 500, 0));
  tool.pointer(at(Kind::Drag, 200 + 300 * std::cos(0.6), 300 * std::sin(0.6)));
  QCOMPARE(tool.joints()[0], 0.0);
  QVERIFY(std::abs(tool.joints()[1] - 0.6) < 1e-6);
}

void JointDragToolTest::continuousJoints() {
  Fixture fixture;
  JointDragTool tool(fixture.document(), fixture.picking("free/0"));
  tool.pointer(at(Kind::Press, -800, 0));
  for (double angle = 0.0; angle < 7.5; angle += 0.5)
    tool.pointer(at(Kind::Drag, -1000 + 200 * std::cos(angle), 200 * std::sin(angle)));
  tool.pointer(at(Kind::Release, -1000 + 200 * std::cos(7.5), 200 * std::sin(7.5)));
  const std::uint32_t dof = 3;
  QCOMPARE(fixture.document().robot().model.jointOfDof(dof).name, std::string("spin"));
  QVERIFY(std::abs(fixture.document().joints()[dof] - (7.5 - 2 * kPi)) < 1e-9);
  // A joint that a path has wound up stays wound up.
  const JointValues wound =
      fixture.document().joints() + JointValues::Unit(fixture.document().joints().size(), dof) * 4 * kPi;
  fixture.document().commit("Go", fixture.document().jointEdit(wound));
  QVERIFY(fixture.document().joints() == wound);
  tool.pointer(at(Kind::Press, -800, 0));
  tool.pointer(at(Kind::Drag, -1000, 200));
  tool.pointer(at(Kind::Release, -1000, 200));
  QVERIFY(std::abs(fixture.document().joints()[dof] - wound[dof] - kPi / 2) < 1e-9);
}

void JointDragToolTest::anyDragKeepsTheLimits() {
  QVERIFY(rc::check("limits", [] {
    Fixture fixture;
    const std::string parts[] = {"upper/0", "lower/0", "sledge/0", "finger/0", "free/0"};
    JointDragTool tool(fixture.document(), fixture.picking(parts[*rc::gen::inRange(0, 5)]));
    const auto coordinate = [] { return *rc::gen::inRange(-1500, 1501) / 1.0; };
    const double x = coordinate();
    tool.pointer(at(Kind::Press, x, coordinate(), *rc::gen::arbitrary<bool>() ? kShift : kNoModifiers));
    for (int i = *rc::gen::inRange(0, 6); i > 0; --i) {
      PointerEvent event = at(Kind::Drag, coordinate(), coordinate());
      event.ray.direction = Vec3(coordinate(), coordinate(), coordinate() - 1600).normalized();
      tool.pointer(event);
      RC_ASSERT(tool.joints().allFinite());
    }
    const RobotModel& robot = fixture.document().robot().model;
    const JointValues shown = withinLimits(robot, byShortestTurn(robot, fixture.document().joints(), tool.joints()));
    tool.perform("commit");
    RC_ASSERT(fixture.document().joints() == shown);
    RC_ASSERT(withinLimits(fixture.document().robot().model, shown) == shown);
    while (fixture.document().history()->canUndo()) fixture.document().history()->undo();
    RC_ASSERT(fixture.document().joints().isZero(0.0));
  }));
}

HANDWHEEL_TEST(JointDragToolTest)
#include "JointDragToolTest.moc"
