// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/PathCheck.h"

#include "../ArmCell.h"
#include "TestClass.h"
#include "document/cell/CellErrors.h"

#include <QTest>
#include <algorithm>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// The first joint turns between waypoints that are an eighth of a radian apart: exact in binary.
RobotPath turningPath(std::size_t count) {
  RobotPath path{"turn", {}};
  for (std::size_t i = 0; i < count; ++i) {
    JointValues joints = JointValues::Zero(6);
    joints[0] = 0.125 * static_cast<double>(i) - 0.5;
    joints[4] = 0.75;
    path.waypoints.push_back({.joints = joints, .blend = 4.0});
  }
  return path;
}

bool hasRemark(const RobotProgram& program, const std::string& remark) {
  return std::find(program.remarks.begin(), program.remarks.end(), remark) != program.remarks.end();
}

}  // namespace

// Remarks on a path before it is exported.
class PathCheckTest : public QObject {
  Q_OBJECT

 private slots:
  void whatIsNoPathOfThisRobot() {
    ArmCell cell;
    const auto errorOf = [&](const RobotPath& path) {
      const auto checked = checkPath(*cell.scene(), {}, path, {});
      return checked ? Error{} : checked.error();
    };
    QVERIFY(errorOf(turningPath(1)).code == CellError::PathTooShort);
    QCOMPARE(errorOf(turningPath(1)).arguments, std::vector<std::string>{"turn"});
    RobotPath foreign = turningPath(2);
    foreign.arm = "other";
    QVERIFY(errorOf(foreign).code == CellError::OfOtherArm);
    QCOMPARE(errorOf(foreign).arguments, (std::vector<std::string>{"turn", "other"}));
    JobState state;
    state.cancelled = true;
    const auto cancelled = checkPath(*cell.scene(), {}, turningPath(2), {}, Progress(state));
    QVERIFY(!cancelled && cancelled.error().code == ErrorCode::Cancelled);
  }

  // In the open a path is proven, and the tool is on a circle about the first axis.
  void inTheOpen() {
    ArmCell cell;
    const RobotPath path = turningPath(3);
    const auto checked = checkPath(*cell.scene(), {}, path, {});
    QVERIFY(checked && checked->isCertified());
    QVERIFY(std::abs(checked->metrics.length - 0.25) < 1e-9);
    const std::vector<Vec3> curve = toolCurve(*cell.scene(), {}, path);
    QVERIFY(curve.size() >= 10);
    for (const Vec3& at : curve) {
      QVERIFY(std::abs(std::hypot(at.x(), at.y()) - std::hypot(curve[0].x(), curve[0].y())) < 1e-9);
      QVERIFY(std::abs(at.z() - curve[0].z()) < 1e-9);
    }
    const double turned = std::atan2(curve.back().y(), curve.back().x()) - std::atan2(curve[0].y(), curve[0].x());
    QVERIFY(std::abs(turned - 0.25) < 1e-9);
  }

  // A line that the arm cannot follow ends the path there.
  void aLineThatStops() {
    ArmCell cell;
    RobotPath path = turningPath(2);
    path.waypoints[1].joints[0] = 2.5;
    path.waypoints[1].motion = ProgramMotion::Kind::Linear;
    path.waypoints.push_back(turningPath(1).waypoints[0]);
    const ResolvedPath resolvedPath = resolved(*cell.scene(), {}, path);
    QVERIFY(resolvedPath.stopsAt && *resolvedPath.stopsAt == 1);
    QVERIFY(resolvedPath.reached > 0.0 && resolvedPath.reached < 1.0);
    QVERIFY(std::all_of(resolvedPath.waypointOf.begin(), resolvedPath.waypointOf.end(),
                        [](std::size_t waypoint) { return waypoint == 1; }));
    QCOMPARE(resolvedPath.joints.size(), resolvedPath.waypointOf.size() + 1);
    const auto checked = checkPath(*cell.scene(), {}, path, {});
    QVERIFY(checked && !checked->isCertified());
  }

  // The first waypoint of a program is reached by a joint motion, wherever the robot is; blends are the proven ones.
  void motionsOfTheProgram() {
    ArmCell cell;
    RobotPath path = turningPath(3);
    path.waypoints[0].motion = path.waypoints[2].motion = ProgramMotion::Kind::Linear;
    path.waypoints[1].name = "middle";
    CheckedPath checked;
    checked.blends = {0.0, 1.5, 0.0};
    checked.clearance = 2.0;
    const RobotProgram program = programOf(*cell.scene(), {}, path, checked);
    QCOMPARE(program.name, std::string("turn"));
    QVERIFY(program.isBaseOfController && program.hasPlainShapes && program.remarks.empty());
    QVERIFY(program.clearance == 2.0);
    QCOMPARE(program.motions.size(), std::size_t{3});
    QVERIFY(program.motions[0].kind == ProgramMotion::Kind::Joint);
    QVERIFY(program.motions[2].kind == ProgramMotion::Kind::Linear);
    QCOMPARE(program.motions[1].blend, 1.5);
    QCOMPARE(program.motions[1].name, std::string("middle"));
    QVERIFY(program.motions[1].joints == path.waypoints[1].joints);
  }

  // Blends that are smaller than requested are one sentence.
  void remarksOnBlends() {
    const RobotPath path = turningPath(6);
    CheckedPath checked;
    checked.blends = {0.0, 4.0, 1.5, 0.0, 0.0, 0.0};
    QCOMPARE(stoppedBlends(path, checked), std::size_t{2});
    QCOMPARE(smallerBlends(path, checked).size(), std::size_t{1});
    QCOMPARE(smallerBlendsText(smallerBlends(path, checked)),
             std::string("Smaller blends than asked: 1, 1.5 mm in place of 4 mm at place 3. A blend has half of the "
                         "shorter motion beside it at most, and only where it is proven free."));
    // No range if all are alike.
    checked.blends.assign(27, 1.0);
    const std::string many = smallerBlendsText(smallerBlends(turningPath(27), checked));
    QVERIFY2(many.starts_with("Smaller blends than asked: 25, as 1 mm in place of 4 mm at place 2. "), many.c_str());
    checked.blends[3] = 2.0;
    const std::string range = smallerBlendsText(smallerBlends(turningPath(27), checked));
    QVERIFY2(range.starts_with("Smaller blends than asked: 25, from 1 mm in place of 4 mm at place 2 to 2 mm"),
             range.c_str());
  }

  // Pairs that were excluded from the proof, or changes since.
  void remarksOnTheProof() {
    ArmCell cell;
    const CellScene scene = *cell.scene();
    const RobotPath path = turningPath(2);
    CheckedPath checked;
    checked.blends.assign(2, 0.0);
    checked.notChecked = {{"link_2", "the table"}};
    checked.missing = {{"hand", "hand", "hand.stl", MissingShape::State::LeftOut, {}}};
    checked.robotsMoved = {"left"};
    checked.outdated = {
        .part = "block", .isBaseOther = true, .isToolOther = true, .targets = {"a"}, .configurations = {"home"}};
    const RobotProgram program = programOf(scene, {}, path, checked);
    QVERIFY(hasRemark(program, "Not checked: link_2 with the_table."));
    QVERIFY(hasRemark(program,
                      "Proven with the robot left where it stood at export: it has moved since the path was "
                      "made."));
    QVERIFY(hasRemark(program, "Shape not read: hand (hand_stl), left out of the proof."));
    QCOMPARE(std::count_if(program.remarks.begin(), program.remarks.end(),
                           [](const std::string& remark) { return remark.starts_with("Outdated: "); }),
             std::ptrdiff_t{5});
    for (const std::string& remark : program.remarks)
      QVERIFY(std::all_of(remark.begin(), remark.end(), [](char c) { return c >= ' ' && c <= '~'; }));
  }
};

HANDWHEEL_TEST(PathCheckTest)
#include "PathCheckTest.moc"
